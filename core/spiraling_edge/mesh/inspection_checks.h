/// The checks of inspection.h and their common input.
#pragma once

#include <optional>

#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/mesh/mesh_topology.h"

namespace se {

/// A connected part of the boundary: a closed chain of edges of one triangle each, or several
/// through common points.
struct BoundaryLoop {
    std::vector<TriangleSide> sides;
    LoopShape shape;
    bool isOpening = false;  ///< The surface ends there; else it is a hole.
};

/// A mesh with values that several checks share. Refers to its points and triangles, which must
/// outlive it.
struct InspectedMesh {
    /// All values but `search`.
    InspectedMesh(const PointSet& input, std::span<const Triangle> mesh);
    InspectedMesh(const InspectedMesh&) = delete;
    InspectedMesh& operator=(const InspectedMesh&) = delete;

    const MeshJudge* judge = nullptr;  ///< Null: the points themselves.
    std::optional<PointSet> filled;    ///< The points, if the input lacks normals or types: zeros.
    const PointSet& points;            ///< With normals and types; lists may be absent.
    std::span<const Triangle> triangles;
    MeshTopology topology;
    FaultSearch search;                           ///< Empty unless assigned.
    std::vector<Index> lostPoints;                ///< Points in no triangle, neither set aside nor
                                                  ///< unfit for any mesh; ascending.
    std::size_t twins = 0;                        ///< Points in no triangle beside a twin in one.
    double meanEdge = 0.0;                        ///< Length, scene units.
    std::vector<std::size_t> componentTriangles;  ///< By the least point of a component.
    std::vector<BoundaryLoop> loops;              ///< By least point.

    /// Number of triangles of the component that a used point belongs to.
    std::size_t trianglesAround(Index p) const { return componentTriangles[topology.component[p]]; }
    /// A failure at these points and triangles; its place is the center of the points.
    MeshFailure at(std::vector<Index> itsPoints, std::vector<Index> itsTriangles) const;
};

namespace inspect {

using Failures = std::vector<MeshFailure>;

/// The boundary of a mesh that has all its other values: inspection_loops.cpp.
std::vector<BoundaryLoop> boundaryLoops(const InspectedMesh& mesh);

// Loops: inspection_loops.cpp. Edges and points: inspection_edges.cpp. Triangles: inspection.cpp.
void holes(const InspectedMesh& mesh, Failures& failures);
void openings(const InspectedMesh& mesh, Failures& failures);
void nonManifoldEdges(const InspectedMesh& mesh, Failures& failures);
void nonManifoldVertices(const InspectedMesh& mesh, Failures& failures);
void inconsistentEdges(const InspectedMesh& mesh, Failures& failures);
void smallComponents(const InspectedMesh& mesh, Failures& failures);
void unusedPoints(const InspectedMesh& mesh, Failures& failures);
void isolatedPoints(const InspectedMesh& mesh, Failures& failures);

// Against what is known of the points: inspection_spikes.cpp; of closed pieces:
// inspection_pieces.cpp.
void spikes(const InspectedMesh& mesh, Failures& failures);
void inwardPieces(const InspectedMesh& mesh, Failures& failures);

}  // namespace inspect
}  // namespace se
