#include "selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/rules.h"

namespace se::view {

Selection Selection::ofPoint(Index point) {
    if (point == kNone) return {};
    return {SelectionKind::Point, {point, kNone, kNone}};
}

Selection Selection::ofEdge(Index a, Index b) {
    return {SelectionKind::Edge, {std::min(a, b), std::max(a, b), kNone}};
}

Selection Selection::ofTriangle(const Triangle& triangle) {
    std::array<Index, 3> corners = {triangle.a, triangle.b, triangle.c};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return {SelectionKind::Triangle, corners};
}

Selection Selection::of(std::span<const Index> points) {
    if (points.size() == 1) return ofPoint(points[0]);
    if (points.size() == 2) return ofEdge(points[0], points[1]);
    if (points.size() == 3) return ofTriangle({points[0], points[1], points[2]});
    return {};
}

std::span<const Index> Selection::corners() const {
    return std::span(points).first(static_cast<std::size_t>(kind));
}

std::string_view kindName(SelectionKind kind) {
    constexpr std::array<std::string_view, 4> kNames = {"none", "point", "edge", "triangle"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string selectionText(const Selection& selection) {
    std::string text(kindName(selection.kind));
    for (const Index p : selection.corners()) {
        text += (p == selection.points[0] ? " " : ", ") + std::to_string(p);
    }
    return text;
}

double degreesBetween(const Vec3& u, const Vec3& v) {
    const double product = glm::length(u) * glm::length(v);
    if (!(product > 0.0)) return 0.0;
    return std::acos(std::clamp(glm::dot(u, v) / product, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

std::array<double, 3> cornerDegrees(const PointSet& points, const Triangle& t) {
    const auto at = [&](Index corner, Index left, Index right) {
        const Vec3& from = points.position[corner];
        return degreesBetween(points.position[left] - from, points.position[right] - from);
    };
    return {at(t.a, t.b, t.c), at(t.b, t.c, t.a), at(t.c, t.a, t.b)};
}

double leastDegrees(const PointSet& points, std::span<const Triangle> triangles) {
    double least = triangles.empty() ? 0.0 : 180.0;
    for (const Triangle& t : triangles) {
        const std::array<double, 3> corners = cornerDegrees(points, t);
        least = std::min(least, *std::min_element(corners.begin(), corners.end()));
    }
    return least;
}

double leastDegrees(const PointSet& points, const Triangle& t) {
    return leastDegrees(points, std::span(&t, 1));
}

double triangleArea(const PointSet& points, const Triangle& t) {
    return 0.5 * glm::length(areaVector(points, t));
}

double tiltDegrees(const PointSet& points, const Triangle& t) {
    const Vec3 across = areaVector(points, t);
    double most = 0.0;
    for (const Index corner : {t.a, t.b, t.c}) {
        most = std::max(most, degreesBetween(across, points.normal[corner]));
    }
    return most;
}

double freeDegrees(const PointSet& points, Index before, Index at, Index after) {
    const Vec3& origin = points.position[at];
    const Frame frame = makeFrame(origin, points.normal[at], points.position[before], true);
    return angleOf(frame, points.position[after] - origin).degrees();
}

double heightOver(const PointSet& points, Index of, Index point) {
    return glm::dot(points.position[point] - points.position[of], points.normal[of]);
}

double circleRadius(const PointSet& points, const Triangle& t) {
    const double area = triangleArea(points, t);
    if (!(area > 0.0)) return std::numeric_limits<double>::infinity();
    const Vec3& a = points.position[t.a];
    const Vec3& b = points.position[t.b];
    const Vec3& c = points.position[t.c];
    return glm::length(b - a) * glm::length(c - b) * glm::length(a - c) / (4.0 * area);
}

}  // namespace se::view
