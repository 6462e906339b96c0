#include "lasso.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace se::view {

namespace {

/// A ray to the left crosses the line an odd number of times.
bool isWithin(std::span<const glm::vec2> path, glm::vec2 p) {
    bool within = false;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::vec2 a = path[i];
        const glm::vec2 b = path[(i + 1) % path.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) within = !within;
    }
    return within;
}

}  // namespace

std::vector<Index> pointsWithin(const Model& model, const CameraMatrices& camera, glm::vec2 size,
                                std::span<const glm::vec2> path) {
    std::vector<Index> points;
    if (path.size() < 3) return points;
    glm::vec2 low = path.front();
    glm::vec2 high = low;
    for (const glm::vec2& corner : path) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::mat4 toClip = camera.viewProjection();
    const glm::vec3 back(camera.view[0][2], camera.view[1][2], camera.view[2][2]);
    for (Index p = 0; p < model.place.size(); ++p) {
        if (!model.drawable[p]) continue;
        const glm::vec3& place = model.place[p];
        const glm::vec3 toEye = camera.orthographic ? back : camera.eye - place;
        const glm::vec4 clip = toClip * glm::vec4(place, 1.0F);
        if (clip.w <= 0.0F || glm::dot(toEye, model.normal[p]) < 0.0F) continue;
        const glm::vec2 pixel((0.5F * clip.x / clip.w + 0.5F) * size.x,
                              (0.5F - 0.5F * clip.y / clip.w) * size.y);
        const bool near =
            pixel.x >= low.x && pixel.x <= high.x && pixel.y >= low.y && pixel.y <= high.y;
        if (near && isWithin(path, pixel)) points.push_back(p);
    }
    return points;
}

}  // namespace se::view
