/// §6.5: the edge ring after a pivot: passed entries are released, candidates inserted, and points
/// met again split or join rings (one exchange of successors). Then the traversal continues, pops a
/// ring or ends the component; finished rings of two and rings freed by §7 are closed here, too.
/// O(fan) per pivot, plus relabeling of the shorter ring.
#include <algorithm>
#include <cassert>
#include <utility>

#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

void noteRing(AnyContext auto& context, Stage stage, Index x, bool inserted) {
    note(context, stage, [&] { return RingEvidence{x, inserted, context.state.status[x]}; });
}

/// Removes an entry and decrements its point's status (§4): at the last one the point becomes DONE.
void release(AnyContext auto& context, Index entry, Stage stage) {
    State& s = context.state;
    const Index x = s.rings.point(entry);
    assert(s.status[x] > 0);  // Invariant 1: the number of its entries.
    s.rings.erase(entry);
    if (s.status[x] == 1) {
        s.finish(x);
    } else {
        --s.status[x];
    }
    noteRing(context, stage, x, false);
}

/// As release(), for a point that need not be one of a new fan.
void releaseElsewhere(AnyContext auto& context, Index entry, Stage stage) {
    context.change(context.state.rings.point(entry));
    release(context, entry, stage);
}

void insertCandidates(AnyContext auto& context) {
    State& s = context.state;
    Index previous = s.pivot.start;
    for (const Candidate& c : s.pivot.candidates) {
        assert(s.status[c.point] != kDone);  // Invariant 7.
        previous = s.rings.insertAfter(previous, c.point);
        s.status[c.point] = s.status[c.point] + 1;
        s.insertedEntries.push_back(previous);
        s.instances.push_back(c.instance);
        noteRing(context, Stage::Ring, c.point, true);
    }
}

}  // namespace

void phaseRing(AnyContext auto& context) {
    State& s = context.state;
    const NeighborRing& n = s.pivot;
    release(context, n.pivot, Stage::Ring);
    for (Index e = n.first; e != n.start;) {
        release(context, std::exchange(e, s.rings.prev(e)), Stage::Ring);
    }
    for (Index e = n.last; e != n.end;) {
        release(context, std::exchange(e, s.rings.next(e)), Stage::Ring);
    }
    // The steps from start to end are now the rim of the new fan, all of them mesh edges.
    s.rings.setOpen(n.start, false);
    insertCandidates(context);
    if (s.third.entry != kNone) ++s.counters.inserted;
    s.phase = Phase::Link;
}

// ---- splits and joins ---------------------------------------------------------------------------

namespace {

/// The entry at which the traversal continues: end, or start by PaperRules::next. If that was
/// removed with a closed ring: end, else the last inserted entry that is left, else start. kNone if
/// nothing is left.
Index nextEntry(const AnyContext auto& context) {
    const State& s = context.state;
    if (paperRules(context).next == NextRule::Start && s.rings.alive(s.pivot.start)) {
        return s.pivot.start;
    }
    if (s.rings.alive(s.pivot.end)) return s.pivot.end;
    const auto left = std::find_if(s.insertedEntries.rbegin(), s.insertedEntries.rend(),
                                   [&](Index e) { return s.rings.alive(e); });
    if (left != s.insertedEntries.rend()) return *left;
    return s.rings.alive(s.pivot.start) ? s.pivot.start : kNone;
}

/// Closes a ring of two finished steps, or of a lone entry: Choice, see Readings::closeTwo.
void closeRingIfFinished(AnyContext auto& context, Index ring) {
    State& s = context.state;
    const Index length = s.rings.length(ring);
    const Index a = s.rings.head(ring);
    const Index b = s.rings.next(a);
    const bool lone = length == 1;
    const bool finishedEdge = length == 2 && context.params.readings.closeTwo &&
                              !context.openStep(a) && !context.openStep(b);
    if (!lone && !finishedEdge) return;
    note(context, Stage::Ring, [&] {
        return CloseEvidence{s.rings.point(a), lone ? kNone : s.rings.point(b)};
    });
    ++s.counters.closedRings;
    releaseElsewhere(context, a, Stage::Ring);
    if (!lone) releaseElsewhere(context, b, Stage::Ring);
}

/// True if the entry is alive and its two ring neighbors are entries of one point. Inline, since it
/// is rarely true.
[[gnu::always_inline]] inline bool isBetweenEntriesOfOnePoint(const EdgeRings& rings, Index entry) {
    return rings.alive(entry) && rings.point(rings.prev(entry)) == rings.point(rings.next(entry));
}

/// Closes the finished edge at an entry between two entries of one point, within a longer ring,
/// then those that become adjacent by it (Choice, see Readings::closeTwo). Equivalent to an
/// exchange of successors that splits off a finished ring of two.
void closeEdgeIfFinished(AnyContext auto& context, Index entry) {
    State& s = context.state;
    if (!isBetweenEntriesOfOnePoint(s.rings, entry)) return;
    const Index before = s.rings.prev(entry);
    const Index after = s.rings.next(entry);
    const bool finished = before != after && context.params.readings.closeTwo &&
                          !context.openStep(before) && !context.openStep(entry);
    if (!finished) return;
    const Index beyond = s.rings.next(after);
    const Index rest = s.rings.length(s.rings.ringOf(entry)) - 2;
    note(context, Stage::Ring, [&] {
        return CloseEvidence{s.rings.point(entry), s.rings.point(after), rest,
                             s.rings.depthFromTop(s.rings.ringOf(entry))};
    });
    s.rings.setOpen(before, s.rings.open(after));
    if (s.pivot.end == entry || s.pivot.end == after) s.pivot.end = beyond;
    if (s.pivot.start == entry || s.pivot.start == after) s.pivot.start = before;
    releaseElsewhere(context, entry, Stage::Ring);
    releaseElsewhere(context, after, Stage::Ring);
    closeRingIfFinished(context, s.rings.ringOf(before));
    closeEdgeIfFinished(context, before);
    closeEdgeIfFinished(context, beyond);
}

/// Closes the finished edges within longer rings where entries of this pivot were linked.
void closeEdgesAtLinks(AnyContext auto& context) {
    State& s = context.state;
    for (std::size_t i = 0; i < s.insertedEntries.size(); ++i) {
        if (s.instances[i] == kNone) continue;
        for (const Index e : {s.insertedEntries[i], s.instances[i]}) {
            closeEdgeIfFinished(context, e);
            if (s.rings.alive(e)) closeEdgeIfFinished(context, s.rings.next(e));
        }
    }
}

/// §6.5: true if the part with x is pushed. The other holds nextEntry(), usually end, unless
/// PaperRules::active chooses differently.
bool pushesX(const AnyContext auto& context, const Exchange& exchange) {
    const EdgeRings& rings = context.state.rings;
    const bool endIsElsewhere = rings.ringOf(nextEntry(context)) != exchange.ringOfX;
    const Index x = rings.length(exchange.ringOfX);
    const Index y = rings.length(exchange.ringOfY);
    switch (paperRules(context).active) {
        case ActiveRule::End:
            break;
        case ActiveRule::Other:
            return !endIsElsewhere;
        case ActiveRule::Longer:
            return x == y ? endIsElsewhere : x < y;
        case ActiveRule::Shorter:
            return x == y ? endIsElsewhere : x > y;
    }
    return endIsElsewhere;
}

/// §6.5: the part that holds end stays active, the other is pushed. Choice: the pushed part goes
/// on, when it is taken from the stack, at its entry of the point where it was split off; the paper
/// names no pivot for it.
void placeSplitRings(AnyContext auto& context, const Exchange& exchange, Index x, Index y) {
    State& s = context.state;
    ++s.counters.splits;
    const bool wasActive =
        exchange.ringOfX == s.rings.active() || exchange.ringOfY == s.rings.active();
    bool pushX = s.rings.depthFromTop(exchange.ringOfX) == kNone;  // Else x's part is stacked.
    if (wasActive) {
        pushX = pushesX(context, exchange);
        s.rings.activate(pushX ? exchange.ringOfY : exchange.ringOfX);
    }
    const Index pushed = pushX ? exchange.ringOfX : exchange.ringOfY;
    s.rings.numberSplit(pushed, pushX ? exchange.ringOfY : exchange.ringOfX);
    s.rings.push(pushed, pushX ? x : y);
    note(context, Stage::Split, [&] {
        return SplitEvidence{s.rings.point(x),
                             s.rings.length(pushX ? exchange.ringOfY : exchange.ringOfX),
                             s.rings.length(pushX ? exchange.ringOfX : exchange.ringOfY),
                             static_cast<Index>(s.rings.stack().size())};
    });
}

/// Links an inserted point that already has an entry on a ring: exchanges successors with that
/// entry.
void link(AnyContext auto& context, Index x, Index y) {
    State& s = context.state;
    const Index depth = s.rings.depthFromTop(s.rings.ringOf(y));
    const Exchange exchange = s.rings.exchangeSuccessors(x, y);
    if (exchange.split) {
        placeSplitRings(context, exchange, x, y);
    } else {
        ++s.counters.joins;
        note(context, Stage::Join, [&] {
            return JoinEvidence{s.rings.point(x), depth, s.rings.length(exchange.ringOfX)};
        });
    }
    s.counters.maxStackDepth =
        std::max(s.counters.maxStackDepth, static_cast<std::uint32_t>(s.rings.stack().size()));
    if (s.rings.alive(x)) closeRingIfFinished(context, s.rings.ringOf(x));
    if (s.rings.alive(y)) closeRingIfFinished(context, s.rings.ringOf(y));
}

}  // namespace

void phaseLink(AnyContext auto& context) {
    State& s = context.state;
    bool linked = false;
    for (std::size_t i = 0; i < s.insertedEntries.size(); ++i) {
        const Index x = s.insertedEntries[i];
        Index& y = s.instances[i];
        // "The first other instance" is sought on the rings as the points before it left them.
        const bool seeks = paperRules(context).instance == InstanceRule::First && y != kNone;
        if (seeks && s.rings.alive(x)) y = s.rings.firstInstance(s.rings.point(x), x);
        if (!s.rings.alive(x) || !s.rings.alive(y)) continue;
        link(context, x, y);
        linked = true;
    }
    if (s.rings.active() != kNone) closeRingIfFinished(context, s.rings.active());
    for (const Index e : {s.pivot.start, s.pivot.end}) {
        // closeEdgeIfFinished() tests this as well; without the call a run takes 1 percent less.
        if (isBetweenEntriesOfOnePoint(s.rings, e)) closeEdgeIfFinished(context, e);
    }
    // A single candidate between two entries of one point.
    if (s.insertedEntries.size() == 1) closeEdgeIfFinished(context, s.insertedEntries.front());
    if (linked) closeEdgesAtLinks(context);
    if (s.rings.active() != kNone) {
        s.counters.maxRingLength =
            std::max(s.counters.maxRingLength, s.rings.length(s.rings.active()));
    }
    s.phase = Phase::Advance;
}

// ---- the next pivot -----------------------------------------------------------------------------

namespace {

void alert(AnyContext auto& context, AlertKind kind, Index point) {
    State& s = context.state;
    s.alerts.push_back({kind, s.counters.pivots, point});
    note(context, Stage::Done, [&] { return AlertEvidence{kind, point}; });
}

/// True if the active ring has two entries and no mesh edge, as a seed.
bool isSeed(const EdgeRings& rings) {
    const Index head = rings.head(rings.active());
    return rings.length(rings.active()) == 2 && rings.open(head) && rings.open(rings.next(head));
}

/// True if the active ring is a seed whose points stay (Readings::keepSeeds): none of their
/// neighbors is on a ring, in a triangle or stranded.
bool keepsPoints(const StepContext& context) {
    const State& s = context.state;
    if (!context.params.readings.keepSeeds || !isSeed(s.rings)) return false;
    const auto pair = s.rings.entriesOf(s.rings.active());
    return std::all_of(pair.begin(), pair.end(), [&](Index e) {
        const auto list = context.points.neighbors[s.rings.point(e)];
        return std::all_of(list.begin(), list.end(), [&](Index x) {
            return s.status[x] == kUnused || x == s.rings.point(s.rings.next(e));
        });
    });
}

/// Choice, see Readings::keepSeeds: the points of a seed without a triangle are UNUSED again. The
/// start pointer passes its first point, so that the next seed is another one.
void freeFailedSeed(AnyContext auto& context) {
    State& s = context.state;
    const Index ring = s.rings.active();
    const Index start =
        s.startPointer < s.status.size() ? context.points.inOrder(s.startPointer) : kNone;
    Index interior = 0;
    for (int i = 0; i < 2; ++i) {
        const Index e = s.rings.head(ring);
        const Index x = s.rings.point(e);
        if (x == start) ++s.startPointer;
        if (!isBoundary(context.points.type[x])) ++interior;
        context.change(x);
        s.rings.erase(e);
        s.status[x] = kUnused;
        noteRing(context, Stage::Done, x, false);
    }
    ++s.counters.failedSeeds;
    note(context, Stage::Done, [&] { return FreeEvidence{2, interior, true}; });
}

bool isOnRing(const EdgeRings& rings, Index point, Index ring) {
    Index e = rings.firstEntryOf(point);
    while (e != kNone && rings.ringOf(e) != ring) e = rings[e].nextOfPoint;
    return e != kNone;
}

/// §7: "Then the algorithm marks the boundary points as DONE and frees the edge ring."
void freeActiveRing(AnyContext auto& context) {
    State& s = context.state;
    const Index ring = s.rings.active();
    const Index length = s.rings.length(ring);
    const bool lostSeed = isSeed(s.rings);
    const bool opening = isOpening(context);
    Index interior = 0;
    Index example = kNone;
    const Index head = s.rings.point(s.rings.head(ring));
    for (Index i = 0; i < length; ++i) {
        const Index e = s.rings.head(ring);
        const Index x = s.rings.point(e);
        const bool isInterior = !isBoundary(context.points.type[x]);
        if (isInterior && example == kNone) example = x;
        releaseElsewhere(context, e, Stage::Done);
        // A point may have several entries on the ring.
        if (isInterior && !isOnRing(s.rings, x, ring)) ++interior;
    }
    if (example == kNone) example = head;
    ++s.counters.freedRings;
    note(context, Stage::Done, [&] { return FreeEvidence{length, interior}; });
    if (lostSeed) {
        ++s.counters.lostSeeds;
        alert(context, AlertKind::LostSeed, example);
    } else if (opening) {
        ++s.counters.openings;
    } else if (interior > 0) {
        ++s.counters.holes;
        alert(context, AlertKind::Hole, example);
    }
}

/// Pops the ring on top of the stack; if there is none, a seed is next.
void popRing(AnyContext auto& context) {
    State& s = context.state;
    s.circuit = 0;
    s.retryLevel = 0;
    const bool oldest = paperRules(context).stack == StackRule::First;
    s.pivot.pivot = oldest ? s.rings.popOldest() : s.rings.pop();
    s.phase = s.pivot.pivot == kNone ? Phase::Seed : Phase::Pivot;
    note(context, Stage::Advance, [&] {
        const bool popped = s.pivot.pivot != kNone;
        return AdvanceEvidence{popped ? s.rings.point(s.pivot.pivot) : kNone, 0, popped, false,
                               popped ? 0 : s.rings.shelved()};
    });
}

/// Pops the ring on top of the stack, or ends the component if there is none.
void popRingOrFinish(AnyContext auto& context) {
    popRing(context);
    const State& s = context.state;
    // A component with a ring on the shelf may go on.
    if (s.pivot.pivot != kNone || s.rings.shelved() > 0) return;
    note(context, Stage::Done, [&] {
        return ComponentEvidence{s.counters.seeds - s.counters.failedSeeds,
                                 static_cast<std::uint32_t>(s.triangles.size())};
    });
}

void continueAt(AnyContext auto& context, Index entry) {
    State& s = context.state;
    s.pivot.pivot = entry;
    s.phase = Phase::Pivot;
    note(context, Stage::Advance, [&] {
        return AdvanceEvidence{s.rings.point(entry), s.circuit, false};
    });
}

void advanceAfterTriangles(AnyContext auto& context) {
    State& s = context.state;
    s.circuit = 0;
    s.retryLevel = 0;
    Index entry = nextEntry(context);
    // The part that stays active need not hold end.
    if (paperRules(context).active != ActiveRule::End && s.rings.active() != kNone &&
        s.rings.ringOf(entry) != s.rings.active()) {
        entry = s.rings.head(s.rings.active());
    }
    if (entry == kNone) {
        popRingOrFinish(context);
        return;
    }
    if (s.rings.ringOf(entry) != s.rings.active()) s.rings.activate(s.rings.ringOf(entry));
    continueAt(context, entry);
}

/// Relaxes the next rule for a ring without a triangle in a full circuit (State::retryLevel). False
/// if there is none left to relax.
bool relaxRules(AnyContext auto& context) {
    State& s = context.state;
    if (context.params.robust.delay && s.retryLevel < kCornerAllowed) {
        ++s.retryLevel;
        s.circuit = 0;
        continueAt(context, s.rings.next(s.pivot.pivot));
        return true;
    }
    if (context.params.robust.fill && s.retryLevel < kFillFailed && mayFill(context)) {
        s.circuit = 0;
        s.phase = Phase::Fill;
        return true;
    }
    return false;
}

/// True if the active ring is to wait for other components (RobustRules::shelve), after delayed
/// fans were tried. A seed without a triangle does not wait.
bool mayShelve(const AnyContext auto& context) {
    const State& s = context.state;
    const RobustRules& rules = context.params.robust;
    if (!rules.shelve || s.seedsSpent) return false;
    if (rules.delay && s.retryLevel < kDelayedAllowed) return false;
    return !isSeed(s.rings);
}

/// Puts the active ring on the shelf.
void shelveActiveRing(AnyContext auto& context) {
    State& s = context.state;
    note(context, Stage::Done, [&] {
        return ShelveEvidence{s.rings.length(s.rings.active()), s.rings.shelved()};
    });
    s.rings.shelve(s.rings.next(s.pivot.pivot));
    ++s.counters.shelved;
    s.counters.maxStackDepth =
        std::max(s.counters.maxStackDepth, static_cast<std::uint32_t>(s.rings.stack().size()));
}

void advanceWithoutTriangles(AnyContext auto& context) {
    State& s = context.state;
    removeThirdPoint(context);
    ++s.circuit;
    if (s.retryLevel < kFillFailed && s.circuit < s.rings.length(s.rings.active())) {
        continueAt(context, s.rings.next(s.pivot.pivot));
        return;
    }
    if (mayShelve(context)) {
        shelveActiveRing(context);
        popRingOrFinish(context);
        return;
    }
    if (relaxRules(context)) return;
    if (keepsPoints(context)) {
        freeFailedSeed(context);
        popRing(context);
        return;
    }
    freeActiveRing(context);
    popRingOrFinish(context);
}

}  // namespace

void phaseAdvance(AnyContext auto& context) {
    State& s = context.state;
    if (s.pivotTriangles > 0) {
        advanceAfterTriangles(context);
    } else {
        advanceWithoutTriangles(context);
    }
    if constexpr (kLogging<std::remove_reference_t<decltype(context)>>) redirect(context);
    // The paper's own rules need not terminate on tangled input; the cap does.
    const std::size_t cap =
        std::size_t{context.params.maxTrianglesPerPoint} * context.points.size();
    if (s.triangles.size() > cap) {
        alert(context, AlertKind::TriangleCap, s.triangles.back().a);
        finishRun(context);
    }
}

template void phaseRing(UnloggedContext&);
template void phaseRing(LoggedContext&);
template void phaseLink(UnloggedContext&);
template void phaseLink(LoggedContext&);
template void phaseAdvance(UnloggedContext&);
template void phaseAdvance(LoggedContext&);

}  // namespace se
