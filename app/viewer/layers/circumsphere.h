#pragma once

#include <array>
#include <utility>
#include <vector>

#include "disc.h"

namespace se::view {

// Where the tested sphere touches things: the curve in which it cuts the mesh and the tangent
// disc.

/// The parts of a triangle's surface that lie on a sphere, as short segments.
std::vector<std::pair<glm::vec3, glm::vec3>> sphereCut(const Sphere& sphere,
                                                       const std::array<glm::vec3, 3>& corners);

}  // namespace se::view
