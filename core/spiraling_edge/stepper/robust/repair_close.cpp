/// RobustRules::closeHoles: a hole of the finished mesh, by the definition of boundary_loop.h, is
/// filled with triangles between its points, none of which has a fault; where that needs more room,
/// triangles around it go as well, or one of its points.
#include <algorithm>

#include "spiraling_edge/mesh/boundary_loop.h"
#include "spiraling_edge/stepper/robust/hole_filling.h"
#include "spiraling_edge/stepper/rules.h"

namespace se {
namespace {

/// Of the border sides that leave a pinched point, the one across the gap from `arriving`; kNone if
/// there is none.
HalfEdge acrossGap(const PointSet& points, const RepairState& m, HalfEdge arriving) {
    const Index p = cornerOf(m, following(arriving));
    const Vec3& place = points.position[p];
    const Frame frame =
        makeFrame(place, points.normal[p], points.position[cornerOf(m, arriving)], true);
    HalfEdge nearest = kNone;
    double least = 5.0;
    for (const PinchedSide& side : sidesOfPinched(m, p)) {
        if (m.twin[side.leaving] != kNone) continue;
        const Index next = cornerOf(m, following(side.leaving));
        const Angle turn = angleOf(frame, points.position[next] - place);
        if (turn.key >= least) continue;
        least = turn.key;
        nearest = side.leaving;
    }
    return nearest;
}

/// The border side after this one around the same gap.
HalfEdge nextBorder(const PointSet& points, const RepairState& m, HalfEdge border) {
    if (m.pinched[cornerOf(m, following(border))]) return acrossGap(points, m, border);
    HalfEdge h = following(border);
    while (m.twin[h] != kNone) h = following(m.twin[h]);
    return h;
}

/// True if no other triangle has the edge of this border side: one of three has no twins.
bool isLone(const RepairState& m, HalfEdge border) {
    const Index u = cornerOf(m, border);
    if (!m.pinched[u]) return true;
    const Index v = cornerOf(m, following(border));
    const auto sides = sidesOfPinched(m, u);
    return std::none_of(sides.begin(), sides.end(), [&](const PinchedSide& side) {
        return side.leaving != border && (cornerOf(m, following(side.leaving)) == v ||
                                          cornerOf(m, preceding(side.leaving)) == v);
    });
}

/// The border sides of a loop of 3 to `limit` different points; empty for others, where an edge has
/// more triangles, and unless `first` is the least of the sides.
std::vector<HalfEdge> loopFrom(const PointSet& points, const RepairState& m, HalfEdge first,
                               std::size_t limit) {
    std::vector<HalfEdge> loop;
    HalfEdge h = first;
    do {
        if (!isLone(m, h)) return {};
        loop.push_back(h);
        h = nextBorder(points, m, h);
        if (h == kNone || h < first || loop.size() > limit) return {};
    } while (h != first);
    std::vector<Index> seen;
    seen.reserve(loop.size());
    for (const HalfEdge side : loop) seen.push_back(cornerOf(m, side));
    std::sort(seen.begin(), seen.end());
    const bool simple = std::adjacent_find(seen.begin(), seen.end()) == seen.end();
    return simple && loop.size() >= 3 ? loop : std::vector<HalfEdge>{};
}

/// Mean distance of the points where the sides begin to their nearest neighbor.
double spacingAt(const PointSet& points, const std::vector<LoopSide>& loop) {
    double sum = 0.0;
    double count = 0.0;
    for (const LoopSide& side : loop) {
        if (points.neighbors[side.from].empty()) continue;
        sum += nearestDistance(points, side.from);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

/// True if the loop is no wider than Params::maxFillWidth.
bool isNarrow(const PointSet& points, const Params& params, const std::vector<LoopSide>& loop,
              const LoopShape& shape) {
    const double spacing = spacingAt(points, loop);
    return spacing <= 0.0 || shape.width() <= params.maxFillWidth * spacing;
}

/// True if the loop is to be closed: a hole or, where the user limits those, any loop within the
/// limits that neither runs along walls nor around a patch.
bool isToClose(const PointSet& points, const Params& params, const RepairState& m,
               const std::vector<HalfEdge>& border) {
    std::vector<LoopSide> loop;
    loop.reserve(border.size());
    for (const HalfEdge h : border) loop.push_back({cornerOf(m, h), cornerOf(m, following(h))});
    const LoopShape shape = shapeOf(points, loop);
    if (params.limitsHoles()) {
        if (!params.isWithinHoleLimits(shape.width(), loop.size())) return false;
        if (runsAlongWalls(points, loop)) return false;
    } else if (!isNarrow(points, params, loop, shape) || isOpening(points, loop, shape)) {
        return false;
    }
    const std::size_t largest = largestPatch(shape);
    return !(shape.turnsRoundPatch &&
             patchAt(m, border.front() / 3, largest + 1).size() <= largest);
}

HoleRing ringInside(const RepairState& m, const std::vector<HalfEdge>& border) {
    HoleRing ring;
    for (auto side = border.rbegin(); side != border.rend(); ++side) {
        ring.points.push_back(cornerOf(m, following(*side)));
        ring.outer.push_back(*side);
    }
    return ring;
}

/// Widens the ring by a point on it, which is taken out with its triangles; false unless that
/// leaves a ring of different points, none of the new ones pinched.
bool widenByPoint(const RepairState& m, std::size_t place, HoleRing& ring) {
    if (m.pinched[ring.points[place]]) return false;
    const std::size_t before = place == 0 ? ring.size() - 1 : place - 1;
    // Across the sides opposite to the point, in the direction of the ring; the points between
    // them.
    std::vector<HalfEdge> outer;
    std::vector<Index> between;
    HalfEdge last = kNone;
    for (HalfEdge h = ring.outer[before]; h != kNone && !isGone(ring, h / 3);) {
        if (!outer.empty()) between.push_back(cornerOf(m, following(h)));
        outer.push_back(m.twin[following(h)]);
        last = preceding(h);
        ring.gone.push_back(h / 3);
        h = m.twin[last];
    }
    // From the side before the point to the one after it.
    if (outer.empty() || last != ring.outer[place]) return false;
    if (std::any_of(between.begin(), between.end(),
                    [&](Index p) { return m.pinched[p] || isOn(ring, p); }))
        return false;
    const auto at = static_cast<std::ptrdiff_t>(place);
    ring.outer[before] = outer.front();
    ring.outer.erase(ring.outer.begin() + at);
    ring.outer.insert(ring.outer.begin() + at, outer.begin() + 1, outer.end());
    ring.points.erase(ring.points.begin() + at);
    ring.points.insert(ring.points.begin() + at, between.begin(), between.end());
    return ring.size() >= 3;
}

/// The search for a filling takes O(n^3) for n points, so that longer rings are left.
constexpr std::uint32_t kLongestRing = 64;

/// At most this often a ring is widened, and this many of its points are taken out: a hole is one
/// fault, as is a point that is left out.
constexpr int kMaxWidened = 24;
constexpr int kMaxTakenOut = 1;

/// The filling of the ring, which is widened where all triangles at a side would have a fault: the
/// old triangle across goes as well, or an end of the side. Empty if there is none.
Filling widenUntilFilled(const PointSet& points, RepairState& m, HoleRing& ring) {
    int takenOut = 0;
    // More room leaves the sides before the last blocked one as they are, not blocked.
    std::size_t side = 0;
    for (int i = 0; i < kMaxWidened; ++i) {
        FillingSearch search(points, m, ring);
        side = search.firstBlocked(side);
        if (side == ring.size()) return search.find();
        if (widenByTriangle(m, side, ring)) continue;
        if (++takenOut > kMaxTakenOut) return {};
        const HoleRing narrow = ring;
        if (!widenByPoint(m, side, ring)) {
            ring = narrow;
            if (!widenByPoint(m, (side + 1) % ring.size(), ring)) return {};
        }
        side = 0;
    }
    return {};
}

}  // namespace

std::optional<CloseHoleEvidence> closeNextHole(const PointSet& points, const Params& params,
                                               RepairState& m) {
    if (m.next == 0) listPinched(m);
    const std::uint32_t longest = std::min(params.maxFillLength, kLongestRing);
    while (m.next < m.twin.size()) {
        const auto found = std::find(m.twin.begin() + m.next, m.twin.end(), kNone);
        m.next = static_cast<Index>(found - m.twin.begin());
        if (found == m.twin.end()) break;
        const HalfEdge first = m.next++;
        const std::vector<HalfEdge> border = loopFrom(points, m, first, longest);
        if (border.empty() || !isToClose(points, params, m, border)) continue;
        HoleRing ring = ringInside(m, border);
        const Filling filling = widenUntilFilled(points, m, ring);
        if (filling.empty()) continue;
        const CloseHoleEvidence evidence{cornerOf(m, first), cornerOf(m, following(first)),
                                         static_cast<Index>(border.size())};
        const std::vector<Index> corners = cornersOf(m, ring.gone);
        putFilling(m, ring, filling);
        for (const Index p : corners) {
            if (isOn(ring, p)) continue;
            m.sideOf.set(p, kNone);
            ++m.takenOut;
        }
        ++m.closedHoles;
        if (isAnyPinched(m, ring.points)) listPinched(m);
        return evidence;
    }
    return std::nullopt;
}

}  // namespace se
