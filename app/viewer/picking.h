/// Which point is under the pointer. Plain mathematics.
#pragma once

#include <span>

#include "camera.h"
#include "model.h"

namespace se::view {

/// The point nearest to the eye among those drawn within `radius` pixels of `pixel`; kNone if there
/// is none. Points that face the eye win over those that do not.
Index pickPoint(const Model& model, const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                float radius);

/// The same among some points.
Index pickAmong(const Model& model, std::span<const Index> points, const CameraMatrices& camera,
                glm::vec2 size, glm::vec2 pixel, float radius);

}  // namespace se::view
