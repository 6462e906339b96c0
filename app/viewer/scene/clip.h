/// Convex polygons in a plane.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace se::view {

/// Intersection of `subject` and `window`. Both are convex and counterclockwise, and so is the
/// result; empty if they are disjoint. (Sutherland and Hodgman: one cut along each side of the
/// window.)
std::vector<glm::vec2> clipConvex(std::span<const glm::vec2> subject,
                                  std::span<const glm::vec2> window);

/// Positive if b lies to the left of a.
inline float crossOf(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }
/// Positive if counterclockwise.
float areaOf(std::span<const glm::vec2> polygon);

}  // namespace se::view
