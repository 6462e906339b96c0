/// Counts from sorted sides and union-find: components over points, boundary loops over boundary
/// edges. O(t) for t triangles, but for inverses of the Ackermann function.
#include "spiraling_edge/mesh/mesh_report.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/mesh/sorted_sides.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// A mesh with the sides of its triangles.
struct MeshSides {
    const PointSet& points;
    std::span<const Triangle> triangles;
    std::span<const TriangleSide> sides;
};

void countPieces(const MeshSides& mesh, MeshReport& report) {
    DisjointSets pieces(mesh.points.size());
    std::size_t joined = 0;
    for (const Triangle& t : mesh.triangles) {
        joined += pieces.unite(t.a, t.b) ? 1U : 0U;
        joined += pieces.unite(t.b, t.c) ? 1U : 0U;
    }
    report.usedPoints = countUsedPoints(mesh.points.size(), mesh.triangles);
    report.components = report.usedPoints - joined;
}

/// Counts the loops of the boundary, of which these are the sides, and measures the widest.
void countLoops(const MeshSides& mesh, const std::vector<TriangleSide>& border,
                MeshReport& report) {
    const auto loops = connectedParts(border, mesh.points.size());
    report.boundaryLoops = loops.size();
    for (const std::vector<TriangleSide>& loop : loops) {
        const double width = shapeOf(mesh.points, loopSidesOf(loop)).width();
        if (width < report.widestLoopWidth) continue;
        report.widestLoopWidth = width;
        report.widestLoopEdges = loop.size();
    }
}

/// Counts the edges by the number of their triangles, and the loops of the boundary.
void countEdges(const MeshSides& mesh, MeshReport& report) {
    std::vector<TriangleSide> border;
    forEachEdge(mesh.sides, [&](std::span<const TriangleSide> edge) {
        ++report.edges;
        if (edge.size() > 2) ++report.nonManifoldEdges;
        if (isInconsistent(edge)) ++report.inconsistentEdges;
        if (edge.size() == 1) {
            ++report.boundaryEdges;
            border.push_back(edge[0]);
        }
    });
    countLoops(mesh, border, report);
}

void countFans(const MeshSides& mesh, MeshReport& report) {
    report.nonManifoldVertices =
        nonManifoldPoints(mesh.triangles, mesh.sides, mesh.points.size()).size();
}

void countShapes(const MeshSides& mesh, MeshReport& report) {
    for (const Triangle& t : mesh.triangles) {
        if (isDegenerate(mesh.points, t)) {
            ++report.degenerateTriangles;
        } else if (isFlipped(mesh.points, t)) {
            ++report.flippedTriangles;
        }
    }
}

/// Independent of one another: each has counts of its own.
constexpr std::array kCounts{countPieces, countShapes, countFans, countEdges};
/// Fewer triangles are not worth a thread.
constexpr std::size_t kTrianglesPerThread = 32768;

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
    const MeshSides mesh{points, triangles, sides};
    const std::size_t least = triangles.size() < kTrianglesPerThread ? kCounts.size() : 1;
    forEachItem(kCounts.size(), 0, least, [&](std::size_t i) { kCounts[i](mesh, report); });
    report.unusedPoints = report.points - report.usedPoints;
    report.eulerCharacteristic = static_cast<long long>(report.usedPoints) -
                                 static_cast<long long>(report.edges) +
                                 static_cast<long long>(report.triangles);
    return report;
}

}  // namespace se
