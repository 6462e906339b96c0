/// Which parts of the status bar there is room for. Plain arithmetic.
#pragma once

#include <cstddef>
#include <span>

namespace se::view {

/// How many of `widths`, the most important first, fit `room` beside each other: whole, or not at
/// all. None is left out for the sake of a later one.
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
