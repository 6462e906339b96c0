/// §6.1, Figs. 4 to 6: start and end advance while the ring is concave (Fig. 4), and candidates
/// outside are dropped; USED candidates must then pass the convexity test (Fig. 5) and, at one of
/// their entries, the reciprocal test (Fig. 6). O(list) for each move, plus the entries of USED
/// candidates.
#include <algorithm>

#include "spiraling_edge/stepper/step_context.h"

namespace se {

// ---- §6.1: limits -------------------------------------------------------------------------------

namespace {

/// The entry beyond start (its predecessor) or beyond end (its successor).
Index beyond(const State& s, Side side) {
    return side == Side::Start ? s.rings.prev(s.pivot.start) : s.rings.next(s.pivot.end);
}

/// RobustRules::unblocked: the first candidate that lies in the circumsphere of the triangle that a
/// move of start or end to `to` would make; kNone if none does. UNUSED ones count in the triangle's
/// sector, where they would be enclosed; USED ones outside it if nearer than `to`, since the new
/// spoke would pass close to them.
Index blockerOf(const StepContext& context, Side side, const Angle& toAngle, const Vec3& to) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const bool atStart = side == Side::Start;
    const Vec3 a = context.positionAt(atStart ? n.start : n.end) - n.frame.origin;
    const Vec3 b = to - n.frame.origin;
    const double aSq = glm::dot(a, a);
    const double bSq = glm::dot(b, b);
    const double low = atStart ? n.startAngle.key : toAngle.key;
    const double high = atStart ? toAngle.key : n.endAngle.key;
    const auto found =
        std::find_if(n.candidates.begin(), n.candidates.end(), [&](const Candidate& c) {
            const bool inSector = c.angle.key > low && c.angle.key < high;
            const bool inTheWay =
                s.status[c.point] == kUnused ? inSector : !inSector && c.lengthSq < bSq;
            return inTheWay && testSphere(a, aSq, b, bSq, c.offset, c.lengthSq).inside();
        });
    return found == n.candidates.end() ? kNone : found->point;
}

/// Choice, see Readings::belowHalfTurn: true if a move of start or end to this angle would make a
/// triangle of 180 degrees or more at the pivot.
bool spansHalfTurn(const StepContext& context, Side side, const Angle& to) {
    const NeighborRing& n = context.state.pivot;
    const double span = side == Side::Start ? to.key - n.startAngle.key : n.endAngle.key - to.key;
    return span >= kHalfTurnKey - context.params.sameAngle;
}

/// True if start and end may move along the ring, and ring points beyond them may be dropped: not
/// on a fresh ring of two. Choice: between two entries of one point in a longer ring they may with
/// Readings::closeTwo off, by which such a place is one like any other.
bool hasBeyond(const StepContext& context) {
    const NeighborRing& n = context.state.pivot;
    return !n.fullTurn || (n.first != n.last && !context.params.readings.closeTwo);
}

/// Whether the ring is concave at start or end.
ConcaveTest concaveAt(const StepContext& context, Side side) {
    const State& s = context.state;
    const bool atStart = side == Side::Start;
    const Index limit = atStart ? s.pivot.start : s.pivot.end;
    const Vec3& to = context.positionAt(beyond(s, side));
    const Vec3& p = s.pivot.frame.origin;
    return testConcave(context.positionAt(limit), context.normalAt(limit), atStart ? to : p,
                       atStart ? p : to);
}

/// The result of a test of the point beyond start or end.
struct LimitTest {
    Verdict verdict;
    Index to = kNone;  ///< Entry.
    Angle angle{};     ///< Angle of `to`, where it was needed.
    Index blocker = kNone;
};

template <bool kEveryTest>
LimitTest testLimit(const StepContext& context, Side side) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const bool atStart = side == Side::Start;
    const Index limit = atStart ? n.start : n.end;
    const Index to = beyond(s, side);
    if (to == (atStart ? n.end : n.start) || to == n.pivot) return {Verdict::OtherLimit, to};
    if (context.openStep(atStart ? to : limit)) return {Verdict::NotAnEdge, to};
    const Vec3& position = context.positionAt(to);
    const ConcaveTest concave = concaveAt(context, side);
    // Without a log the paper's rules have their defaults (paperRules()).
    const bool mayMove = concave.concave() || (kEveryTest && !context.params.paper.concave);
    // The cheap test that fails most often comes first, unless the log needs the others.
    if (!kEveryTest && !mayMove) return {Verdict::NotConcave, to};
    if (!context.points.neighbors.has(s.rings.point(n.pivot), s.rings.point(to)))
        return {Verdict::NotListed, to};
    LimitTest test{Verdict::Moved, to, angleOf(n.frame, position - n.frame.origin)};
    if (!strictlyBetween(test.angle, n.startAngle, n.endAngle, context.params.sameAngle)) {
        test.verdict = Verdict::Outside;
    } else if (!mayMove) {
        test.verdict = Verdict::NotConcave;
    } else if (context.params.readings.belowHalfTurn && spansHalfTurn(context, side, test.angle)) {
        test.verdict = Verdict::HalfTurn;
    } else if (context.params.robust.unblocked) {
        test.blocker = blockerOf(context, side, test.angle, position);
        if (test.blocker != kNone) test.verdict = Verdict::Blocked;
    }
    return test;
}

/// The verdict on a candidate next on the ring beyond start or end, by the verdict by which that
/// limit stayed.
Verdict verdictBeyond(Verdict stayed) {
    switch (stayed) {
        case Verdict::NotConcave:
            return Verdict::BeyondConvex;
        case Verdict::HalfTurn:
            return Verdict::BeyondHalfTurn;
        case Verdict::Blocked:
            return Verdict::BeyondBlocked;
        default:
            return Verdict::BeyondOther;
    }
}

/// Recomputes the test for the log, with the numbers that it did not need as well.
LimitEvidence explainLimit(const StepContext& context, Side side) {
    const State& s = context.state;
    const bool atStart = side == Side::Start;
    const LimitTest test = testLimit<true>(context, side);
    const Vec3 offset = context.positionAt(test.to) - s.pivot.frame.origin;
    return {side,
            s.rings.point(atStart ? s.pivot.start : s.pivot.end),
            s.rings.point(test.to),
            concaveAt(context, side).turn,
            (atStart ? s.pivot.startAngle : s.pivot.endAngle).degrees(),
            angleOf(s.pivot.frame, offset).degrees(),
            test.verdict,
            test.blocker};
}

/// Advances start or end by one entry if §6.1 (Fig. 4) allows it.
template <AnyContext Context>
bool moveLimit(Context& context, Side side) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    Index& limit = side == Side::Start ? n.start : n.end;
    Angle& angle = side == Side::Start ? n.startAngle : n.endAngle;
    const LimitTest test = testLimit<kLogging<Context>>(context, side);
    // A what-if can override only these verdicts.
    const bool open = test.verdict == Verdict::Moved || test.verdict == Verdict::NotConcave ||
                      test.verdict == Verdict::HalfTurn || test.verdict == Verdict::Blocked;
    const auto forced = open ? whatIfOverride(context, Stage::Limits, s.rings.point(test.to))
                             : std::optional<bool>{};
    const bool moves = forced.value_or(test.verdict == Verdict::Moved);
    note(context, Stage::Limits, [&] {
        LimitEvidence evidence = explainLimit(context, side);
        evidence.verdict =
            applyOverride(evidence.verdict, forced, evidence.verdict == Verdict::Moved);
        (side == Side::Start ? s.beyondStart : s.beyondEnd) = verdictBeyond(evidence.verdict);
        return evidence;
    });
    if (!moves) return false;
    limit = test.to;
    angle = test.angle;
    return true;
}

/// Readings::limitsFirst off: each candidate is tested once, in list order.
void moveLimitsAsNeighborsCome(AnyContext auto& context) {
    const State& s = context.state;
    const std::vector<Candidate>& all = s.pivot.candidates;
    for (const Index x : context.points.neighbors[s.rings.point(s.pivot.pivot)]) {
        const bool added =
            std::any_of(all.begin(), all.end(), [x](const Candidate& c) { return c.point == x; });
        if (!added) continue;
        for (const Side side : {Side::Start, Side::End}) {
            if (x == s.rings.point(beyond(s, side)) && moveLimit(context, side)) break;
        }
    }
}

void moveLimits(AnyContext auto& context) {
    if (!context.params.readings.limitsFirst) return moveLimitsAsNeighborsCome(context);
    while (moveLimit(context, Side::Start)) {
    }
    while (moveLimit(context, Side::End)) {
    }
}

/// The result of testing a candidate.
struct DropTest {
    Verdict verdict;
    Side side;
};

/// Drops the candidates for which the verdict of `test` is not Kept.
template <typename Test>
void dropCandidates(AnyContext auto& context, Stage stage, Test&& test) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
    std::size_t kept = 0;
    for (const Candidate& c : all) {
        const DropTest found = test(c);
        const Verdict verdict =
            stage == Stage::Limits
                ? found.verdict
                : applyOverride(found.verdict, whatIfOverride(context, stage, c.point),
                                found.verdict == Verdict::Kept);
        if (verdict != Verdict::Kept) {
            note(context, stage, [&] {
                return DropEvidence{c.point, found.side, c.angle.degrees(), verdict};
            });
        }
        if (verdict == Verdict::Kept || verdict == Verdict::WhatIfKept) {
            if (&all[kept] != &c) all[kept] = c;
            ++kept;
        }
    }
    all.resize(kept);
}

}  // namespace

void phaseLimits(AnyContext auto& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    s.phase = Phase::Convex;
    s.beyondStart = s.beyondEnd = Verdict::BeyondOther;
    if (!hasBeyond(context) || !paperRules(context).limits) return;
    moveLimits(context);
    if (n.start == n.first && n.end == n.last) return;
    const Index atStart = s.rings.point(n.start);
    const Index atEnd = s.rings.point(n.end);
    dropCandidates(context, Stage::Limits, [&](const Candidate& c) {
        const bool behindStart =
            c.point == atStart || !(c.angle.key > n.startAngle.key + context.params.sameAngle);
        const bool hasEnd = paperRules(context).maxAngle || n.end != n.last;
        const bool behindEnd =
            c.point == atEnd ||
            (hasEnd && !(c.angle.key < n.endAngle.key - context.params.sameAngle));
        if (behindStart) {
            return DropTest{c.point == atStart ? Verdict::NowStart : Verdict::Outside, Side::Start};
        }
        if (!behindEnd) return DropTest{Verdict::Kept, Side::End};
        return DropTest{c.point == atEnd ? Verdict::NowEnd : Verdict::Outside, Side::End};
    });
}

// ---- §6.1: convexity and reciprocity ------------------------------------------------------------

void phaseConvex(AnyContext auto& context) {
    State& s = context.state;
    s.phase = Phase::Reciprocal;
    if (!hasBeyond(context) || !paperRules(context).convex) return;
    // Choice: a point with another entry elsewhere is left to the reciprocal test of that entry,
    // and one that start or end did not move to is dropped, whatever the reason. As printed, each
    // is dropped that is beyond a convex start or end, and no other.
    const bool printed = paperRules(context).convexShared;
    const bool dropsAtStart = !printed || !concaveAt(context, Side::Start).concave();
    const bool dropsAtEnd = !printed || !concaveAt(context, Side::End).concave();
    const Index beyondStart = s.rings.point(beyond(s, Side::Start));
    const Index beyondEnd = s.rings.point(beyond(s, Side::End));
    dropCandidates(context, Stage::Convex, [&](const Candidate& c) {
        const bool tested = s.status[c.point] == 1 || (printed && s.status[c.point] > 1);
        if (tested && dropsAtStart && c.point == beyondStart)
            return DropTest{printed ? Verdict::BeyondConvex : s.beyondStart, Side::Start};
        if (tested && dropsAtEnd && c.point == beyondEnd)
            return DropTest{printed ? Verdict::BeyondConvex : s.beyondEnd, Side::End};
        return DropTest{Verdict::Kept, Side::End};
    });
}

namespace {

/// RobustRules::wallsDone: both ring neighbors of a boundary point share a wall with it, so that
/// its sector lies outside the box.
bool completeAlongWalls(const StepContext& context, Index entry) {
    const EdgeRings& rings = context.state.rings;
    const auto type = [&](Index e) { return context.points.type[rings.point(e)]; };
    return shareFace(type(entry), type(rings.prev(entry))) &&
           shareFace(type(entry), type(rings.next(entry)));
}

/// The entry of the USED candidate whose sector holds the pivot, kNone if none does.
Index findInstance(AnyContext auto& context, const Candidate& candidate) {
    const State& s = context.state;
    const PaperRules& paper = paperRules(context);
    const EdgeRings& rings = s.rings;
    const auto forced = whatIfOverride(context, Stage::Reciprocal, candidate.point);
    Index found = kNone;
    for (Index e = rings.firstEntryOf(candidate.point); e != kNone; e = rings[e].nextOfPoint) {
        const Index before = rings.prev(e);
        const Index after = rings.next(e);
        const bool free = context.params.readings.freeSector;
        const ReciprocalTest test = testReciprocal(
            context.points.position[candidate.point], context.points.normal[candidate.point],
            context.positionAt(free ? before : after), context.positionAt(free ? after : before),
            rings.point(before) == rings.point(after), s.pivot.frame.origin,
            context.params.sameAngle, context.params.robust.tangent);
        const bool complete = context.params.robust.wallsDone && completeAlongWalls(context, e);
        const bool holds = test.inside && !complete;
        note(context, Stage::Reciprocal, [&] {
            const Verdict verdict = complete      ? Verdict::WallComplete
                                    : test.inside ? Verdict::Kept
                                                  : Verdict::NotReciprocal;
            return ReciprocalEvidence{candidate.point,
                                      rings.point(before),
                                      rings.point(after),
                                      test.pivot.degrees(),
                                      test.limit.degrees(),
                                      applyOverride(verdict, forced, holds),
                                      !free};
        });
        if (holds && (found == kNone || rings.isFoundBefore(e, found))) found = e;
    }
    if (forced == false) return kNone;
    if (found == kNone && forced != true) return kNone;
    const bool first = found == kNone || paper.instance == InstanceRule::First;
    return first ? rings.firstInstance(candidate.point, s.pivot.pivot) : found;
}

}  // namespace

void phaseReciprocal(AnyContext auto& context) {
    State& s = context.state;
    std::vector<Candidate>& all = s.pivot.candidates;
    std::size_t kept = 0;
    for (Candidate& c : all) {
        if (s.status[c.point] > 0) {
            c.instance = paperRules(context).reciprocal
                             ? findInstance(context, c)
                             : s.rings.firstInstance(c.point, s.pivot.pivot);
            if (c.instance == kNone) continue;
        }
        all[kept++] = c;
    }
    all.resize(kept);
    s.phase = Phase::Hole;
}

template void phaseLimits(UnloggedContext&);
template void phaseLimits(LoggedContext&);
template void phaseConvex(UnloggedContext&);
template void phaseConvex(LoggedContext&);
template void phaseReciprocal(UnloggedContext&);
template void phaseReciprocal(LoggedContext&);

}  // namespace se
