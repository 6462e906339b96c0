/// §4: the seed of a new component, and the set-up of the next pivot with its frame and sector.
#include <algorithm>
#include <vector>

#include "spiraling_edge/base/prefetch.h"
#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// The nearest listed neighbor that is UNUSED, kNone if there is none.
Index nearestUnused(const PointSet& points, const State& state, Index p) {
    const auto list = points.neighbors[p];
    const auto found =
        std::find_if(list.begin(), list.end(), [&](Index x) { return state.status[x] == kUnused; });
    return found == list.end() ? kNone : *found;
}

/// True if a listed neighbor is USED: its ring is shelved, and may yet take the point.
bool hasUsedNeighbor(const PointSet& points, const State& state, Index p) {
    const auto list = points.neighbors[p];
    return std::any_of(list.begin(), list.end(), [&](Index x) { return state.status[x] > 0; });
}

/// Marks a point DONE that no fan took (§4). `unseeded`: although neighbors are UNUSED.
void strand(AnyContext auto& context, Index p, bool unseeded = false) {
    State& s = context.state;
    context.change(p);
    s.finish(p);
    const bool isolated = context.points.neighbors[p].empty();
    ++(isolated ? s.counters.isolated : s.counters.stranded);
    noteAt(context, s.counters.pivots + 1, Stage::Strand, [&] {
        return StrandEvidence{p, isolated, unseeded};
    });
}

void beginRing(AnyContext auto& context, Index p, Index q) {
    State& s = context.state;
    for (const Index each : {p, q}) {
        context.change(each);
        s.status[each] = 1;
    }
    s.pivot.pivot = s.rings.start(p, q);
    s.circuit = 0;
    ++s.counters.seeds;
    s.counters.maxRingLength = std::max(s.counters.maxRingLength, 2U);
    s.phase = Phase::Pivot;
    noteAt(context, s.counters.pivots + 1, Stage::Seed, [&] {
        const Vec3 d = context.points.position[q] - context.points.position[p];
        return SeedEvidence{p, q, std::sqrt(glm::dot(d, d))};
    });
}

/// Marks the points DONE that waited for a shelved ring in vain, or began a ring in vain
/// (Readings::keepSeeds).
void strandRest(AnyContext auto& context) {
    const State& s = context.state;
    std::vector<StrandEvidence> rest;
    for (Index i = 0; i < s.status.size(); ++i) {
        const Index p = context.points.inOrder(i);
        if (s.status[p] == kUnused)
            rest.push_back({p, false, nearestUnused(context.points, s, p) != kNone});
    }
    for (const StrandEvidence& each : rest) strand(context, each.point, each.unseeded);
}

/// Takes up the rings that were shelved, since no seed is left that could join them; the last one
/// first, whatever PaperRules::stack.
void takeUpShelved(AnyContext auto& context) {
    State& s = context.state;
    const Index shelved = s.rings.shelved();
    s.seedsSpent = true;
    s.rings.unshelve();
    s.circuit = 0;
    s.retryLevel = 0;
    s.pivot.pivot = s.rings.pop();
    s.phase = Phase::Pivot;
    noteAt(context, s.counters.pivots + 1, Stage::Seed, [&] {
        return TakeUpEvidence{s.rings.point(s.pivot.pivot), shelved};
    });
}

/// Points lie in memory in any order, so that waiting for them would take a third of the time. The
/// next pivots are known from the ring: the data of the next one are prefetched now, and their
/// addresses for those after it.
[[gnu::always_inline]] inline void fetchAhead(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const NeighborLists& lists = context.points.neighbors;
    const Index next = context.state.pivot.last;
    for (const Index x : lists[rings.point(next)]) prefetch(&context.points.position[x]);
    prefetch(&context.points.normal[rings.point(next)]);
    const Index second = rings.next(next);
    const auto list = lists[rings.point(second)];
    prefetch(list.data());
    prefetch(list.data() + list.size());
    prefetch(&lists.offset[rings.point(rings.next(second))]);
}

/// The frame of an entry, and the angle of the entry after it.
struct Sector {
    Frame frame;
    bool fullTurn;
    Angle last;
};

Sector sectorAt(const StepContext& context, Index entry) {
    const Index first = context.state.rings.prev(entry);
    const Index last = context.state.rings.next(entry);
    const Frame frame = makeFrame(context.positionAt(entry), context.normalAt(entry),
                                  context.positionAt(first), context.params.robust.tangent);
    const bool fullTurn = context.state.rings.point(first) == context.state.rings.point(last);
    return {frame, fullTurn,
            fullTurn ? kFullTurn : angleOf(frame, context.positionAt(last) - frame.origin)};
}

/// Logs the pivot before §7 may insert a third point next to it.
void notePivot(AnyContext auto& context) {
    note(context, Stage::Pivot, [&] {
        const EdgeRings& rings = context.state.rings;
        const Index entry = context.state.pivot.pivot;
        return PivotEvidence{rings.point(entry), rings.point(rings.prev(entry)),
                             rings.point(rings.next(entry)), rings.length(rings.active()),
                             sectorDegrees(context, entry)};
    });
}

}  // namespace

double sectorDegrees(const StepContext& context, Index entry) {
    return sectorAt(context, entry).last.degrees();
}

void phaseSeed(AnyContext auto& context) {
    State& s = context.state;
    for (; s.startPointer < s.status.size(); ++s.startPointer) {
        const Index p = context.points.inOrder(s.startPointer);
        if (s.status[p] != kUnused) continue;
        const Index q = nearestUnused(context.points, s, p);
        if (q != kNone) {
            beginRing(context, p, q);
            return;
        }
        if (!hasUsedNeighbor(context.points, s, p)) strand(context, p);
    }
    if (s.rings.shelved() > 0) {
        takeUpShelved(context);
        return;
    }
    if (s.counters.shelved > 0 || s.counters.failedSeeds > 0) strandRest(context);
    beginRepairPhases(context);
}

void setPivot(StepContext& context, Index entry) {
    const EdgeRings& rings = context.state.rings;
    NeighborRing& n = context.state.pivot;
    n.pivot = entry;
    n.first = n.start = rings.prev(entry);
    n.last = n.end = rings.next(entry);
    const Sector sector = sectorAt(context, entry);
    n.fullTurn = sector.fullTurn;
    n.frame = sector.frame;
    n.startAngle = Angle{};
    n.lastAngle = n.endAngle = sector.last;
}

namespace {

/// True if the fan of the pivot is known to be refused. With a log it is made once more, for the
/// events.
template <AnyContext Context>
bool isRefusedAgain(const Context& context) {
    if (kLogging<Context> || context.waiting == nullptr) return false;
    const State& s = context.state;
    const Index entry = s.pivot.pivot;
    const Index p = s.rings.point(entry);
    return s.third.entry == kNone &&
           context.waiting->refuses(
               entry, s.retryLevel,
               {p, s.rings.point(s.rings.prev(entry)), s.rings.point(s.rings.next(entry))},
               context.points.neighbors[p]);
}

}  // namespace

void phasePivot(AnyContext auto& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    ++s.counters.pivots;
    s.pivotTriangles = 0;
    s.third = {};
    s.insertedEntries.clear();
    s.instances.clear();
    n.candidates.clear();
    const Index p = s.rings.point(n.pivot);
    notePivot(context);
    if (isBoundary(context.points.type[p]) && paperRules(context).walls &&
        !tryBoundaryPivot(context)) {
        ++s.counters.skipped;
        note(context, Stage::Skip, [&] { return SkipEvidence{p, context.points.type[p]}; });
        s.phase = Phase::Advance;
        return;
    }
    if (isRefusedAgain(context)) {
        ++s.counters.refused;
        s.phase = Phase::Advance;
        return;
    }
    setPivot(context, n.pivot);
    fetchAhead(context);
    s.phase = Phase::Sort;
}

template void phaseSeed(UnloggedContext&);
template void phaseSeed(LoggedContext&);
template void phasePivot(UnloggedContext&);
template void phasePivot(LoggedContext&);

}  // namespace se
