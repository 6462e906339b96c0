/// The direction to something outside of the view. Plain arithmetic.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "scene/camera.h"

namespace se::view {

struct EdgeArrow {
    glm::vec2 at{0.0F};   ///< In pixels of the view, y down.
    glm::vec2 way{0.0F};  ///< Unit direction to the target.
};

/// Position of an arrow to `place` in a view of `size`, at `inset` from its edge. Empty if the
/// place is within the view, or the view too small for an arrow.
std::optional<EdgeArrow> edgeArrow(const CameraMatrices& camera, const glm::vec3& place,
                                   glm::vec2 size, float inset);

}  // namespace se::view
