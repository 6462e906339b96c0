/// Counts from sorted sides and union-find: components over points, boundary loops over boundary
/// edges, fans over corners joined across edges. O(t log t).
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
void countEdges(const std::vector<TriangleSide>& sides, std::size_t points, MeshReport& report) {
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

std::vector<Index> nonManifoldPoints(std::span<const Triangle> triangles,
                                     const std::vector<TriangleSide>& sides, std::size_t points) {
    // A corner is one triangle at one of its points; corners at a point are joined across edges.
    const auto cornerOf = [&](Index triangle, Index point) {
        const Triangle& t = triangles[triangle];
        const Index k = t.a == point ? 0U : (t.b == point ? 1U : 2U);
        return 3 * triangle + k;
    };
    DisjointSets corners(3 * triangles.size());
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (!sides[i].sameEdge(sides[i - 1])) continue;
        for (const Index point : {sides[i].low, sides[i].high}) {
            corners.unite(cornerOf(sides[i - 1].triangle, point),
                          cornerOf(sides[i].triangle, point));
        }
    }
    std::vector<Index> fans(points, 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const auto first = static_cast<Index>(3 * i);
        if (corners.find(first) == first) ++fans[t.a];
        if (corners.find(first + 1) == first + 1) ++fans[t.b];
        if (corners.find(first + 2) == first + 2) ++fans[t.c];
    }
    std::vector<Index> found;
    for (std::size_t p = 0; p < points; ++p) {
        if (fans[p] > 1) found.push_back(static_cast<Index>(p));
    }
    return found;
}

MeshReport reportMesh(const PointSet& points, std::span<const Triangle> triangles) {
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
    const std::vector<TriangleSide> sides = sortedSides(triangles);
    countEdges(sides, points.size(), report);
    report.nonManifoldVertices = nonManifoldPoints(triangles, sides, points.size()).size();
    countShapes(points, triangles, report);
    report.eulerCharacteristic = static_cast<long long>(report.usedPoints) -
                                 static_cast<long long>(report.edges) +
                                 static_cast<long long>(report.triangles);
    return report;
}

}  // namespace se
