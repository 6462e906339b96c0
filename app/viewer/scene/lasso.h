/// Points inside a line drawn around them. Plain mathematics.
#pragma once

#include <span>
#include <vector>

#include "camera.h"
#include "run/model.h"

namespace se::view {

/// The points whose positions in a view of `size` pixels are inside the closed line through `path`,
/// and that face the eye; ascending. Where the line crosses itself, what is enclosed twice is
/// outside. A line of fewer than three corners encloses nothing.
std::vector<Index> pointsWithin(const Model& model, const CameraMatrices& camera, glm::vec2 size,
                                std::span<const glm::vec2> path);

}  // namespace se::view
