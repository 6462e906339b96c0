/// The dial's disc and the names around its rim: the largest disc that leaves room for them, and
/// names side by side where two points are at nearly the same angle. Plain arithmetic, in pixels.
#pragma once

#include <cmath>
#include <glm/trigonometric.hpp>
#include <span>
#include <vector>

#include "panel_rects.h"

namespace se::view {

/// A name at the rim of the disc, outside of it.
struct DialName {
    double degrees = 0.0;  ///< Counterclockwise, 0 to the right.
    glm::vec2 extent{0.0F};
};

/// The disc: angle 0 to the right, counterclockwise.
struct DialCircle {
    glm::vec2 center{0.0F};
    float radius = 0.0F;

    /// The place at an angle, `reach` radii from the center.
    glm::vec2 at(double degrees, float reach = 1.0F) const {
        const float a = glm::radians(static_cast<float>(degrees));
        return center + reach * radius * glm::vec2(std::cos(a), -std::sin(a));
    }
};

/// Position of the near corner of a name, for a rim point: at `gap` from it, away from the center.
glm::vec2 nameCorner(glm::vec2 rim, const DialName& name, float gap);
/// `margin` is left free around the disc in any case.
DialCircle fitDial(const Rect& room, std::span<const DialName> names, float gap, float margin);

struct NameRoom {
    Rect area;                      ///< All names lie within it.
    std::span<const Rect> taken{};  ///< Areas covered by other overlays.
    float gap = 5.0F;               ///< From the rim to a name.
    float line = 14.0F;             ///< From the first row of names outward to the second.
};

struct PlacedName {
    std::size_t name = 0;  ///< Its position in the list of names.
    Rect rect;
    /// From the rim to the name, if the name is not right beside its point.
    bool leader = false;
};

/// Earlier names in the list get closer positions; a name without a free position nearby is left
/// out.
std::vector<PlacedName> placeNames(const DialCircle& disc, const NameRoom& room,
                                   std::span<const DialName> names);

}  // namespace se::view
