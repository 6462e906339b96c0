/// Places for a point that is dragged on the screen. Plain mathematics.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "camera.h"

namespace se::view {

/// The place under `pixel`, in a view of `size` pixels, in the plane through `origin` with that
/// unit normal. Empty if the line of sight meets it nowhere before the eye, or at less than 6
/// degrees, where a pixel is a long way.
std::optional<glm::vec3> placeInPlane(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                                      const glm::vec3& origin, const glm::vec3& normal);

/// The place nearest to the line of sight of `pixel` on the line through `origin` with that unit
/// direction. Empty if the two are closer to parallel than 6 degrees.
std::optional<glm::vec3> placeOnLine(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                                     const glm::vec3& origin, const glm::vec3& direction);

/// `value` in steps of a power of ten of at most a ten-thousandth of `length`, so that a dragged
/// place is written with few digits. Requires length > 0.
double roundedTo(double value, double length);

}  // namespace se::view
