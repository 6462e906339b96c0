/// Second layers: triangles that lie over or under another one and face the same way, as where a
/// surface is made twice.
#pragma once

#include <glm/geometric.hpp>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// The values of one triangle that isSecondLayer() tests pairs by.
struct LayerShape {
    Vec3 normal{};       ///< By the order of the corners, any length.
    Vec3 outward{};      ///< Unit normal on the side of the corners' normals; zero without area.
    double reach = 0.0;  ///< A quarter of the mean edge length, scene units.
};
/// The shape of a triangle. `points.normal` may hold zeros: the order of the corners decides then.
LayerShape layerShape(const PointSet& points, const Triangle& t);

/// Normals of layers enclose less than this: the cosine of 45 degrees.
inline constexpr double kLayerCosine = 0.70710678118654752;
/// At least this share of the smaller triangle lies over or under the other.
inline constexpr double kLayerShare = 0.02;

/// True if the normals of two triangles, each turned outward, are within 45 degrees; false where
/// one is zero.
inline bool areParallel(const LayerShape& a, const LayerShape& b) {
    return glm::dot(a.outward, b.outward) >= kLayerCosine;
}

/// True if the normals of two triangles, of any length, enclose clearly more than 45 degrees,
/// whichever way they are turned: an answer for most pairs where surfaces bend.
inline bool encloseWide(const Vec3& m, const Vec3& n) {
    const double along = glm::dot(m, n);
    return along * along < 0.499 * glm::dot(m, m) * glm::dot(n, n);
}

/// True if two triangles clearly lie side by side, seen along the sum of their normals: they share
/// no more than common corners and the edge between these, nor is one a layer over the other. An
/// answer for most parallel pairs, at a fraction of the cost of others.
bool lieSideBySide(const PointSet& points, const Triangle& a, const LayerShape& shapeA,
                   const Triangle& b, const LayerShape& shapeB);

/// True if one triangle is a second layer over the other: their normals, each turned outward, are
/// within 45 degrees; seen along the sum of these, at least 2 % of the smaller one lies over or
/// under the other; and the least gap there is at most half of the mean length of their six edges.
/// False for a triangle without area.
bool isSecondLayer(const PointSet& points, const Triangle& a, const LayerShape& shapeA,
                   const Triangle& b, const LayerShape& shapeB);

/// As above, for triangles tested once.
bool isSecondLayer(const PointSet& points, const Triangle& a, const Triangle& b);

/// The box of a triangle, grown by its reach in all directions within 22.5 degrees of its normal:
/// where layers over or under it lie, since these are seen along the sum of two normals. Triangles
/// are in conflict() only if such boxes of theirs meet.
Box conflictBox(const Box& box, const LayerShape& shape);
Box conflictBox(const PointSet& points, const Triangle& t);

/// A triangle with the values that conflict() tests pairs by.
struct ShapedTriangle {
    ShapedTriangle(const PointSet& points, const Triangle& t);

    Triangle triangle;
    Box box;
    LayerShape shape;
};
/// No triangle in the box has a longer reach: an edge is no longer than the sum of the sides.
inline double mostReachIn(const Box& box) {
    const Vec3 sides = box.high - box.low;
    return 0.25 * (sides.x + sides.y + sides.z);
}
/// False only if the boxes alone show that no triangles in them are in conflict.
bool mayConflict(const Box& a, const Box& b);
/// conflict() for triangles whose boxes meet if one is grown by the sum of their reaches.
bool conflictInReach(const PointSet& points, const ShapedTriangle& a, const ShapedTriangle& b);
/// True if two triangles share more than their common corners, or one is a second layer of the
/// other. Boxes alone separate most pairs.
inline bool conflict(const PointSet& points, const ShapedTriangle& a, const ShapedTriangle& b) {
    return a.box.meets(b.box, a.shape.reach + b.shape.reach) && conflictInReach(points, a, b);
}
/// As above, for triangles tested once.
bool conflict(const PointSet& points, const ShapedTriangle& a, const Triangle& b);
bool conflict(const PointSet& points, const Triangle& a, const Triangle& b);

}  // namespace se
