/// Edges from sorted sides, components by union-find over points. O(t) for t triangles, but for
/// inverses of the Ackermann function.
#include "spiraling_edge/mesh/mesh_topology.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

void findIrregularEdges(MeshTopology& mesh) {
    forEachEdge(mesh.sides, [&](std::span<const TriangleSide> edge) {
        ++mesh.edges;
        if (edge.size() != 2 || edge[0].ascending == edge[1].ascending)
            mesh.irregularEdges.push_back(edge);
        if (edge.size() == 1) mesh.border.push_back(edge[0]);
    });
}

void findComponents(std::size_t points, std::span<const Triangle> triangles, MeshTopology& mesh) {
    mesh.used = usedPoints(points, triangles);
    DisjointSets joined(points);
    for (const Triangle& t : triangles) {
        joined.unite(t.a, t.b);
        joined.unite(t.b, t.c);
    }
    mesh.component.resize(points);
    for (Index p = 0; p < points; ++p) {
        mesh.component[p] = joined.find(p);
        if (!mesh.used[p]) continue;
        ++mesh.usedPoints;
        mesh.components += mesh.component[p] == p ? 1U : 0U;
    }
}

}  // namespace

MeshTopology::MeshTopology(std::size_t points, std::span<const Triangle> triangles)
    : sides(sortedSides(triangles)) {
    assert(cornersBelow(triangles, points));
    const unsigned threads = threadsFor(triangles);
    runTasks(
        threads, [&] { nonManifoldPoints = se::nonManifoldPoints(triangles, sides, points); },
        [&] { findComponents(points, triangles, *this); }, [&] { findIrregularEdges(*this); });
}

}  // namespace se
