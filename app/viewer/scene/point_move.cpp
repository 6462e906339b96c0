#include "point_move.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace se::view {

namespace {

/// Sine of the least angle between the line of sight and what it is to meet.
constexpr float kLeastSine = 0.1F;

}  // namespace

std::optional<glm::vec3> placeInPlane(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                                      const glm::vec3& origin, const glm::vec3& normal) {
    const Ray sight = rayThrough(camera, size, pixel);
    const float sine = glm::dot(sight.way, normal);
    if (std::abs(sine) < kLeastSine) return std::nullopt;
    const float along = glm::dot(origin - sight.from, normal) / sine;
    if (along < 0.0F) return std::nullopt;
    return sight.at(along);
}

std::optional<glm::vec3> placeOnLine(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                                     const glm::vec3& origin, const glm::vec3& direction) {
    const Ray sight = rayThrough(camera, size, pixel);
    const float cosine = glm::dot(sight.way, direction);
    const float square = 1.0F - cosine * cosine;
    if (square < kLeastSine * kLeastSine) return std::nullopt;
    const glm::vec3 way = sight.from - origin;
    return origin +
           direction * ((glm::dot(way, direction) - glm::dot(way, sight.way) * cosine) / square);
}

double roundedTo(double value, double length) {
    assert(length > 0.0);
    // A division, since powers of ten below 1 are no doubles.
    const double steps = std::pow(10.0, std::ceil(4.0 - std::log10(length)));
    return std::round(value * steps) / steps;
}

}  // namespace se::view
