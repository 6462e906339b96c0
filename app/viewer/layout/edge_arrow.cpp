#include "edge_arrow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace se::view {

std::optional<EdgeArrow> edgeArrow(const CameraMatrices& camera, const glm::vec3& place,
                                   glm::vec2 size, float inset) {
    const glm::vec2 half = 0.5F * size - glm::vec2(inset);
    if (!(half.x > 0.0F && half.y > 0.0F)) return std::nullopt;
    const glm::vec4 clip = camera.viewProjection() * glm::vec4(place, 1.0F);
    const bool inside = clip.w > 0.0F && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
    if (inside) return std::nullopt;
    // Not divided by w: a point behind the eye would appear on the wrong side.
    const glm::vec2 off(clip.x * size.x, -clip.y * size.y);
    const float length = glm::length(off);
    // Directly behind the eye every direction is equally good.
    const glm::vec2 way = length > 0.0F ? off / length : glm::vec2(0.0F, 1.0F);
    constexpr float kNever = std::numeric_limits<float>::max();
    const float reach = std::min(way.x != 0.0F ? half.x / std::abs(way.x) : kNever,
                                 way.y != 0.0F ? half.y / std::abs(way.y) : kNever);
    return EdgeArrow{0.5F * size + reach * way, way};
}

}  // namespace se::view
