/// Measures of the input that several methods need, and the orientation of their triangles, so that
/// the same checks apply to all.
#pragma once

#include <vector>

#include "spiraling_edge/io/read_points.h"

namespace se::peers {

/// The mean distance to the nearest other point. Methods that need a length get a multiple.
double meanSpacing(const PointFile& points);
/// The sides of the bounding box.
Vec3 extent(const PointFile& points);
/// The `count` nearest others of every point, nearest first, opposing normals included.
NeighborLists nearestLists(const PointFile& points, std::size_t count);

/// Turns every triangle to the side of its corners' normals.
void orientEach(const PointFile& points, std::vector<Triangle>& triangles);
/// Turns whole pieces (triangles joined by points) to the side of most normals: for methods that
/// orient a piece consistently, but to either side.
void orientPieces(const PointFile& points, std::vector<Triangle>& triangles);

}  // namespace se::peers
