/// Checks by edges and points. Sides are sorted by edge once for all of them; holes are connected
/// components of the boundary edges, unused points are classified by a grid. O(t log t).
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/mesh/inspection_checks.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::inspect {
namespace {

MeshFailure atEdge(const InspectedMesh& mesh, std::span<const TriangleSide> edge) {
    std::vector<Index> triangles;
    for (const TriangleSide& side : edge) triangles.push_back(side.triangle);
    return mesh.at({edge[0].low, edge[0].high}, std::move(triangles));
}

/// Finds the points in no triangle that have a finite position: those near a used point, or the
/// isolated ones.
void findUnused(const InspectedMesh& mesh, bool isolatedOnes, Failures& failures) {
    const double reach = kIsolated * mesh.meanEdge;
    std::vector<Vec3> used;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (mesh.used[p]) used.push_back(mesh.points.position[p]);
    }
    std::optional<CellGrid> grid;
    if (!used.empty() && reach > 0.0) {
        const WallBox box = boxAround(used);
        grid.emplace(box.low, box.high, reach);
        for (const Vec3& x : used) grid->add(x);
    }
    for (Index p = 0; p < mesh.points.size(); ++p) {
        const Vec3& x = mesh.points.position[p];
        if (mesh.used[p] || !isFinite(x)) continue;
        bool isolated = true;
        const auto look = [&](Index i) {
            const Vec3 d = used[i] - x;
            if (glm::dot(d, d) <= reach * reach) isolated = false;
        };
        if (grid) grid->near(x, look);
        if (isolated == isolatedOnes) failures.push_back(mesh.at({p}, {}));
    }
}

}  // namespace

void nonManifoldEdges(const InspectedMesh& mesh, Failures& failures) {
    forEachEdge(mesh.sides, [&](std::span<const TriangleSide> edge) {
        if (edge.size() > 2) failures.push_back(atEdge(mesh, edge));
    });
}

void inconsistentEdges(const InspectedMesh& mesh, Failures& failures) {
    forEachEdge(mesh.sides, [&](std::span<const TriangleSide> edge) {
        if (isInconsistent(edge)) failures.push_back(atEdge(mesh, edge));
    });
}

void nonManifoldVertices(const InspectedMesh& mesh, Failures& failures) {
    std::map<Index, std::vector<Index>> trianglesAt;
    for (const Index p : nonManifoldPoints(mesh.triangles, mesh.sides, mesh.points.size())) {
        trianglesAt[p] = {};
    }
    for (std::size_t i = 0; i < mesh.triangles.size() && !trianglesAt.empty(); ++i) {
        const Triangle& t = mesh.triangles[i];
        for (const Index p : {t.a, t.b, t.c}) {
            const auto found = trianglesAt.find(p);
            if (found != trianglesAt.end()) found->second.push_back(static_cast<Index>(i));
        }
    }
    for (auto& [p, triangles] : trianglesAt) failures.push_back(mesh.at({p}, std::move(triangles)));
}

void holes(const InspectedMesh& mesh, Failures& failures) {
    DisjointSets joined(mesh.points.size());
    std::vector<TriangleSide> border;
    forEachEdge(mesh.sides, [&](std::span<const TriangleSide> edge) {
        if (edge.size() != 1) return;
        border.push_back(edge[0]);
        joined.unite(border.back().low, border.back().high);
    });
    std::map<Index, std::vector<TriangleSide>> loops;  // by least point
    for (const TriangleSide& side : border) loops[joined.find(side.low)].push_back(side);
    const std::vector<Vec3>& position = mesh.points.position;
    const std::vector<std::uint8_t>& type = mesh.points.type;
    for (const auto& [least, loop] : loops) {
        const bool alongWalls = std::all_of(loop.begin(), loop.end(), [&](const TriangleSide& s) {
            return isBoundary(type[s.low]) && isBoundary(type[s.high]);
        });
        if (alongWalls) continue;
        std::vector<Index> points;
        std::vector<Index> triangles;
        for (const TriangleSide& side : loop) {
            points.insert(points.end(), {side.low, side.high});
            triangles.push_back(side.triangle);
        }
        MeshFailure failure = mesh.at(std::move(points), std::move(triangles));
        Vec3 area(0.0);
        for (const TriangleSide& side : loop) {
            const Vec3 u = position[side.ascending ? side.low : side.high];
            const Vec3 v = position[side.ascending ? side.high : side.low];
            failure.length += std::sqrt(glm::dot(v - u, v - u));
            area += glm::cross(u - failure.place, v - failure.place);
        }
        failure.area = 0.5 * std::sqrt(glm::dot(area, area));
        failures.push_back(std::move(failure));
    }
}

void smallComponents(const InspectedMesh& mesh, Failures& failures) {
    DisjointSets pieces(mesh.points.size());
    for (const Triangle& t : mesh.triangles) {
        pieces.unite(t.a, t.b);
        pieces.unite(t.b, t.c);
    }
    std::map<Index, std::vector<Index>> triangles;  // by least point
    std::size_t largest = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::vector<Index>& piece = triangles[pieces.find(mesh.triangles[i].a)];
        piece.push_back(static_cast<Index>(i));
        largest = std::max(largest, piece.size());
    }
    for (auto& [least, piece] : triangles) {
        if (piece.size() >= kSmallComponent || 100 * piece.size() >= largest) continue;
        std::vector<Index> points;
        for (const Index i : piece) {
            const Triangle& t = mesh.triangles[i];
            points.insert(points.end(), {t.a, t.b, t.c});
        }
        failures.push_back(mesh.at(std::move(points), std::move(piece)));
    }
}

void unusedPoints(const InspectedMesh& mesh, Failures& failures) {
    findUnused(mesh, false, failures);
}

void isolatedPoints(const InspectedMesh& mesh, Failures& failures) {
    findUnused(mesh, true, failures);
}

}  // namespace se::inspect
