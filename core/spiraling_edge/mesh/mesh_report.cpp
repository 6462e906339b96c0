/// Counts from sorted sides and union-find: components over points, boundary loops over boundary
/// edges. O(t) for t triangles, but for inverses of the Ackermann function.
#include "spiraling_edge/mesh/mesh_report.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/sorted_sides.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// Counts the edges by the number of their triangles, and the loops of the boundary.
void countEdges(std::span<const TriangleSide> sides, std::size_t points, MeshReport& report) {
    DisjointSets boundary(points);
    std::vector<bool> onBoundary(points, false);
    std::size_t joined = 0;
    forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
        ++report.edges;
        if (edge.size() > 2) ++report.nonManifoldEdges;
        if (isInconsistent(edge)) ++report.inconsistentEdges;
        if (edge.size() == 1) {
            ++report.boundaryEdges;
            onBoundary[edge[0].low] = onBoundary[edge[0].high] = true;
            if (boundary.unite(edge[0].low, edge[0].high)) ++joined;
        }
    });
    const auto ends =
        static_cast<std::size_t>(std::count(onBoundary.begin(), onBoundary.end(), true));
    report.boundaryLoops = ends - joined;
}

void countShapes(const PointSet& points, std::span<const Triangle> triangles, MeshReport& report) {
    for (const Triangle& t : triangles) {
        if (isDegenerate(points, t)) {
            ++report.degenerateTriangles;
        } else if (isFlipped(points, t)) {
            ++report.flippedTriangles;
        }
    }
}

}  // namespace

MeshReport reportMesh(const PointSet& points, std::span<const Triangle> triangles) {
    return reportMesh(points, triangles, sortedSides(triangles));
}

MeshReport reportMesh(const PointSet& points, std::span<const Triangle> triangles,
                      std::span<const TriangleSide> sides) {
    assert(cornersBelow(triangles, points.size()));
    MeshReport report;
    report.points = points.size();
    report.triangles = triangles.size();
    DisjointSets pieces(points.size());
    std::size_t joined = 0;
    for (const Triangle& t : triangles) {
        joined += pieces.unite(t.a, t.b) ? 1U : 0U;
        joined += pieces.unite(t.b, t.c) ? 1U : 0U;
    }
    report.usedPoints = countUsedPoints(points.size(), triangles);
    report.unusedPoints = report.points - report.usedPoints;
    report.components = report.usedPoints - joined;
    countEdges(sides, points.size(), report);
    report.nonManifoldVertices = nonManifoldPoints(triangles, sides, points.size()).size();
    countShapes(points, triangles, report);
    report.eulerCharacteristic = static_cast<long long>(report.usedPoints) -
                                 static_cast<long long>(report.edges) +
                                 static_cast<long long>(report.triangles);
    return report;
}

}  // namespace se
