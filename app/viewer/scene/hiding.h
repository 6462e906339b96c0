/// Triangles that hide a decision from the eye: in front of its points. They are drawn as ghosts.
#pragma once

#include <span>
#include <vector>

#include "camera.h"
#include "draw_list.h"
#include "run/model.h"

namespace se::view {

/// The place of the points of a decision: a sphere about the pivot.
DecisionPlace decisionPlace(const Model& model, Index pivot, std::span<const Index> points);

/// Radius of the place in a view of `height` pixels.
float pixelRadius(const CameraMatrices& camera, const DecisionPlace& place, float height);

/// Whether a triangle outside of the place hides one of its points. O(triangles).
bool isHidden(const Model& model, std::span<const Triangle> triangles, const CameraMatrices& camera,
              const DecisionPlace& place);

}  // namespace se::view
