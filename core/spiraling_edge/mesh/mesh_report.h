/// Counts over a mesh: edges, orientation, components, holes.
#pragma once

#include <span>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Counts over a triangle mesh. "Edge" is a pair of points that some triangle joins.
struct MeshReport {
    std::size_t points = 0;
    std::size_t triangles = 0;
    std::size_t usedPoints = 0;    ///< Points in at least one triangle.
    std::size_t unusedPoints = 0;  ///< Points in none.
    std::size_t edges = 0;
    std::size_t boundaryEdges = 0;  ///< Edges of exactly one triangle.
    std::size_t boundaryLoops = 0;  ///< Connected components of the boundary edges.
    /// Of the loops, the width (LoopShape::width()) and the number of edges of the widest.
    double widestLoopWidth = 0.0;
    std::size_t widestLoopEdges = 0;
    std::size_t nonManifoldEdges = 0;     ///< Edges of three or more triangles.
    std::size_t nonManifoldVertices = 0;  ///< Points whose triangles form more than one fan.
    std::size_t inconsistentEdges = 0;    ///< Edges passed twice in the same direction.
    std::size_t degenerateTriangles = 0;  ///< As FaultKind::Degenerate.
    std::size_t flippedTriangles = 0;  ///< Against the sum of the normals of their three corners.
    std::size_t components = 0;        ///< Sets of triangles joined by common points.
    /// Points - edges + triangles, over the used points.
    long long eulerCharacteristic = 0;

    /// No boundary, every edge of two triangles in opposite directions, every vertex one fan.
    bool closedManifold() const {
        return triangles > 0 && boundaryEdges == 0 && nonManifoldEdges == 0 &&
               inconsistentEdges == 0 && nonManifoldVertices == 0;
    }
};

/// Counts a mesh. Requires corners below points.size(). About O(t) for t triangles.
MeshReport reportMesh(const PointSet& points, std::span<const Triangle> triangles);

}  // namespace se
