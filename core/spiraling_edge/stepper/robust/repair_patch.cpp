/// RobustRules::dropPatches: a few triangles beside a larger component, a late patch over the
/// finished surface, are taken out; RobustRules::reinsert may put their points back.
#include <algorithm>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

/// True if a triangle with a smaller index has an edge with this one.
bool hasLesserNeighbor(const RepairState& m, Index t) {
    const HalfEdge h = 3 * t;
    return std::any_of(m.twin.begin() + h, m.twin.begin() + h + 3,
                       [&](HalfEdge other) { return other < h; });
}

std::vector<Index> pointsOf(const RepairState& m, const std::vector<Index>& patch) {
    std::vector<Index> corners;
    for (const Index t : patch) {
        const Triangle& each = m.triangles[t];
        corners.insert(corners.end(), {each.a, each.b, each.c});
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// True if one of the points lists a point of a component with at least kSmallComponent triangles.
bool isBesideLarger(const PointSet& points, const RepairState& m,
                    const std::vector<Index>& corners) {
    return std::any_of(corners.begin(), corners.end(), [&](Index p) {
        const auto list = points.neighbors[p];
        return std::any_of(list.begin(), list.end(), [&](Index q) {
            return m.sideOf[q] != kNone &&
                   patchAt(m, m.sideOf[q] / 3, kSmallComponent).size() >= kSmallComponent;
        });
    });
}

}  // namespace

std::optional<DropPatchEvidence> dropNextPatch(const PointSet& points, RepairState& m) {
    for (; m.next < m.triangles.size(); ++m.next) {
        if (hasLesserNeighbor(m, m.next)) continue;  // Its patch was examined already.
        std::vector<Index> patch = patchAt(m, m.next, kSmallComponent);
        if (patch.size() >= kSmallComponent) continue;
        const std::vector<Index> corners = pointsOf(m, patch);
        const bool pinched =
            std::any_of(corners.begin(), corners.end(), [&](Index p) { return m.pinched[p]; });
        if (pinched || !isBesideLarger(points, m, corners)) continue;
        for (const Index p : corners) m.sideOf[p] = kNone;
        const DropPatchEvidence evidence{corners.front(), static_cast<Index>(patch.size())};
        dropTriangles(m, std::move(patch));
        ++m.droppedPatches;
        return evidence;
    }
    return std::nullopt;
}

}  // namespace se
