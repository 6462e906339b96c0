// Small pictures of the built-in scenes: at most 1500 of their points, seen from beside and above,
// scaled to a square, and in the order of depth, so that those in front are drawn last.
#include "start_page.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

namespace se::view {

namespace {

constexpr std::size_t kDots = 1500;

/// A point as seen from beside and above: to the right, up, toward the viewer.
struct Seen {
    Vec3 at;
    float facing = 0.0F;
};

/// The turn from the axes of the scene to those of the view.
glm::dmat3 viewTurn() {
    const double yaw = glm::radians(-60.0);
    const double pitch = glm::radians(42.0);
    const Vec3 toViewer(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                        std::sin(pitch));
    const Vec3 right = glm::normalize(glm::cross(Vec3(0, 0, 1), toViewer));
    return glm::transpose(glm::dmat3(right, glm::cross(toViewer, right), toViewer));
}

}  // namespace

std::vector<ThumbnailDot> thumbnail(const PointFile& points, std::size_t limit) {
    const glm::dmat3 turn = viewTurn();
    const std::size_t count = points.position.size();
    if (count == 0 || limit == 0) return {};
    const std::size_t stride = (count + limit - 1) / limit;
    std::vector<Seen> seen;
    glm::dvec2 low(INFINITY);
    glm::dvec2 high(-INFINITY);
    for (std::size_t p = 0; p < count; p += stride) {
        const Vec3 at = turn * points.position[p];
        if (!std::isfinite(at.x + at.y)) continue;
        low = glm::min(low, glm::dvec2(at));
        high = glm::max(high, glm::dvec2(at));
        const double facing = points.hasNormals() ? (turn * points.normal[p]).z : 1.0;
        seen.push_back({at, static_cast<float>(facing)});
    }
    std::stable_sort(seen.begin(), seen.end(),
                     [](const Seen& a, const Seen& b) { return a.at.z < b.at.z; });
    const glm::vec2 middle(0.5 * (low + high));
    const double half = 0.5 * std::max(high.x - low.x, high.y - low.y);
    const float scale = half > 0.0 ? static_cast<float>(1.0 / half) : 1.0F;
    std::vector<ThumbnailDot> dots;
    dots.reserve(seen.size());
    for (const Seen& each : seen)
        dots.push_back({(glm::vec2(each.at) - middle) * scale, each.facing});
    return dots;
}

void StartPage::prepare() {
    if (!tiles.empty()) return;
    std::vector<const Scene*> all;
    for (const Scene& scene : scenes()) all.push_back(&scene);
    for (const FailureScene& each : failureScenes()) all.push_back(&each.scene);
    for (const Scene* const each : all) {
        const Scene& scene = *each;
        SceneTile tile{scene.id, scene.title, scene.watch, thumbnail(scene.build(), kDots), {}};
        tile.reach = glm::vec2(0.0F);
        for (const ThumbnailDot& dot : tile.dots) {
            tile.reach = glm::max(tile.reach, glm::abs(dot.at));
        }
        tiles.push_back(std::move(tile));
    }
}

}  // namespace se::view
