/// RobustRules::reinsert: a stranded point splits the triangle or the edge it lies over, or is
/// joined to the border next to it, whichever has the best angles without a fault.
#include <algorithm>
#include <array>

#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

enum class Way : std::uint8_t { SplitTriangle, SplitEdge, JoinBorder };

/// A place for the point, and the quality of its triangles.
struct Insertion {
    Way way = Way::SplitTriangle;
    HalfEdge side = kNone;
    double cosine =
        2.0;  ///< Cosine of the least angle of the new triangles: the smaller, the better.
};

/// The new triangles of one way, and the old ones that they replace.
struct Change {
    std::array<Triangle, 4> made{};
    std::array<HalfEdge, 4> outer{};  ///< Side of each one's old edge, as the old triangle has it.
    std::size_t count = 0;
    std::array<Index, 2> gone{kNone, kNone};

    void add(const RepairState& m, HalfEdge side, Index x) {
        made[count] = {cornerOf(m, side), cornerOf(m, following(side)), x};
        outer[count++] = m.twin[side];
    }
};

Change changeFor(const RepairState& m, Way way, HalfEdge h, Index x) {
    Change c;
    switch (way) {
        case Way::SplitTriangle:
            for (const HalfEdge side : {h, following(h), preceding(h)}) c.add(m, side, x);
            c.gone[0] = h / 3;
            break;
        case Way::SplitEdge: {
            const HalfEdge g = m.twin[h];
            for (const HalfEdge side : {following(h), preceding(h), following(g), preceding(g)}) {
                c.add(m, side, x);
            }
            c.gone = {h / 3, g / 3};
            break;
        }
        case Way::JoinBorder:
            c.made[0] = {cornerOf(m, following(h)), cornerOf(m, h), x};
            c.outer[0] = h;
            c.count = 1;
            break;
    }
    return c;
}

/// True if the new triangles meet any other one nearby.
bool meetsOthers(const PointSet& points, const RepairState& m, const Change& change, Index x) {
    bool found = false;
    const auto test = [&](Index t) {
        if (found || t == change.gone[0] || t == change.gone[1]) return;
        for (std::size_t i = 0; i < change.count && !found; ++i) {
            found = trianglesShareMore(points.position, change.made[i], m.triangles[t]);
        }
    };
    for (const Index near : points.neighbors[x]) {
        forEachSideOf(m, near, [&](HalfEdge side) { test(side / 3); });
    }
    return found;
}

/// The least angle's cosine, 2 if a triangle would have a fault.
double leastAngleCosineOf(const PointSet& points, const Change& change, const RepairState& m) {
    double worst = -1.0;
    for (std::size_t i = 0; i < change.count; ++i) {
        const Triangle& t = change.made[i];
        // In the last round a single corner's normal may be against it, as in the last circuit of
        // a ring (kCornerAllowed).
        if (shapeFaults(points, t) > (m.round + 1 < kRepairRounds ? 0 : 1)) return 2.0;
        const HalfEdge outer = change.outer[i];
        if (outer != kNone && folded(points, t, m.triangles[outer / 3])) return 2.0;
        worst = std::max(worst, leastAngleCosine(points, t));
    }
    // Triangles almost without width are worse than a point that is left out.
    constexpr double kThin = 0.9998;  // 1.1 degrees.
    return worst < kThin ? worst : 2.0;
}

/// Tries one way; keeps it if it is better than the best so far.
void consider(const PointSet& points, const RepairState& m, Way way, HalfEdge side, Index x,
              Insertion& best) {
    const Change change = changeFor(m, way, side, x);
    const double cosine = leastAngleCosineOf(points, change, m);
    if (cosine < best.cosine && !meetsOthers(points, m, change, x)) best = {way, side, cosine};
}

Insertion findInsertion(const PointSet& points, const RepairState& m, Index x) {
    Insertion best;
    for (const Index near : points.neighbors[x]) {
        if (m.pinched[near]) continue;
        forEachSideOf(m, near, [&](HalfEdge h) {
            consider(points, m, Way::SplitTriangle, h, x, best);
            for (const HalfEdge side : {h, following(h)}) {
                const bool border = m.twin[side] == kNone;
                consider(points, m, border ? Way::JoinBorder : Way::SplitEdge, side, x, best);
            }
        });
    }
    return best;
}

/// Stores the new triangles in the places of the old ones and at the end of the list.
void apply(RepairState& m, const Change& change, Index x) {
    std::array<HalfEdge, 4> base{};
    for (std::size_t i = 0; i < change.count; ++i) {
        const bool reuse = i < 2 && change.gone[i] != kNone;
        const auto t = reuse ? change.gone[i] : static_cast<Index>(m.triangles.size());
        if (!reuse) {
            m.triangles.emplace_back();
            m.twin.resize(m.twin.size() + 3, kNone);
        }
        base[i] = 3 * t;
        m.triangles[t] = change.made[i];
    }
    for (std::size_t i = 0; i < change.count; ++i) {
        for (const HalfEdge side : {base[i], base[i] + 1, base[i] + 2}) m.twin[side] = kNone;
    }
    for (std::size_t i = 0; i < change.count; ++i) {
        pair(m, base[i], change.outer[i]);
        m.sideOf[change.made[i].a] = base[i];
        m.sideOf[change.made[i].b] = base[i] + 1;
        for (std::size_t j = 0; j < change.count; ++j) {
            // The side b -> x of one lies on the side x -> a of the next.
            if (change.made[j].a == change.made[i].b) pair(m, base[i] + 1, base[j] + 2);
        }
        m.queue.push_back(base[i]);
        m.queue.push_back(base[i] + 1);
    }
    m.sideOf[x] = base[0] + 2;
}

}  // namespace

std::optional<ReinsertEvidence> reinsertNext(const PointSet& points, RepairState& m) {
    for (; m.nextPoint < points.size(); ++m.nextPoint) {
        const Index x = points.inOrder(m.nextPoint);
        if (m.sideOf[x] != kNone || points.neighbors[x].empty()) continue;
        const Insertion place = findInsertion(points, m, x);
        if (place.side == kNone) continue;
        apply(m, changeFor(m, place.way, place.side, x), x);
        ++m.reinserted;
        ++m.nextPoint;
        return ReinsertEvidence{x};
    }
    return std::nullopt;
}

}  // namespace se
