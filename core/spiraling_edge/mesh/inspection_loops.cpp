/// Boundary loops, and whether each is a hole or an opening: decided from the mesh, the normals and
/// the wall types alone, so that a run and a file agree. A hole lies in the middle of the surface;
/// it is narrow, or its points see little of it: the free sector of a point at a round hole of six
/// edges is 120 degrees. An opening is wide, and the surface ends at most of its points, by the
/// measures of `rim` (fill.cpp); or it runs along the walls, or around a patch. O(t log t).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/mesh/inspection_checks.h"

namespace se::inspect {
namespace {

/// A free sector wider than 120 degrees: the surface ends at the point.
constexpr double kEndCosine = -0.5;

Index from(const TriangleSide& side) { return side.ascending ? side.low : side.high; }
Index to(const TriangleSide& side) { return side.ascending ? side.high : side.low; }

bool isMost(std::size_t count, std::size_t all) { return 3 * count > 2 * all; }

/// The shape of a loop, which runs as the sides of its triangles do.
LoopShape shapeOf(const InspectedMesh& mesh, const std::vector<TriangleSide>& loop) {
    const Vec3 origin = mesh.points.position[from(loop.front())];
    ShapeSum sum;
    for (const TriangleSide& side : loop) {
        sum.add(mesh.points.position[from(side)] - origin, mesh.points.normal[from(side)],
                mesh.points.position[to(side)] - origin);
    }
    return sum.shape();
}

/// True if the sector without triangles at a boundary point is wider than 120 degrees, seen along
/// its normal. It runs counterclockwise from the side that arrives to the one that leaves.
bool endsAt(const InspectedMesh& mesh, const TriangleSide& arriving, const TriangleSide& leaving) {
    const Index p = from(leaving);
    const Vec3& normal = mesh.points.normal[p];
    const auto flat = [&](Index q) {
        const Vec3 d = mesh.points.position[q] - mesh.points.position[p];
        return d - glm::dot(d, normal) / glm::dot(normal, normal) * normal;
    };
    const Vec3 u = flat(from(arriving));
    const Vec3 v = flat(to(leaving));
    if (glm::dot(glm::cross(u, v), normal) < 0.0) return true;  // over 180 degrees
    return glm::dot(u, v) < kEndCosine * glm::length(u) * glm::length(v);
}

/// True if the surface ends at most points of the loop. A point that it passes twice is not
/// counted.
bool endsAtMost(const InspectedMesh& mesh, const std::vector<TriangleSide>& loop) {
    std::map<Index, std::vector<const TriangleSide*>> arriving;
    std::map<Index, std::vector<const TriangleSide*>> leaving;
    for (const TriangleSide& side : loop) {
        leaving[from(side)].push_back(&side);
        arriving[to(side)].push_back(&side);
    }
    std::size_t ends = 0;
    for (const auto& [p, sides] : leaving) {
        const auto before = arriving.find(p);
        if (sides.size() != 1 || before == arriving.end() || before->second.size() != 1) continue;
        ends += endsAt(mesh, *before->second.front(), *sides.front()) ? 1U : 0U;
    }
    return isMost(ends, loop.size());
}

/// True if most points lie on walls or rims, and no two others follow each other: a single one
/// bulges past the chord.
bool runsAlongWalls(const InspectedMesh& mesh, const std::vector<TriangleSide>& loop) {
    const auto onWall = [&](Index p) { return isBoundary(mesh.points.type[p]); };
    std::size_t walls = 0;
    for (const TriangleSide& side : loop) {
        if (!onWall(side.low) && !onWall(side.high)) return false;
        walls += onWall(from(side)) ? 1U : 0U;
    }
    return isMost(walls, loop.size());
}

bool isOpening(const InspectedMesh& mesh, const std::vector<TriangleSide>& loop,
               const LoopShape& shape) {
    const bool known = std::all_of(loop.begin(), loop.end(), [&](const TriangleSide& side) {
        return mesh.points.normal[from(side)] != Vec3(0.0);
    });
    if (!known || runsAlongWalls(mesh, loop)) return true;
    const std::size_t triangles = mesh.trianglesAround(loop.front().low);
    if (shape.turnsRoundPatch && triangles <= loop.size() * loop.size()) return true;
    return shape.widthInEdges() >= kNarrowestOpening && endsAtMost(mesh, loop);
}

/// Appends the loops that are openings, or those that are holes.
void ofLoops(const InspectedMesh& mesh, bool wanted, Failures& failures) {
    for (const BoundaryLoop& loop : mesh.loops) {
        if (loop.isOpening != wanted) continue;
        std::vector<Index> points;
        std::vector<Index> triangles;
        for (const TriangleSide& side : loop.sides) {
            points.insert(points.end(), {side.low, side.high});
            triangles.push_back(side.triangle);
        }
        MeshFailure failure = mesh.at(std::move(points), std::move(triangles));
        failure.length = loop.shape.perimeter;
        failure.area = loop.shape.area;
        failures.push_back(std::move(failure));
    }
}

}  // namespace

std::vector<BoundaryLoop> boundaryLoops(const InspectedMesh& mesh) {
    DisjointSets joined(mesh.points.size());
    std::vector<TriangleSide> border;
    forEachEdge(mesh.sides, [&](std::span<const TriangleSide> edge) {
        if (edge.size() != 1) return;
        border.push_back(edge[0]);
        joined.unite(edge[0].low, edge[0].high);
    });
    std::map<Index, std::vector<TriangleSide>> sides;  // by least point
    for (const TriangleSide& side : border) sides[joined.find(side.low)].push_back(side);
    std::vector<BoundaryLoop> loops;
    for (auto& [least, loop] : sides) {
        const LoopShape shape = shapeOf(mesh, loop);
        const bool opening = isOpening(mesh, loop, shape);
        loops.push_back({std::move(loop), shape, opening});
    }
    return loops;
}

void holes(const InspectedMesh& mesh, Failures& failures) { ofLoops(mesh, false, failures); }
void openings(const InspectedMesh& mesh, Failures& failures) { ofLoops(mesh, true, failures); }

}  // namespace se::inspect
