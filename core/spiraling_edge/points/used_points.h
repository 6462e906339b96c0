/// Removal of points from a PointFile, such as those of a mesh that no triangle names.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_file.h"

namespace se {

/// The points of `points` that are in a triangle, in their order, with their normals, types,
/// attributes and neighbor lists; list entries for other points are dropped. `faces` of the result
/// are `triangles`, in their order, with the new indices. Requires triangles that name existing
/// points and columns of equal length. O(points + list entries + triangles).
PointFile withUsedPoints(const PointFile& points, std::span<const Triangle> triangles);
/// For each of `points` points: true if it is in a triangle. Requires triangles that name them.
std::vector<bool> usedPoints(std::size_t points, std::span<const Triangle> triangles);
/// Number of points that are in a triangle. Requires triangles that name points below `points`.
std::size_t countUsedPoints(std::size_t points, std::span<const Triangle> triangles);

/// Keeps the marked rows of all columns; neighbor lists and faces stay as they are.
void keepColumns(PointFile& file, const std::vector<bool>& keep);
/// The index of each kept point among those kept, kNone for the others.
std::vector<Index> keptNumbers(const std::vector<bool>& keep);

}  // namespace se
