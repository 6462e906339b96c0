/// The largest disc that leaves room for the names around it.
#pragma once

#include <span>

#include "layout.h"

namespace se::view {

/// A name at the rim of the disc, outside of it.
struct DialName {
    double degrees = 0.0;  ///< Counterclockwise, 0 to the right.
    glm::vec2 extent{0.0F};
};

struct DialPlace {
    glm::vec2 center{0.0F};
    float radius = 0.0F;
};

/// Position of the near corner of a name, for a rim point: at `gap` from it, away from the center.
glm::vec2 nameCorner(glm::vec2 rim, const DialName& name, float gap);
/// `margin` is left free around the disc in any case.
DialPlace fitDial(const Rect& room, std::span<const DialName> names, float gap, float margin);

}  // namespace se::view
