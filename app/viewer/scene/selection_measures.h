/// Measures of points and triangles for display, in double precision and scene units, from the
/// positions as they are. No decision depends on them.
#pragma once

#include <array>
#include <span>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

/// 0 to 180; 0 if one of them has no length.
double degreesBetween(const Vec3& u, const Vec3& v);

/// The angles of a triangle at its corners a, b, c.
std::array<double, 3> cornerDegrees(const PointSet& points, const Triangle& t);
/// The smallest angle of some triangles; 0 if there are none.
double leastDegrees(const PointSet& points, std::span<const Triangle> triangles);
double leastDegrees(const PointSet& points, const Triangle& t);
double triangleArea(const PointSet& points, const Triangle& t);

/// The largest angle between the normal of a triangle and those of its corners: below 90 degrees it
/// turns counterclockwise as seen from all of them.
double tiltDegrees(const PointSet& points, const Triangle& t);

/// The free angle at a ring point: from `before` counterclockwise to `after` about the normal of
/// `at`, in its tangent plane, 0 to 360.
double freeDegrees(const PointSet& points, Index before, Index at, Index after);

/// Distance of `point` from the tangent plane of `of`, along its normal.
double heightOver(const PointSet& points, Index of, Index point);

/// Radius of the circle through the corners; infinite if they are collinear.
double circleRadius(const PointSet& points, const Triangle& t);

}  // namespace se::view
