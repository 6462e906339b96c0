/// The user's selection, by point indices: it survives every move.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

enum class SelectionKind : std::uint8_t { None, Point, Edge, Triangle };

struct Selection {
    SelectionKind kind = SelectionKind::None;
    std::array<Index, 3> points{kNone, kNone, kNone};

    static Selection ofPoint(Index point);
    /// The edge between two points, in either direction.
    static Selection ofEdge(Index a, Index b);
    /// A triangle; those with the same corners and orientation are equal, whatever corner is first.
    static Selection ofTriangle(const Triangle& triangle);

    /// One point, an edge of two or a triangle of three; nothing of any other number.
    static Selection of(std::span<const Index> points);

    /// The points of the selection; none if nothing is selected.
    std::span<const Index> corners() const;
    Triangle triangle() const { return {points[0], points[1], points[2]}; }
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// "none", "point", "edge", "triangle".
std::string_view kindName(SelectionKind kind);
/// "point 7", "edge 3, 7".
std::string selectionText(const Selection& selection);

// Measures of points and triangles for display, in double precision and scene units, from the
// positions as they are. No decision depends on them.

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
