// Ghosts after Diepstraten, Weiskopf and Ertl 2002: only what hides is faded, all else stays
// opaque. A triangle hides if it meets the line of sight of one of the points; those that belong to
// the place itself never count, since they are what the decision is about.
#include "hiding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace se::view {

namespace {

/// Room around the farthest point, as a factor.
constexpr float kPlaceRoom = 1.1F;
/// A list of more triangles is not searched in every frame.
constexpr std::size_t kSearchedUpTo = 3'000'000;

/// The line from a point to the eye.
struct SightLine {
    glm::vec3 from{0.0F};
    glm::vec3 toEye{0.0F};  ///< Unit.
    float length = 0.0F;
};

glm::vec3 towardEye(const CameraMatrices& camera, const glm::vec3& place) {
    if (!camera.orthographic) return camera.eye - place;
    // Longer than the scene.
    return 10.0F * glm::vec3(camera.view[0][2], camera.view[1][2], camera.view[2][2]);
}

/// Whether the line meets the triangle at a place outside of the sphere (Moeller and Trumbore).
bool meetsOutside(const SightLine& sight, const std::array<glm::vec3, 3>& corners,
                  const DecisionPlace& place) {
    const glm::vec3 u = corners[1] - corners[0];
    const glm::vec3 v = corners[2] - corners[0];
    const glm::vec3 p = glm::cross(sight.toEye, v);
    const float det = glm::dot(u, p);
    if (det == 0.0F) return false;
    const glm::vec3 s = sight.from - corners[0];
    const float x = glm::dot(s, p) / det;
    const glm::vec3 q = glm::cross(s, u);
    const float y = glm::dot(sight.toEye, q) / det;
    if (x < 0.0F || y < 0.0F || x + y > 1.0F) return false;
    const float along = glm::dot(v, q) / det;
    return along > 0.0F && along < sight.length &&
           glm::distance(sight.from + along * sight.toEye, place.center) > place.radius;
}

}  // namespace

DecisionPlace decisionPlace(const Model& model, Index pivot, std::span<const Index> points) {
    DecisionPlace place;
    place.center = model.place[pivot];
    place.radius = model.spacing;
    place.points.reserve(points.size());
    for (const Index point : points) {
        place.radius =
            std::max(place.radius, kPlaceRoom * glm::distance(place.center, model.place[point]));
        place.points.push_back(model.place[point]);
    }
    return place;
}

float pixelRadius(const CameraMatrices& camera, const DecisionPlace& place, float height) {
    const float depth =
        camera.orthographic ? 1.0F : -(camera.view * glm::vec4(place.center, 1.0F)).z;
    return depth > 0.0F ? 0.5F * height * camera.projection[1][1] * place.radius / depth : 0.0F;
}

bool isHidden(const Model& model, std::span<const Triangle> triangles, const CameraMatrices& camera,
              const DecisionPlace& place) {
    if (triangles.size() > kSearchedUpTo) return true;
    std::vector<SightLine> sights;
    sights.reserve(place.points.size());
    for (const glm::vec3& point : place.points) {
        const glm::vec3 way = towardEye(camera, point);
        sights.push_back({point, glm::normalize(way), glm::length(way)});
    }
    const glm::vec3 axis = glm::normalize(towardEye(camera, place.center));
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        const std::array corners = {model.place[t.a], model.place[t.b], model.place[t.c]};
        const glm::vec3 offset = corners[0] - place.center;
        const glm::vec3 u = corners[1] - corners[0];
        const glm::vec3 v = corners[2] - corners[0];
        const float front = glm::dot(offset, axis);
        const float size = std::sqrt(std::max(glm::dot(u, u), glm::dot(v, v)));
        const float reach = place.radius + size;
        // Lines of sight come together toward the eye, so the place is the widest part.
        if (front + size < 0.0F || glm::dot(offset, offset) - front * front > reach * reach)
            return false;
        return std::any_of(sights.begin(), sights.end(), [&](const SightLine& sight) {
            return meetsOutside(sight, corners, place);
        });
    });
}

}  // namespace se::view
