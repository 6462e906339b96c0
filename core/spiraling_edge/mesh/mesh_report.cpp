#include "spiraling_edge/mesh/mesh_report.h"

#include <atomic>
#include <vector>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/mesh/mesh_topology.h"

namespace se {
namespace {

/// Counts the loops of the boundary, of which these are the sides, and measures the widest.
void countLoops(const PointSet& points, const std::vector<TriangleSide>& border,
                MeshReport& report) {
    const auto loops = connectedParts(border, points.size());
    report.boundaryLoops = loops.size();
    for (const std::vector<TriangleSide>& loop : loops) {
        const double width = shapeOf(points, loopSidesOf(loop)).width();
        if (width < report.widestLoopWidth) continue;
        report.widestLoopWidth = width;
        report.widestLoopEdges = loop.size();
    }
}

/// Counts the edges by the number of their triangles, and the loops of the boundary.
void countEdges(const PointSet& points, const MeshTopology& topology, MeshReport& report) {
    report.edges = topology.edges;
    std::vector<TriangleSide> border;
    for (const std::span<const TriangleSide> edge : topology.irregularEdges) {
        if (edge.size() > 2) ++report.nonManifoldEdges;
        if (isInconsistent(edge)) ++report.inconsistentEdges;
        if (edge.size() == 1) border.push_back(edge[0]);
    }
    report.boundaryEdges = border.size();
    countLoops(points, border, report);
}

void countShapes(const PointSet& points, std::span<const Triangle> triangles, MeshReport& report) {
    std::atomic<std::size_t> degenerate = 0;
    std::atomic<std::size_t> flipped = 0;
    forRanges(triangles.size(), 0, kTrianglesPerThread, [&](std::size_t from, std::size_t to) {
        std::size_t degenerateHere = 0;
        std::size_t flippedHere = 0;
        for (const Triangle& t : triangles.subspan(from, to - from)) {
            if (isDegenerate(points, t)) {
                ++degenerateHere;
            } else if (isFlipped(points, t)) {
                ++flippedHere;
            }
        }
        degenerate += degenerateHere;
        flipped += flippedHere;
    });
    report.degenerateTriangles = degenerate;
    report.flippedTriangles = flipped;
}

}  // namespace

MeshReport reportMesh(const PointSet& points, std::span<const Triangle> triangles) {
    MeshReport report = reportTopology(points, triangles, MeshTopology(points.size(), triangles));
    countShapes(points, triangles, report);
    return report;
}

MeshReport reportTopology(const PointSet& points, std::span<const Triangle> triangles,
                          const MeshTopology& topology) {
    MeshReport report;
    report.points = points.size();
    report.triangles = triangles.size();
    report.usedPoints = topology.usedPoints;
    report.unusedPoints = report.points - report.usedPoints;
    report.components = topology.components;
    report.nonManifoldVertices = topology.nonManifoldPoints.size();
    countEdges(points, topology, report);
    report.eulerCharacteristic = static_cast<long long>(report.usedPoints) -
                                 static_cast<long long>(report.edges) +
                                 static_cast<long long>(report.triangles);
    return report;
}

}  // namespace se
