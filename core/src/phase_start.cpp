/// §4: finding where to begin, and taking up the next pivot.
#include <algorithm>

#include "phases.h"

namespace se {
namespace {

/// The nearest listed neighbor that is not DONE, kNone if there is none.
Index nearestNotDone(const PointSet& points, const State& state, Index p) {
    const auto list = points.neighbors[p];
    const auto found =
        std::find_if(list.begin(), list.end(), [&](Index x) { return state.status[x] != kDone; });
    return found == list.end() ? kNone : *found;
}

void beginRing(StepContext& context, Index p, Index q) {
    State& s = context.state;
    s.status[p] = 1;
    s.status[q] = 1;
    s.pivot.pivot = s.rings.start(p, q);
    s.circuit = 0;
    ++s.counters.seeds;
    s.counters.maxRingLength = std::max(s.counters.maxRingLength, 2U);
    s.phase = Phase::Pivot;
    if (context.log != nullptr) {
        const Vec3 d = context.points.position[q] - context.points.position[p];
        context.log->add(s.counters.pivots + 1, Stage::Seed,
                         SeedEvidence{p, q, std::sqrt(glm::dot(d, d))});
    }
}

}  // namespace

void phaseSeed(StepContext& context) {
    State& s = context.state;
    for (; s.startPointer < s.status.size(); ++s.startPointer) {
        const Index p = s.startPointer;
        if (s.status[p] == kDone) continue;
        const Index q = nearestNotDone(context.points, s, p);
        if (q != kNone) {
            beginRing(context, p, q);
            return;
        }
        s.status[p] = kDone;
        const bool isolated = context.points.neighbors[p].empty();
        ++(isolated ? s.counters.isolated : s.counters.stranded);
        if (context.log != nullptr) {
            context.log->add(s.counters.pivots + 1, Stage::Strand, StrandEvidence{p, isolated});
        }
    }
    beginMendPhases(context);
}

void phasePivot(StepContext& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    ++s.counters.pivots;
    s.pivotTriangles = 0;
    s.third = {};
    s.insertedEntries.clear();
    s.instances.clear();
    n.candidates.clear();
    const Index p = s.rings.point(n.pivot);
    note(context, Stage::Pivot, [&] {
        const Index first = s.rings.prev(n.pivot);
        const Index last = s.rings.next(n.pivot);
        const Frame frame = makeFrame(context.points.position[p], context.points.normal[p],
                                      context.positionAt(first), context.params.rules.tangent);
        const Angle sector =
            first == last ? kFullTurn : angleOf(frame, context.positionAt(last) - frame.origin);
        return PivotEvidence{p, s.rings.point(first), s.rings.point(last),
                             s.rings.length(s.rings.active()), sector.degrees()};
    });
    if (isBoundary(context.points.type[p]) && !admitBoundaryPivot(context)) {
        ++s.counters.skipped;
        note(context, Stage::Skip, [&] { return SkipEvidence{p, context.points.type[p]}; });
        s.phase = Phase::Advance;
        return;
    }
    n.first = n.start = s.rings.prev(n.pivot);
    n.last = n.end = s.rings.next(n.pivot);
    n.frame = makeFrame(context.points.position[p], context.points.normal[p],
                        context.positionAt(n.first), context.params.rules.tangent);
    n.lastAngle =
        n.fullTurn() ? kFullTurn : angleOf(n.frame, context.positionAt(n.last) - n.frame.origin);
    n.startAngle = Angle{};
    n.endAngle = n.lastAngle;
    s.phase = Phase::Sort;
}

}  // namespace se
