/// The boundary loops of an inspected mesh. O(t log t).
#include <utility>

#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/mesh/inspection_checks.h"

namespace se::inspect {
namespace {

bool isOutlineOfPatch(const InspectedMesh& mesh, const BoundaryLoop& loop) {
    return loop.shape.turnsRoundPatch &&
           mesh.trianglesAround(loop.sides.front().low) <= largestPatch(loop.shape);
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
        for (const TriangleSide& side : loop.sides) failure.edges.push_back({side.low, side.high});
        failure.length = loop.shape.perimeter;
        failure.area = loop.shape.area;
        failures.push_back(std::move(failure));
    }
}

}  // namespace

std::vector<BoundaryLoop> boundaryLoops(const InspectedMesh& mesh) {
    std::vector<TriangleSide> border;
    for (const std::span<const TriangleSide> edge : mesh.topology.irregularEdges) {
        if (edge.size() == 1) border.push_back(edge[0]);
    }
    std::vector<BoundaryLoop> loops;
    for (std::vector<TriangleSide>& its : connectedParts(border, mesh.points.size())) {
        const std::vector<LoopSide> chain = loopSidesOf(its);
        BoundaryLoop loop{std::move(its), shapeOf(mesh.points, chain)};
        loop.isOpening = isOutlineOfPatch(mesh, loop) || isOpening(mesh.points, chain, loop.shape);
        loops.push_back(std::move(loop));
    }
    return loops;
}

void holes(const InspectedMesh& mesh, Failures& failures) { ofLoops(mesh, false, failures); }
void openings(const InspectedMesh& mesh, Failures& failures) { ofLoops(mesh, true, failures); }

}  // namespace se::inspect
