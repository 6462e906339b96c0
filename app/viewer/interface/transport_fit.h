/// The parts of the transport bar that fit.
#pragma once

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

/// The most important first: unit, speed, all units, loop.
inline TransportParts fitTransport(float room, const TransportWidths& w) {
    TransportParts parts;
    float rest = room - w.buttons - w.gap - w.goTo;
    const auto take = [&rest](float width) {
        if (rest < width) return false;
        rest -= width;
        return true;
    };
    parts.unit = take(w.unit + w.gap);
    parts.speed = parts.unit && take(w.speed + w.gap);
    parts.units = parts.speed && take(w.units - w.unit);
    parts.loop = parts.units && take(w.loop + w.gap);
    return parts;
}

}  // namespace se::view
