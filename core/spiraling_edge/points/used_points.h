/// Removal of the points of a mesh that no triangle names.
#pragma once

#include <span>

#include "spiraling_edge/points/point_file.h"

namespace se {

/// The points of `points` that are in a triangle, in their order, with their normals, types,
/// attributes and neighbor lists; list entries for other points are dropped. `faces` of the result
/// are `triangles`, in their order, with the new indices. Requires triangles that name existing
/// points and columns of equal length. O(points + list entries + triangles).
PointFile withUsedPoints(const PointFile& points, std::span<const Triangle> triangles);
/// Number of points that are in a triangle. Requires triangles that name points below `points`.
std::size_t countUsedPoints(std::size_t points, std::span<const Triangle> triangles);

}  // namespace se
