/// RobustRules::dropPatches: a few triangles beside a larger component, a late patch over the
/// finished surface, are taken out, and where a point has several fans, all but the largest;
/// RobustRules::reinsert may put their points back.
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

/// The sides that leave a pinched point, by fan.
std::vector<std::vector<HalfEdge>> fansOf(const RepairState& m, Index p) {
    std::vector<std::vector<HalfEdge>> fans;
    for (const PinchedSide& side : sidesOfPinched(m, p)) {
        const bool known = std::any_of(fans.begin(), fans.end(), [&](const auto& fan) {
            return std::find(fan.begin(), fan.end(), side.leaving) != fan.end();
        });
        if (known) continue;
        std::vector<HalfEdge>& fan = fans.emplace_back();
        forEachSideFrom(m, side.leaving, [&](HalfEdge h) { fan.push_back(h); });
    }
    return fans;
}

/// A point of triangles that are taken out, and the sides of others that leave it.
struct Rim {
    Index point;
    std::vector<HalfEdge> sides;
};

std::vector<Rim> rimOf(const RepairState& m, const std::vector<Index>& gone) {
    std::vector<Rim> rim;
    for (const Index p : pointsOf(m, gone)) {
        Rim& each = rim.emplace_back(Rim{p, {}});
        const auto add = [&](HalfEdge h) {
            if (!std::binary_search(gone.begin(), gone.end(), h / 3)) each.sides.push_back(h);
        };
        if (m.pinched[p]) {
            for (const PinchedSide& side : sidesOfPinched(m, p)) add(side.leaving);
        } else {
            forEachSideOf(m, p, add);
        }
    }
    return rim;
}

/// Lists the sides of a point anew, which may have become pinched or stopped being so.
void listSides(RepairState& m, const Rim& rim) {
    m.sideOf[rim.point] = rim.sides.empty() ? kNone : rim.sides.front();
    m.pinched[rim.point] = reachedSides(m, rim.point) != rim.sides.size();
    std::erase_if(m.pinchedSides, [&](const PinchedSide& s) { return s.point == rim.point; });
    if (!m.pinched[rim.point]) return;
    auto at = std::find_if(m.pinchedSides.begin(), m.pinchedSides.end(),
                           [&](const PinchedSide& s) { return s.point > rim.point; });
    for (const HalfEdge h : rim.sides) at = m.pinchedSides.insert(at, {rim.point, h}) + 1;
}

/// Takes ascending triangles out of a mesh of which others stay beside them.
void takeOut(RepairState& m, const std::vector<Index>& gone) {
    const std::vector<Rim> rim = rimOf(m, gone);
    for (const Index t : gone) {
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
            if (m.twin[h] != kNone) m.twin[m.twin[h]] = kNone;
            m.twin[h] = kNone;
        }
    }
    for (const Rim& each : rim) listSides(m, each);
    dropTriangles(m, gone);
}

}  // namespace

std::optional<DropPatchEvidence> dropNextFans(RepairState& m) {
    if (m.next == 0) listPinched(m);
    m.next = 1;
    if (m.pinchedSides.empty()) return std::nullopt;
    const Index p = m.pinchedSides.front().point;
    const auto fans = fansOf(m, p);
    const auto largest = std::max_element(
        fans.begin(), fans.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    std::vector<Index> gone;
    for (auto fan = fans.begin(); fan != fans.end(); ++fan) {
        if (fan == largest) continue;
        for (const HalfEdge h : *fan) gone.push_back(h / 3);
    }
    std::sort(gone.begin(), gone.end());
    takeOut(m, gone);
    ++m.droppedPatches;
    return DropPatchEvidence{p, static_cast<Index>(gone.size()),
                             static_cast<Index>(largest->size())};
}

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
