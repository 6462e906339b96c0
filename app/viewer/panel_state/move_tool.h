/// The drag of a point in the view, while the panel What if is open. Plain values.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "spiraling_edge/base/types.h"

namespace se::view {

struct MoveTool {
    int offeredIn = -1;      ///< The last frame in which the panel was drawn.
    Index pressed = kNone;   ///< The point under a press that is no drag yet.
    bool holds = false;      ///< A point is being dragged.
    glm::vec2 offset{0.0F};  ///< From the pointer to the point, in pixels.
    bool alongNormal = false;
    glm::vec3 anchor{0.0F};  ///< View space: where the point came into its present plane or line.
};

}  // namespace se::view
