#include "spiraling_edge/mesh/mesh_report.h"

#include <vector>

#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/mesh/mesh_topology.h"
#include "spiraling_edge/mesh/moderate_size.h"

namespace se {

MeshReport reportMesh(const PointSet& points, std::span<const Triangle> triangles) {
    const ModerateSize size(points, triangles);
    const MeshTopology topology(points.size(), triangles);
    const FaultSearch search = searchLocalFaults(size.points(), triangles, topology.sides);
    MeshReport report = reportOf(size.points(), triangles, topology, search.faults);
    report.widestLoopWidth = size.length(report.widestLoopWidth);
    return report;
}

MeshReport reportOf(const PointSet& points, std::span<const Triangle> triangles,
                    const MeshTopology& topology, std::span<const Fault> faults) {
    MeshReport report;
    report.points = points.size();
    report.triangles = triangles.size();
    report.usedPoints = topology.usedPoints;
    report.unusedPoints = report.points - report.usedPoints;
    report.components = topology.components;
    report.nonManifoldVertices = topology.nonManifoldPoints.size();
    const auto counts = countFaults(faults);
    report.degenerateTriangles = counts[static_cast<std::size_t>(FaultKind::Degenerate)];
    report.flippedTriangles = counts[static_cast<std::size_t>(FaultKind::Flipped)];
    report.edges = topology.edges;
    for (const std::span<const TriangleSide> edge : topology.irregularEdges) {
        if (edge.size() > 2) ++report.nonManifoldEdges;
        if (isInconsistent(edge)) ++report.inconsistentEdges;
    }
    report.boundaryEdges = topology.border.size();
    const auto loops = connectedParts(topology.border, points.size());
    report.boundaryLoops = loops.size();
    for (const std::vector<TriangleSide>& loop : loops) {
        const double width = shapeOf(points, loopSidesOf(loop)).width();
        if (width < report.widestLoopWidth) continue;
        report.widestLoopWidth = width;
        report.widestLoopEdges = loop.size();
    }
    report.eulerCharacteristic = static_cast<long long>(report.usedPoints) -
                                 static_cast<long long>(report.edges) +
                                 static_cast<long long>(report.triangles);
    return report;
}

}  // namespace se
