// No spatial index: a pick projects every point once, and reaches triangles through the points
// near the ray (mesh_index.h), O(points). The nearest candidates are then tested for being hidden
// by a ray to the eye. Which of point, edge and triangle wins depends on the size of the triangle
// on the screen, so that each has an area to click on.

#include "picking.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace se::view {

namespace {

/// Slack of a ray, so that it does not slip between two triangles.
constexpr float kRaySlack = 1e-3F;
/// Maximum number of points that are tested for being hidden.
constexpr std::size_t kPointsAsked = 8;

struct Hit {
    Triangle triangle;
    float distance = std::numeric_limits<float>::max();
};

/// Intersection of the ray with a triangle, or a little beyond its sides by `slack`, from either
/// side (Moeller and Trumbore).
std::optional<float> meet(const Ray& ray, const std::array<glm::vec3, 3>& corners, float slack) {
    const glm::vec3& a = corners[0];
    const glm::vec3 u = corners[1] - a;
    const glm::vec3 v = corners[2] - a;
    const glm::vec3 p = glm::cross(ray.way, v);
    const float det = glm::dot(u, p);
    if (det == 0.0F) return std::nullopt;
    const glm::vec3 s = ray.from - a;
    const float x = glm::dot(s, p) / det;
    const glm::vec3 q = glm::cross(s, u);
    const float y = glm::dot(ray.way, q) / det;
    if (x < -slack || y < -slack || x + y > 1.0F + 2.0F * slack) return std::nullopt;
    const float distance = glm::dot(v, q) / det;
    if (distance <= 0.0F) return std::nullopt;
    return distance;
}

float distanceToSegment(glm::vec2 p, glm::vec2 a, glm::vec2 b, float& share) {
    const glm::vec2 ab = b - a;
    const float length = glm::dot(ab, ab);
    share = length > 0.0F ? std::clamp(glm::dot(p - a, ab) / length, 0.0F, 1.0F) : 0.0F;
    return glm::distance(p, a + share * ab);
}

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

/// A point that is drawn near the pointer.
struct NearPoint {
    Index point;
    float pixels;
    float depth;
    bool faces;
};

/// An edge that is drawn near the pointer.
struct NearEdge {
    Selection edge;
    glm::vec3 place{0.0F};
    float pixels = std::numeric_limits<float>::max();
    float distance = std::numeric_limits<float>::max();  ///< From the eye.
};

class ScenePicker {
  public:
    ScenePicker(const PickScene& scene, const PickPoint& at)
        : scene_(scene),
          model_(scene.model),
          at_(at),
          project_(at.camera, at.size),
          ray_(rayThrough(at_.camera, at_.size, at.pixel)) {}

    Pick pick() const {
        const Hit front = firstHit(ray_, kNone);
        const bool any = front.distance < std::numeric_limits<float>::max();
        if (const Index point = nearPoint(any ? extentOf(front.triangle) : Extent{});
            point != kNone) {
            return {Selection::ofPoint(point), model_.place[point]};
        }
        const NearEdge edge = any ? edgeBefore(front) : edgeBesideAll();
        if (edge.edge.kind == SelectionKind::Edge) return {edge.edge, edge.place};
        if (any) return {Selection::ofTriangle(front.triangle), ray_.at(front.distance)};
        return {};
    }

  private:
    Ray rayTo(Index point) const {
        if (!at_.camera.orthographic) {
            return {at_.camera.eye, glm::normalize(model_.place[point] - at_.camera.eye)};
        }
        const glm::vec3 at = project_(model_.place[point]);
        return rayThrough(at_.camera, at_.size, glm::vec2(at));
    }

    /// Calls a function with each triangle that the ray may pass within `margin` of.
    template <typename Function>
    void forEachNear(const Ray& ray, float margin, Function&& function) const {
        if (scene_.index == nullptr) {
            for (const Triangle& t : scene_.triangles) function(t);
            return;
        }
        if (scene_.index->empty()) return;
        const auto count = static_cast<Index>(model_.place.size());
        for (Index p = 0; p < count; ++p) {
            const float reach = scene_.index->reach(p);
            if (reach == 0.0F) continue;
            const glm::vec3 across = glm::cross(model_.place[p] - ray.from, ray.way);
            const float far = reach + margin;
            if (glm::dot(across, across) > far * far) continue;
            scene_.index->forEachAt(p, [&](std::uint32_t t) {
                if (t < scene_.triangles.size() && scene_.triangles[t].a == p) {
                    function(scene_.triangles[t]);
                }
            });
        }
    }

    /// The first triangle along the ray, except those with the corner `without`.
    Hit firstHit(const Ray& ray, Index without) const {
        Hit first;
        forEachNear(ray, 0.0F, [&](const Triangle& t) {
            if (t.a == without || t.b == without || t.c == without) return;
            const std::optional<float> distance = meet(ray, model_.cornersOf(t), kRaySlack);
            if (distance && *distance < first.distance) first = {t, *distance};
        });
        return first;
    }

    bool hidden(Index point) const {
        const Ray ray = rayTo(point);
        const float distance = glm::dot(model_.place[point] - ray.from, ray.way);
        return firstHit(ray, point).distance < distance - kTowardEye * model_.spacing;
    }

    /// Size of a triangle on the screen, in pixels.
    struct Extent {
        float side = 0.0F;    ///< The shortest side.
        float height = 0.0F;  ///< The least height: small in slim triangles.
    };
    Extent extentOf(const Triangle& t) const {
        const glm::vec2 a(project_(model_.place[t.a]));
        const glm::vec2 b(project_(model_.place[t.b]));
        const glm::vec2 c(project_(model_.place[t.c]));
        const glm::vec2 u = b - a;
        const glm::vec2 v = c - a;
        const float doubleArea = std::abs(u.x * v.y - u.y * v.x);
        const auto [least, most] =
            std::minmax({glm::length(u), glm::length(v), glm::distance(b, c)});
        return {least, most > 0.0F ? doubleArea / most : 0.0F};
    }

    std::vector<NearPoint> pointsNear(float radius) const {
        std::vector<NearPoint> found;
        const auto count = static_cast<Index>(model_.place.size());
        for (Index p = 0; p < count; ++p) {
            const glm::vec3 at = project_(model_.place[p]);
            const glm::vec2 away = glm::vec2(at) - at_.pixel;
            const float square = glm::dot(away, away);
            if (square > radius * radius || at.z <= 0.0F || !model_.drawable[p]) continue;
            const bool faces = glm::dot(project_.toEye(model_.place[p]), model_.normal[p]) >= 0.0F;
            found.push_back({p, std::sqrt(square), at.z, faces});
        }
        return found;
    }

    /// Where triangles are large, the pointer must be closer to a point than where they are small,
    /// or there would be no room for edges and triangles.
    Index nearPoint(const Extent& front) const {
        if (!scene_.points) return kNone;
        const float radius = front.side < 1.5F * at_.radius
                                 ? at_.radius
                                 : std::clamp(0.3F * front.height, 1.0F, at_.radius);
        std::vector<NearPoint> found = pointsNear(radius);
        const std::size_t asked = std::min(found.size(), kPointsAsked);
        std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(asked),
                          found.end(), [](const NearPoint& a, const NearPoint& b) {
                              return a.faces != b.faces ? a.faces : a.depth < b.depth;
                          });
        for (std::size_t i = 0; i < asked; ++i) {
            if (!hidden(found[i].point)) return nearestAsFarAs(found[i], found);
        }
        return kNone;
    }

    /// Among points about as far away as `front`, the one closest to the pointer.
    Index nearestAsFarAs(const NearPoint& front, const std::vector<NearPoint>& found) const {
        const NearPoint* best = &front;
        for (const NearPoint& each : found) {
            if (each.faces == front.faces && each.pixels < best->pixels &&
                each.depth < front.depth + model_.spacing) {
                best = &each;
            }
        }
        return best == &front || hidden(best->point) ? front.point : best->point;
    }

    NearEdge lookAt(Index a, Index b) const {
        const glm::vec3 from = project_(model_.place[a]);
        const glm::vec3 to = project_(model_.place[b]);
        if (from.z <= 0.0F || to.z <= 0.0F) return {};
        float share = 0.0F;
        NearEdge near;
        near.edge = Selection::ofEdge(a, b);
        near.pixels = distanceToSegment(at_.pixel, glm::vec2(from), glm::vec2(to), share);
        near.place = glm::mix(model_.place[a], model_.place[b], share);
        near.distance = glm::dot(near.place - ray_.from, ray_.way);
        return near;
    }

    /// The ring edge closest to the pointer, if it is not farther away than `distance`.
    NearEdge ringEdge(float radius, float distance) const {
        NearEdge best;
        for (const RingPath& ring : scene_.rings) {
            for (std::size_t i = 0; i < ring.points.size(); ++i) {
                const NearEdge near =
                    lookAt(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
                if (near.pixels < std::min(best.pixels, radius) && near.distance < distance) {
                    best = near;
                }
            }
        }
        return best;
    }

    NearEdge edgeBefore(const Hit& front) const {
        const float radius = std::min(0.5F * at_.radius, 0.2F * extentOf(front.triangle).height);
        NearEdge best = ringEdge(radius, front.distance + 0.5F * model_.spacing);
        const Triangle& t = front.triangle;
        for (const NearEdge& near : {lookAt(t.a, t.b), lookAt(t.b, t.c), lookAt(t.c, t.a)}) {
            if (near.pixels < std::min(best.pixels, radius)) best = near;
        }
        return best;
    }

    /// Beside the mesh: its rim, or a ring.
    NearEdge edgeBesideAll() const {
        constexpr float kAnywhere = std::numeric_limits<float>::max();
        const float radius = 0.5F * at_.radius;
        NearEdge best = ringEdge(radius, kAnywhere);
        const float farthest = at_.camera.orthographic ? 1.0F : glm::length(ray_.from) + 1.0F;
        const float unitsPerPixel = 2.0F * farthest / (at_.camera.projection[1][1] * at_.size.y);
        const float margin = radius * unitsPerPixel;
        forEachNear(ray_, margin, [&](const Triangle& t) {
            for (const NearEdge& near : {lookAt(t.a, t.b), lookAt(t.b, t.c), lookAt(t.c, t.a)}) {
                if (near.pixels < radius && near.distance < best.distance) best = near;
            }
        });
        return best;
    }

    const PickScene& scene_;
    const Model& model_;
    const PickPoint& at_;
    Projector project_;
    Ray ray_;
};

}  // namespace

Index pickAmong(const Model& model, std::span<const Index> points, const CameraMatrices& camera,
                glm::vec2 size, glm::vec2 pixel, float radius) {
    const Projector project(camera, size);
    Index best = kNone;
    float bestDepth = std::numeric_limits<float>::max();
    bool bestFaces = false;
    for (const Index p : points) {
        if (!model.drawable[p]) continue;
        const glm::vec3 at = project(model.place[p]);
        if (at.z <= 0.0F || glm::distance(glm::vec2(at), pixel) > radius) continue;
        const bool faces = glm::dot(project.toEye(model.place[p]), model.normal[p]) >= 0.0F;
        if (faces == bestFaces ? at.z >= bestDepth : bestFaces) continue;
        best = p;
        bestDepth = at.z;
        bestFaces = faces;
    }
    return best;
}

std::vector<Index> pointsInside(const Model& model, const CameraMatrices& camera, glm::vec2 size,
                                std::span<const glm::vec2> path) {
    std::vector<Index> points;
    if (path.size() < 3) return points;
    glm::vec2 low = path.front();
    glm::vec2 high = low;
    for (const glm::vec2& corner : path) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const Projector project(camera, size);
    for (Index p = 0; p < model.place.size(); ++p) {
        if (!model.drawable[p]) continue;
        const glm::vec3 at = project(model.place[p]);
        const glm::vec2 pixel(at);
        const bool near = at.z > 0.0F && glm::clamp(pixel, low, high) == pixel;
        if (near && isWithin(path, pixel)) points.push_back(p);
    }
    return points;
}

std::vector<Index> pointsWithin(const Model& model, const CameraMatrices& camera, glm::vec2 size,
                                std::span<const glm::vec2> path) {
    std::vector<Index> points = pointsInside(model, camera, size, path);
    const Projector project(camera, size);
    std::erase_if(points, [&](Index p) {
        return glm::dot(project.toEye(model.place[p]), model.normal[p]) < 0.0F;
    });
    return points;
}

Pick pick(const PickScene& scene, const PickPoint& at) { return ScenePicker(scene, at).pick(); }

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

// Ghosts after Diepstraten, Weiskopf and Ertl 2002: only what hides is faded, all else stays
// opaque. A triangle hides if it meets the line of sight of one of the points; those that belong to
// the place itself never count, since they are what the decision is about.

namespace {

/// Room around the farthest point, as a factor.
constexpr float kPlaceRoom = 1.1F;
/// A list of more triangles is not searched in every frame.
constexpr std::size_t kSearchedUpTo = 3'000'000;

/// The line from a point to the eye.
struct SightLine {
    Ray ray;  ///< Toward the eye.
    float length = 0.0F;
};

glm::vec3 towardEye(const CameraMatrices& camera, const glm::vec3& place) {
    if (!camera.orthographic) return camera.eye - place;
    // Longer than the scene.
    return 10.0F * glm::vec3(camera.view[0][2], camera.view[1][2], camera.view[2][2]);
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
        sights.push_back({{point, glm::normalize(way)}, glm::length(way)});
    }
    const glm::vec3 axis = glm::normalize(towardEye(camera, place.center));
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        const std::array corners = model.cornersOf(t);
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
            const std::optional<float> along = meet(sight.ray, corners, 0.0F);
            return along && *along < sight.length &&
                   glm::distance(sight.ray.at(*along), place.center) > place.radius;
        });
    });
}

}  // namespace se::view
