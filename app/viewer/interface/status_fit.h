/// The parts of the status bar that fit. Plain arithmetic.
#pragma once

#include <cstddef>
#include <span>

namespace se::view {

/// Number of `widths`, the most important first, that fit into `room` beside each other: whole, or
/// not at all. None is left out in favor of a later one.
inline std::size_t fittingParts(float room, std::span<const float> widths, float gap) {
    std::size_t count = 0;
    for (const float width : widths) {
        const float taken = width + (count > 0 ? gap : 0.0F);
        if (taken > room) break;
        room -= taken;
        ++count;
    }
    return count;
}

}  // namespace se::view
