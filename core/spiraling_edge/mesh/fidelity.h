/// Fidelity of a mesh to the points it was made of.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// How far the points lie from the mesh. A point in a triangle lies on it.
struct Fidelity {
    double greatestDistance = 0.0;  ///< Scene units.
    double meanDistance = 0.0;      ///< Over all points whose distance is known; scene units.
};

/// The distance of each point from the nearest triangle, scene units: 0 for a point in a triangle,
/// NaN for a point without a finite position or where a missing value was written, and for every
/// point if there is no triangle. Requires corners below points.size() with finite positions.
/// Deterministic. About O(t log t + n log t) for n points in no triangle.
std::vector<double> distancesFromMesh(const PointSet& points, std::span<const Triangle> triangles);

/// The greatest and the mean of the distances that are known.
Fidelity fidelityFrom(std::span<const double> distances);
/// Measures the distance of each point to the nearest triangle; points without a finite position
/// and missing values are left out. Both are 0 if there is no triangle. Requires corners below
/// points.size() with finite positions. Deterministic. About O(t log t + n log t) for n points in
/// no triangle.
Fidelity fidelityOf(const PointSet& points, std::span<const Triangle> triangles);

}  // namespace se
