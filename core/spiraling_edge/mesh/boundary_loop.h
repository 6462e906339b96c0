/// Boundary loops of a mesh, and whether each is a hole or an opening: decided from the mesh, the
/// normals and the types alone, so that a run and a file agree. A hole lies in the middle of
/// the surface; it is narrow, or its points see little of it: the free sector of a point at a round
/// hole of six edges is 120 degrees. An opening is wide, and the surface ends at most of its
/// points, by the measures of `rim` (fill.cpp); or it runs along walls or rims, or around a patch.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/mesh/sorted_sides.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// A side of a boundary loop, in the direction of its triangle.
struct LoopSide {
    Index from, to;
};

/// The connected parts of a boundary, of which these are the sides, by their least points;
/// `points`: the number of points of the mesh. O(b log b + points) for b sides.
std::vector<std::vector<TriangleSide>> connectedParts(const std::vector<TriangleSide>& border,
                                                      std::size_t points);

/// The shape of a loop: one closed chain of sides, or several with common points, in any order.
/// Requires at least one side.
LoopShape shapeOf(const PointSet& points, std::span<const LoopSide> loop);
/// The same sides in the direction of their triangles.
std::vector<LoopSide> loopSidesOf(std::span<const TriangleSide> sides);

/// True if the surface ends at this loop of this shape, be it that a normal is missing (zero), that
/// it runs along walls or rims, or that it is wide and most of its points have a wide free sector.
/// The outline of a whole patch is an opening as well, which only the caller can tell: see
/// largestPatch().
bool isOpening(const PointSet& points, std::span<const LoopSide> loop, const LoopShape& shape);

/// True if the loop runs along walls: most of its points lie on them, and no two others follow each
/// other.
bool runsAlongWalls(const PointSet& points, std::span<const LoopSide> loop);

/// The most triangles of a patch whose outline is a loop with LoopShape::turnsRoundPatch: more
/// would be folded, since a round patch has 0.18 triangles per square of its border's length.
inline std::size_t largestPatch(const LoopShape& shape) {
    return std::size_t{shape.length} * shape.length;
}

}  // namespace se
