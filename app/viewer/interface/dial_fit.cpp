// The bounds of disc and names grow with the radius, so the largest radius that fits is found by
// bisection; twelve halvings are finer than a pixel.
#include "dial_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

namespace se::view {

namespace {

/// Disc and names about the origin.
Rect boundsOf(float radius, std::span<const DialName> names, float gap, float margin) {
    glm::vec2 low(-radius - margin);
    glm::vec2 high(radius + margin);
    for (const DialName& name : names) {
        const float a = glm::radians(static_cast<float>(name.degrees));
        const glm::vec2 rim(radius * std::cos(a), -radius * std::sin(a));
        const glm::vec2 corner = nameCorner(rim, name, gap);
        low = glm::min(low, corner);
        high = glm::max(high, corner + name.extent);
    }
    return {low, high - low};
}

}  // namespace

glm::vec2 nameCorner(glm::vec2 rim, const DialName& name, float gap) {
    const float a = glm::radians(static_cast<float>(name.degrees));
    return {rim.x + gap * std::cos(a) + 0.5F * name.extent.x * (std::cos(a) - 1.0F),
            rim.y - gap * std::sin(a) - 0.5F * name.extent.y * (std::sin(a) + 1.0F)};
}

DialPlace fitDial(const Rect& room, std::span<const DialName> names, float gap, float margin) {
    float least = 0.0F;
    float most = 0.5F * std::min(room.size.x, room.size.y);
    // The bounds grow with the radius.
    for (int i = 0; i < 12; ++i) {
        const float radius = 0.5F * (least + most);
        const Rect bounds = boundsOf(radius, names, gap, margin);
        const bool fits = bounds.size.x <= room.size.x && bounds.size.y <= room.size.y;
        (fits ? least : most) = radius;
    }
    const Rect bounds = boundsOf(least, names, gap, margin);
    return {room.min + 0.5F * (room.size - bounds.size) - bounds.min, least};
}

}  // namespace se::view
