/// The checks of inspection.h and their common input.
#pragma once

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/mesh/sorted_sides.h"

namespace se {

/// A mesh with values that several checks share. Normals and types are filled in with zeros where
/// absent.
struct InspectedMesh {
    InspectedMesh(const PointSet& input, std::span<const Triangle> mesh);

    PointSet points;  ///< Without lists.
    std::span<const Triangle> triangles;
    std::vector<TriangleSide> sides;
    std::vector<Fault> faults;
    bool allFaults = true;        ///< False: the search for intersections ended early.
    std::uint64_t faultWork = 0;  ///< FaultSearch::work.
    std::vector<bool> used;       ///< Per point: in some triangle.
    double meanEdge = 0.0;        ///< Length, scene units.

    /// A failure at these points and triangles; its place is the center of the points.
    MeshFailure at(std::vector<Index> itsPoints, std::vector<Index> itsTriangles) const;
};

namespace inspect {

using Failures = std::vector<MeshFailure>;

// Edges and points: inspection_edges.cpp; those of triangles are in inspection.cpp.
void nonManifoldEdges(const InspectedMesh& mesh, Failures& failures);
void nonManifoldVertices(const InspectedMesh& mesh, Failures& failures);
void inconsistentEdges(const InspectedMesh& mesh, Failures& failures);
void holes(const InspectedMesh& mesh, Failures& failures);
void smallComponents(const InspectedMesh& mesh, Failures& failures);
void unusedPoints(const InspectedMesh& mesh, Failures& failures);
void isolatedPoints(const InspectedMesh& mesh, Failures& failures);

}  // namespace inspect
}  // namespace se
