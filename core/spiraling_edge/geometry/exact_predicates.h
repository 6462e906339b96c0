/// Signs of determinants that are always right: a floating-point filter, then exact expansions
/// after Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates", Discrete & Computational Geometry 18 (1997). Exact barring overflow and underflow.
#pragma once

#include "spiraling_edge/points/point_set.h"

namespace se {

/// > 0 if d lies below the plane through a, b, c (which seen from above run counterclockwise), < 0
/// above, 0 exactly in it.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The plane that a figure is projected to: the axis that is dropped.
enum class Axis { X, Y, Z };

/// > 0 if a, b, c run counterclockwise in the projection, < 0 clockwise, 0 collinear.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, Axis dropped);

/// True if the triangles a0 a1 a2 and b0 b1 b2, which have no corner in common, touch or cross.
bool trianglesMeet(const Vec3* a, const Vec3* b);
/// True if the segment p q touches or crosses the triangle.
bool segmentMeetsTriangle(const Vec3& p, const Vec3& q, const Vec3* triangle);
/// True if the triangles (u, v, x) and (u, v, y), as sets of points, share more than the edge u v.
bool overlapAtEdge(const Vec3& u, const Vec3& v, const Vec3& x, const Vec3& y);

/// True if the triangles share more than their common corners: the definition of an intersection.
bool trianglesShareMore(const std::vector<Vec3>& position, const Triangle& a, const Triangle& b);

}  // namespace se
