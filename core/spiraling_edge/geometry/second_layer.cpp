/// A pair is projected along the sum of its normals. Most pairs of neighbors end at a separating
/// edge; for the rest the common polygon gives the share (Sutherland and Hodgman 1974), and the
/// gap at its corners, since the heights of both planes are linear over it.
#include "spiraling_edge/geometry/second_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/triangle_shape.h"

namespace se {
namespace {

struct Flat {
    double x, y;
};
using FlatTriangle = std::array<Flat, 3>;

/// A convex polygon: a triangle cut by three lines has at most six corners.
struct Polygon {
    std::array<Flat, 6> corner{};
    std::size_t size = 0;
    void add(const Flat& p) {
        if (size < corner.size()) corner[size++] = p;
    }
};

/// Twice the area of a, b, c: above zero if they run counterclockwise.
double turn(const Flat& a, const Flat& b, const Flat& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The directions of a projection, and the point that it begins at.
struct Projection {
    Vec3 origin, right, ahead, up;

    Projection(const Vec3& at, const Vec3& along) : origin(at), up(glm::normalize(along)) {
        right =
            glm::normalize(glm::cross(std::abs(up.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), up));
        ahead = glm::cross(up, right);
    }
    Flat flat(const Vec3& p) const {
        return {glm::dot(p - origin, right), glm::dot(p - origin, ahead)};
    }
    /// Counterclockwise.
    FlatTriangle flat(const PointSet& points, const Triangle& t) const {
        FlatTriangle flats{flat(points.position[t.a]), flat(points.position[t.b]),
                           flat(points.position[t.c])};
        if (turn(flats[0], flats[1], flats[2]) < 0.0) std::swap(flats[1], flats[2]);
        return flats;
    }
};

/// True if an edge of `a` has all of `b` outside, or on it.
bool separates(const FlatTriangle& a, const FlatTriangle& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Flat& u = a[i];
        const Flat& v = a[(i + 1) % 3];
        if (turn(u, v, b[0]) <= 0.0 && turn(u, v, b[1]) <= 0.0 && turn(u, v, b[2]) <= 0.0)
            return true;
    }
    return false;
}

/// The part of a convex polygon on the left of the line from u to v.
Polygon leftOf(const Polygon& whole, const Flat& u, const Flat& v) {
    Polygon left;
    for (std::size_t i = 0; i < whole.size; ++i) {
        const Flat& p = whole.corner[i];
        const Flat& q = whole.corner[i + 1 < whole.size ? i + 1 : 0];
        const double atP = turn(u, v, p);
        const double atQ = turn(u, v, q);
        if (atP >= 0.0) left.add(p);
        if ((atP > 0.0 && atQ < 0.0) || (atP < 0.0 && atQ > 0.0)) {
            const double s = atP / (atP - atQ);
            left.add({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
        }
    }
    return left;
}

Polygon commonPart(const FlatTriangle& a, const FlatTriangle& b) {
    Polygon common;
    for (const Flat& p : a) common.add(p);
    for (std::size_t i = 0; i < 3; ++i) common = leftOf(common, b[i], b[(i + 1) % 3]);
    return common;
}

double twiceAreaOf(const Polygon& polygon) {
    double sum = 0.0;
    for (std::size_t i = 2; i < polygon.size; ++i)
        sum += turn(polygon.corner[0], polygon.corner[i - 1], polygon.corner[i]);
    return sum;
}

/// True if, seen along `up`, each corner of `other` is an end of one edge of `t` or clearly beyond
/// it. `margin` is far above the rounding of an area.
bool liesBeyondEdge(const PointSet& points, const Triangle& t, const Vec3& normal,
                    const Triangle& other, const Vec3& up, double margin) {
    const std::array corner{t.a, t.b, t.c};
    const std::array others{other.a, other.b, other.c};
    // Counterclockwise seen along `up`.
    const Vec3 axis = glm::dot(normal, up) < 0.0 ? -up : up;
    for (std::size_t i = 0; i < 3; ++i) {
        const Index u = corner[i];
        const Index v = corner[(i + 1) % 3];
        const Index inside = corner[(i + 2) % 3];
        if (other.a == inside || other.b == inside || other.c == inside) continue;
        const Vec3& from = points.position[u];
        const Vec3 inward = glm::cross(axis, points.position[v] - from);
        const bool beyond = std::all_of(others.begin(), others.end(), [&](Index p) {
            return p == u || p == v || glm::dot(inward, points.position[p] - from) < -margin;
        });
        if (beyond) return true;
    }
    return false;
}

}  // namespace

bool lieSideBySide(const PointSet& points, const Triangle& a, const LayerShape& shapeA,
                   const Triangle& b, const LayerShape& shapeB) {
    const Vec3 along = shapeA.outward + shapeB.outward;
    const double margin = 1e-9 * (shapeA.reach + shapeB.reach) * (shapeA.reach + shapeB.reach);
    const bool haveArea = std::abs(glm::dot(shapeA.normal, along)) > margin &&
                          std::abs(glm::dot(shapeB.normal, along)) > margin;
    // `b` first: the search for conflicts has tested the edges of `a` already.
    return haveArea && (liesBeyondEdge(points, b, shapeB.normal, a, along, margin) ||
                        liesBeyondEdge(points, a, shapeA.normal, b, along, margin));
}

namespace {

/// isSecondLayer() for parallel triangles that do not lie side by side.
bool isOverOther(const PointSet& points, const Triangle& a, const LayerShape& shapeA,
                 const Triangle& b, const LayerShape& shapeB) {
    const Vec3& origin = points.position[a.a];
    const Projection projection(origin, shapeA.outward + shapeB.outward);
    const FlatTriangle one = projection.flat(points, a);
    const FlatTriangle other = projection.flat(points, b);
    if (separates(one, other) || separates(other, one)) return false;
    const Polygon common = commonPart(one, other);
    const double smaller =
        std::min(turn(one[0], one[1], one[2]), turn(other[0], other[1], other[2]));
    if (common.size < 3 || twiceAreaOf(common) < kLayerShare * smaller) return false;
    double gap = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < common.size; ++i) {
        const Flat& p = common.corner[i];
        const Vec3 at = origin + p.x * projection.right + p.y * projection.ahead;
        const auto height = [&](const Triangle& t, const Vec3& normal) {
            return glm::dot(points.position[t.a] - at, normal) / glm::dot(projection.up, normal);
        };
        gap = std::min(gap, std::abs(height(a, shapeA.normal) - height(b, shapeB.normal)));
    }
    return gap <= shapeA.reach + shapeB.reach;
}

// Inline, as they are called for each box.

/// The reach of a triangle (LayerShape::reach).
inline double reachOf(const PointSet& points, const Triangle& t) {
    const Vec3& a = points.position[t.a];
    const Vec3& b = points.position[t.b];
    const Vec3& c = points.position[t.c];
    return (glm::distance(a, b) + glm::distance(b, c) + glm::distance(c, a)) / 12.0;
}

/// The most that a direction within 22.5 degrees of a unit vector has along an axis.
inline double mostAlong(double unit) {
    constexpr double kCosine = 0.92387953251128674;
    constexpr double kSine = 0.38268343236508977;
    const double along = std::abs(unit);
    if (!(along < kCosine)) return 1.0;
    return along * kCosine + std::sqrt(1.0 - along * along) * kSine;
}

/// The box, grown by the reach along directions near a unit vector.
inline Box grownAlong(const Box& box, const Vec3& unit, double reach) {
    constexpr double kMargin = 1.0 + 1e-9;  // Far above the rounding of a unit vector.
    return box.grown(kMargin * reach *
                     Vec3(mostAlong(unit.x), mostAlong(unit.y), mostAlong(unit.z)));
}

}  // namespace

Box conflictBox(const Box& box, const LayerShape& shape) {
    return grownAlong(box, shape.outward, shape.reach);
}

Box conflictBox(const PointSet& points, const Triangle& t) {
    const Vec3 normal = areaVector(points, t);
    const double length = glm::length(normal);
    const Vec3 unit = length > 0.0 ? normal / length : Vec3(0.0);
    return grownAlong(boxOf(points, t), unit, reachOf(points, t));
}

LayerShape layerShape(const PointSet& points, const Triangle& t) {
    LayerShape shape;
    shape.normal = areaVector(points, t);
    shape.reach = reachOf(points, t);
    const double length = glm::length(shape.normal);
    if (!(length > 0.0)) return shape;
    shape.outward = shape.normal / (facing(points, t) < 0.0 ? -length : length);
    return shape;
}

bool isSecondLayer(const PointSet& points, const Triangle& a, const LayerShape& shapeA,
                   const Triangle& b, const LayerShape& shapeB) {
    return areParallel(shapeA, shapeB) && !lieSideBySide(points, a, shapeA, b, shapeB) &&
           isOverOther(points, a, shapeA, b, shapeB);
}

bool isSecondLayer(const PointSet& points, const Triangle& a, const Triangle& b) {
    return !encloseWide(areaVector(points, a), areaVector(points, b)) &&
           isSecondLayer(points, a, layerShape(points, a), b, layerShape(points, b));
}

ShapedTriangle::ShapedTriangle(const PointSet& points, const Triangle& t)
    : triangle(t), box(boxOf(points, t)), shape(layerShape(points, t)) {}

namespace {

/// True if the corners of the other triangle that are not common lie clearly on one side of the
/// plane of this one: they share no more than their common corners then. `margin` is far above the
/// rounding of a volume.
bool isOffPlane(const PointSet& points, const ShapedTriangle& t, const Triangle& other,
                double margin) {
    const Triangle& mine = t.triangle;
    const Vec3& at = points.position[mine.a];
    double low = std::numeric_limits<double>::max();
    double high = -low;
    for (const Index p : {other.a, other.b, other.c}) {
        if (p == mine.a || p == mine.b || p == mine.c) continue;
        const double height = glm::dot(t.shape.normal, points.position[p] - at);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return low <= high && (low > margin || high < -margin);
}

/// trianglesShareMore(), after quick tests that answer for most pairs.
bool shareMore(const PointSet& points, const ShapedTriangle& a, const ShapedTriangle& b) {
    const double reach = a.shape.reach + b.shape.reach;
    const double margin = 1e-9 * reach * reach * reach;
    return !isOffPlane(points, a, b.triangle, margin) &&
           !isOffPlane(points, b, a.triangle, margin) &&
           trianglesShareMore(points.position, a.triangle, b.triangle);
}

}  // namespace

bool conflictInReach(const PointSet& points, const ShapedTriangle& a, const ShapedTriangle& b) {
    const bool parallel = areParallel(a.shape, b.shape);
    if (parallel && lieSideBySide(points, a.triangle, a.shape, b.triangle, b.shape)) return false;
    if (a.box.meets(b.box) && shareMore(points, a, b)) return true;
    return parallel && isOverOther(points, a.triangle, a.shape, b.triangle, b.shape);
}

bool mayConflict(const Box& a, const Box& b) {
    return a.grown(mostReachIn(a) + mostReachIn(b)).meets(b);
}

namespace {

/// True if two triangles are not in conflict by their boxes alone.
bool areApart(const PointSet& points, const ShapedTriangle& a, const Triangle& b) {
    const Box box = boxOf(points, b);
    return !a.box.grown(a.shape.reach + mostReachIn(box)).meets(box);
}

}  // namespace

bool conflict(const PointSet& points, const ShapedTriangle& a, const Triangle& b) {
    if (areApart(points, a, b)) return false;
    if (!encloseWide(a.shape.normal, areaVector(points, b)))
        return conflict(points, a, ShapedTriangle(points, b));
    return a.box.meets(boxOf(points, b)) && trianglesShareMore(points.position, a.triangle, b);
}

bool conflict(const PointSet& points, const Triangle& a, const Triangle& b) {
    const Box boxA = boxOf(points, a);
    const Box boxB = boxOf(points, b);
    if (!mayConflict(boxA, boxB)) return false;
    if (boxA.meets(boxB) && trianglesShareMore(points.position, a, b)) return true;
    return isSecondLayer(points, a, b);
}

}  // namespace se
