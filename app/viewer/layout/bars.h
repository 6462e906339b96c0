/// The parts of the transport bar and of the status bar that fit. Plain arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace se::view {

/// In pixels. The buttons and the box with the address are always there.
struct TransportWidths {
    float buttons = 0.0F;
    float goTo = 0.0F;
    float unit = 0.0F;   ///< One button with the playback unit.
    float units = 0.0F;  ///< All unit buttons beside each other.
    float speed = 0.0F;
    float loop = 0.0F;
    float gap = 0.0F;
};

struct TransportParts {
    bool unit = false;
    bool units = false;  ///< Instead of the single button.
    bool speed = false;
    bool loop = false;
};

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

/// The most important first: unit, speed, all units, loop.
inline TransportParts fitTransport(float room, const TransportWidths& w) {
    const std::array widths = {w.unit + w.gap, w.speed + w.gap, w.units - w.unit, w.loop + w.gap};
    const std::size_t fits = fittingParts(room - w.buttons - w.gap - w.goTo, widths, 0.0F);
    return {fits > 0, fits > 2, fits > 1, fits > 3};
}

}  // namespace se::view
