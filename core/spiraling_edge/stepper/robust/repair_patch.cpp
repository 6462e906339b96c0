/// RobustRules::dropPatches: a component of a few triangles beside a larger one, a late patch over
/// the finished surface, is taken out; in the third round, at each point, all fans but the largest.
/// RobustRules::reinsert may put their points back.
#include <algorithm>
#include <limits>

#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

/// True if a neighbor of a triangle has a smaller index, as most triangles have.
bool followsNeighbor(const RepairState& m, Index t) {
    const HalfEdge first = 3 * t;
    return m.twin[first] < first || m.twin[first + 1] < first || m.twin[first + 2] < first;
}

/// The triangles of the component of which `t` has the smallest index, if these are fewer than
/// kSmallComponent; else none.
std::vector<Index> smallComponentFrom(const RepairState& m, Index t) {
    const auto isLess = [&](HalfEdge other) { return other < 3 * t; };
    std::vector<Index> found{t};
    for (std::size_t i = 0; i < found.size() && found.size() < kSmallComponent; ++i) {
        for (HalfEdge h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
            const HalfEdge other = m.twin[h];
            if (isLess(other)) return {};
            if (other != kNone && std::find(found.begin(), found.end(), other / 3) == found.end())
                found.push_back(other / 3);
        }
    }
    return found.size() < kSmallComponent ? found : std::vector<Index>{};
}

/// True if one of the points lists a point within reach of a component with at least
/// kSmallComponent triangles.
bool isBesideLarger(const PointSet& points, const RepairState& m, const std::vector<Index>& corners,
                    double reach) {
    return std::any_of(corners.begin(), corners.end(), [&](Index p) {
        const auto list = points.neighbors[p];
        return std::any_of(list.begin(), list.end(), [&](Index q) {
            return m.sideOf[q] != kNone &&
                   glm::distance(points.position[p], points.position[q]) <= reach &&
                   patchAt(m, m.sideOf[q] / 3, kSmallComponent).size() >= kSmallComponent;
        });
    });
}

/// True if the border of the patch runs along walls: it is a piece of the surface that they cut
/// off.
bool isCutOff(const PointSet& points, const RepairState& m, const std::vector<Index>& patch) {
    std::vector<LoopSide> border;
    for (const Index t : patch) {
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
            if (m.twin[h] == kNone) border.push_back({cornerOf(m, h), cornerOf(m, following(h))});
        }
    }
    return !border.empty() && runsAlongWalls(points, border);
}

double meanEdge(const PointSet& points, const RepairState& m) {
    double sum = 0.0;
    for (HalfEdge h = 0; h < m.twin.size(); ++h)
        sum += glm::distance(points.position[cornerOf(m, h)],
                             points.position[cornerOf(m, following(h))]);
    return sum / static_cast<double>(m.twin.size());
}

/// The distance within which a patch is beside a larger one: any, as far as lists reach, but for a
/// piece that walls cut off, which is no late patch, that of FailureClass small_components.
double reachOf(const PointSet& points, const RepairState& m, const std::vector<Index>& patch) {
    return isCutOff(points, m, patch) ? kNearComponent * meanEdge(points, m)
                                      : std::numeric_limits<double>::infinity();
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

/// The sides that leave a point, without those of triangles that go.
struct SidesLeft {
    Index point;
    std::vector<HalfEdge> sides;
};

/// For each corner of the triangles `gone`, which ascend.
std::vector<SidesLeft> sidesLeftBy(const RepairState& m, const std::vector<Index>& gone) {
    std::vector<SidesLeft> left;
    for (const Index p : cornersOf(m, gone)) {
        SidesLeft& each = left.emplace_back(SidesLeft{p, {}});
        const auto add = [&](HalfEdge h) {
            if (!std::binary_search(gone.begin(), gone.end(), h / 3)) each.sides.push_back(h);
        };
        if (m.pinched[p]) {
            for (const PinchedSide& side : sidesOfPinched(m, p)) add(side.leaving);
        } else {
            forEachSideOf(m, p, add);
        }
    }
    return left;
}

/// Pairs the sides of edges that had three triangles or more, of which one on each side is left.
void pairSides(RepairState& m, const SidesLeft& left) {
    for (const HalfEdge h : left.sides) {
        if (m.twin[h] != kNone) continue;
        const Index v = cornerOf(m, following(h));
        std::size_t leaving = 0;
        std::vector<HalfEdge> arriving;
        for (const HalfEdge side : left.sides) {
            leaving += cornerOf(m, following(side)) == v ? 1 : 0;
            if (cornerOf(m, preceding(side)) == v) arriving.push_back(preceding(side));
        }
        if (leaving == 1 && arriving.size() == 1) pair(m, h, arriving.front());
    }
}

/// Updates sideOf, pinched and pinchedSides of a point at triangles that go.
void updateSides(RepairState& m, const SidesLeft& left) {
    m.sideOf.set(left.point, left.sides.empty() ? kNone : left.sides.front());
    m.pinched.set(left.point, reachedSides(m, left.point) != left.sides.size());
    std::vector<PinchedSide> sides = m.pinchedSides;
    std::erase_if(sides, [&](const PinchedSide& s) { return s.point == left.point; });
    if (m.pinched[left.point] != 0) {
        auto at = std::find_if(sides.begin(), sides.end(),
                               [&](const PinchedSide& s) { return s.point > left.point; });
        for (const HalfEdge h : left.sides) at = sides.insert(at, {left.point, h}) + 1;
    }
    m.pinchedSides.assign(sides);
}

/// Takes out triangles, in ascending order, beside which others stay.
void takeOutFans(RepairState& m, const std::vector<Index>& gone) {
    const std::vector<SidesLeft> left = sidesLeftBy(m, gone);
    for (const Index t : gone) {
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
            if (m.twin[h] != kNone) m.twin.set(m.twin[h], kNone);
            m.twin.set(h, kNone);
        }
    }
    for (const SidesLeft& each : left) pairSides(m, each);
    for (const SidesLeft& each : left) updateSides(m, each);
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
    takeOutFans(m, gone);
    ++m.droppedPatches;
    return DropPatchEvidence{p, static_cast<Index>(gone.size()),
                             static_cast<Index>(largest->size())};
}

std::optional<DropPatchEvidence> dropNextPatch(const PointSet& points, RepairState& m) {
    for (; m.next < m.triangles.size(); ++m.next) {
        if (followsNeighbor(m, m.next)) continue;
        std::vector<Index> patch = smallComponentFrom(m, m.next);
        if (patch.empty()) continue;
        const std::vector<Index> corners = cornersOf(m, patch);
        const double reach = reachOf(points, m, patch);
        if (isAnyPinched(m, corners) || !isBesideLarger(points, m, corners, reach)) continue;
        for (const Index p : corners) m.sideOf.set(p, kNone);
        const DropPatchEvidence evidence{corners.front(), static_cast<Index>(patch.size())};
        dropTriangles(m, std::move(patch));
        ++m.droppedPatches;
        return evidence;
    }
    return std::nullopt;
}

}  // namespace se
