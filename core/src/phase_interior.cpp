/// §6.1 to §6.4: the neighbor ring of one pivot, from its candidates to its triangles.
#include <algorithm>

#include "phases.h"

namespace se {
namespace {

// ---- §6.1: sort ---------------------------------------------------------------------------------

/// Stable insertion sort by angle: lists are short, come nearest first, and so points of the same
/// angle stay in order of distance.
void sortByAngle(std::vector<Candidate>& candidates) {
    constexpr std::size_t kLong = 48;
    if (candidates.size() > kLong) {
        std::stable_sort(
            candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.angle.key < b.angle.key; });
        return;
    }
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const Candidate moving = candidates[i];
        std::size_t j = i;
        for (; j > 0 && candidates[j - 1].angle.key > moving.angle.key; --j) {
            candidates[j] = candidates[j - 1];
        }
        candidates[j] = moving;
    }
}

/// "If two neighboring points are found to have the same angle, the point closest to p is included
/// in the ring and the other point is eliminated from consideration."
void keepNearestOfEachAngle(StepContext& context) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool same =
            kept > 0 && all[i].angle.key - all[kept - 1].angle.key <= context.params.sameAngle;
        if (!same) {
            all[kept++] = all[i];
            continue;
        }
        if (all[i].lengthSq < all[kept - 1].lengthSq) std::swap(all[i], all[kept - 1]);
        note(context, Stage::Sort, [&] {
            return SortEvidence{all[i].point,
                                all[i].angle.cosine,
                                all[i].angle.key > kHalfTurnKey,
                                all[i].angle.degrees(),
                                context.state.pivot.endAngle.degrees(),
                                Verdict::SameAngle,
                                all[kept - 1].point};
        });
    }
    all.resize(kept);
}

/// The angle of a listed neighbor and whether it may enter the neighbor ring.
struct SortTest {
    Candidate candidate;
    Verdict verdict;
};

SortTest testNeighbor(const StepContext& context, Index x) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    SortTest test{{x, kNone, {}, {}, 0.0}, Verdict::Kept};
    if (s.status[x] == kDone) {
        test.verdict = Verdict::AlreadyDone;
        return test;
    }
    if (x == s.rings.point(n.first) || x == s.rings.point(n.last)) {
        test.verdict = Verdict::OnRingEnd;
        return test;
    }
    Candidate& c = test.candidate;
    c.offset = context.points.position[x] - n.frame.origin;
    c.lengthSq = glm::dot(c.offset, c.offset);
    c.angle = angleOf(n.frame, c.offset, c.lengthSq);
    const double tolerance = context.params.sameAngle;
    if (!(c.angle.key > n.startAngle.key + tolerance)) {
        test.verdict = Verdict::NotAfterStart;
    } else if (!strictlyBetween(c.angle, n.startAngle, n.endAngle, tolerance)) {
        test.verdict = Verdict::NotBeforeEnd;
    }
    return test;
}

}  // namespace

void phaseSort(StepContext& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    const Index p = s.rings.point(n.pivot);
    for (const Index x : context.points.neighbors[p]) {
        if (x == p) continue;
        const SortTest test = testNeighbor(context, x);
        if (test.verdict == Verdict::Kept) n.candidates.push_back(test.candidate);
        note(context, Stage::Sort, [&] {
            const Candidate& c = test.candidate;
            return SortEvidence{x,
                                c.angle.cosine,
                                c.angle.key > kHalfTurnKey,
                                c.angle.degrees(),
                                n.endAngle.degrees(),
                                test.verdict,
                                kNone};
        });
    }
    sortByAngle(n.candidates);
    keepNearestOfEachAngle(context);
    s.phase = Phase::Limits;
}

// ---- §6.1: limits -------------------------------------------------------------------------------

namespace {

/// The entry behind start (its predecessor) or behind end (its successor).
Index beyond(const State& s, Side side) {
    return side == Side::Start ? s.rings.prev(s.pivot.start) : s.rings.next(s.pivot.end);
}

/// Rules::unblocked: does a candidate lie in the circumsphere of the triangle that a move of start
/// or end to `to` would make? UNUSED ones count in the triangle's sector, where they would be
/// enclosed; USED ones outside it if nearer than `to`, for the new spoke would run close by them.
bool isBlocked(const StepContext& context, Side side, const Angle& toAngle, const Vec3& to) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const bool atStart = side == Side::Start;
    const Vec3 a = context.positionAt(atStart ? n.start : n.end) - n.frame.origin;
    const Vec3 b = to - n.frame.origin;
    const double aSq = glm::dot(a, a);
    const double bSq = glm::dot(b, b);
    const double low = atStart ? n.startAngle.key : toAngle.key;
    const double high = atStart ? toAngle.key : n.endAngle.key;
    return std::any_of(n.candidates.begin(), n.candidates.end(), [&](const Candidate& c) {
        const bool inSector = c.angle.key > low && c.angle.key < high;
        const bool inTheWay =
            s.status[c.point] == kUnused ? inSector : !inSector && c.lengthSq < bSq;
        return inTheWay && testSphere(a, aSq, b, bSq, c.offset, c.lengthSq).inside();
    });
}

/// What a look at the point beyond start or end found.
struct LimitTest {
    Verdict verdict;
    Index to = kNone;  ///< Entry.
    Angle angle{};     ///< Of `to`, where it was needed.
    double turn = 0.0;
};

LimitTest testLimit(const StepContext& context, Side side) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const bool atStart = side == Side::Start;
    const Index limit = atStart ? n.start : n.end;
    const Index to = beyond(s, side);
    if (to == (atStart ? n.end : n.start) || to == n.pivot) return {Verdict::OtherLimit, to};
    if (context.openStep(atStart ? to : limit)) return {Verdict::NotAnEdge, to};
    const auto list = context.points.neighbors[s.rings.point(n.pivot)];
    if (std::find(list.begin(), list.end(), s.rings.point(to)) == list.end()) {
        return {Verdict::NotListed, to};
    }
    const Vec3& position = context.positionAt(to);
    LimitTest test{Verdict::Moved, to, angleOf(n.frame, position - n.frame.origin)};
    if (!strictlyBetween(test.angle, n.startAngle, n.endAngle, context.params.sameAngle)) {
        test.verdict = Verdict::Outside;
        return test;
    }
    const Vec3& p = n.frame.origin;
    const ConcaveTest concave = testConcave(context.positionAt(limit), context.normalAt(limit),
                                            atStart ? position : p, atStart ? p : position);
    test.turn = concave.turn;
    if (!concave.concave()) {
        test.verdict = Verdict::NotConcave;
    } else if (context.params.rules.unblocked && isBlocked(context, side, test.angle, position)) {
        test.verdict = Verdict::Blocked;
    }
    return test;
}

/// Advances start or end by one entry if §6.1 (Fig. 4) says so.
bool moveLimit(StepContext& context, Side side) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    Index& limit = side == Side::Start ? n.start : n.end;
    Angle& angle = side == Side::Start ? n.startAngle : n.endAngle;
    const LimitTest test = testLimit(context, side);
    note(context, Stage::Limits, [&] {
        return LimitEvidence{side,        s.rings.point(limit), s.rings.point(test.to),
                             test.turn,   angle.degrees(),      test.angle.degrees(),
                             test.verdict};
    });
    if (test.verdict != Verdict::Moved) return false;
    limit = test.to;
    angle = test.angle;
    return true;
}

/// Rules::limitsFirst off: each listed neighbor is looked at once, as it comes.
void moveLimitsAsNeighborsCome(StepContext& context) {
    const State& s = context.state;
    for (const Index x : context.points.neighbors[s.rings.point(s.pivot.pivot)]) {
        for (const Side side : {Side::Start, Side::End}) {
            if (x == s.rings.point(beyond(s, side)) && moveLimit(context, side)) break;
        }
    }
}

/// Drops the candidates for which `verdict` (of candidate and side) is not Kept.
template <typename Test>
void dropCandidates(StepContext& context, Stage stage, Test&& test) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
    std::size_t kept = 0;
    for (const Candidate& c : all) {
        const auto [verdict, side] = test(c);
        if (verdict == Verdict::Kept) {
            all[kept++] = c;
            continue;
        }
        note(context, stage, [&, v = verdict, sd = side] {
            return DropEvidence{c.point, sd, c.angle.degrees(), v};
        });
    }
    all.resize(kept);
}

}  // namespace

void phaseLimits(StepContext& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    s.phase = Phase::Convex;
    if (n.fullTurn()) return;
    if (context.params.rules.limitsFirst) {
        while (moveLimit(context, Side::Start)) {
        }
        while (moveLimit(context, Side::End)) {
        }
    } else {
        moveLimitsAsNeighborsCome(context);
    }
    if (n.start == n.first && n.end == n.last) return;
    const Index atStart = s.rings.point(n.start);
    const Index atEnd = s.rings.point(n.end);
    dropCandidates(context, Stage::Limits, [&](const Candidate& c) {
        const bool behindStart =
            c.point == atStart || !(c.angle.key > n.startAngle.key + context.params.sameAngle);
        const bool behindEnd =
            c.point == atEnd || !(c.angle.key < n.endAngle.key - context.params.sameAngle);
        return std::pair(behindStart || behindEnd ? Verdict::Outside : Verdict::Kept,
                         behindStart ? Side::Start : Side::End);
    });
}

// ---- §6.1: convexity and reciprocity ------------------------------------------------------------

void phaseConvex(StepContext& context) {
    State& s = context.state;
    const NeighborRing& n = s.pivot;
    s.phase = Phase::Reciprocal;
    if (n.fullTurn()) return;
    const Index beyondStart = beyond(s, Side::Start);
    const Index beyondEnd = beyond(s, Side::End);
    // Choice: a point with another entry elsewhere is left to the reciprocal test of that entry.
    const auto isOnly = [&](Index x, Index entry) {
        return x == s.rings.point(entry) && s.status[x] == 1;
    };
    dropCandidates(context, Stage::Convex, [&](const Candidate& c) {
        const bool atStart = isOnly(c.point, beyondStart);
        const bool atEnd = isOnly(c.point, beyondEnd);
        return std::pair(atStart || atEnd ? Verdict::BehindConvex : Verdict::Kept,
                         atStart ? Side::Start : Side::End);
    });
}

namespace {

/// True if entry a is found before entry b when the active ring is searched first, then the stack
/// from the top (§6.5).
bool foundBefore(const EdgeRings& rings, Index a, Index b) {
    const auto rank = [&](Index entry) {
        const Index ring = rings.ringOf(entry);
        return ring == rings.active() ? 0 : rings.depthFromTop(ring) + 1;
    };
    return rank(a) < rank(b);
}

/// Rules::wallsDone: both ring neighbors of a boundary point share a wall with it, so that what its
/// sector spans is outside the box.
bool completeAlongWalls(const StepContext& context, Index entry) {
    const EdgeRings& rings = context.state.rings;
    const auto type = [&](Index e) { return context.points.type[rings.point(e)]; };
    return shareFace(type(entry), type(rings.prev(entry))) &&
           shareFace(type(entry), type(rings.next(entry)));
}

/// The entry of the USED candidate whose sector holds the pivot, kNone if none does.
Index findInstance(StepContext& context, const Candidate& candidate) {
    const State& s = context.state;
    const EdgeRings& rings = s.rings;
    Index found = kNone;
    for (Index e = rings.firstEntryOf(candidate.point); e != kNone; e = rings[e].nextOfPoint) {
        const Index before = rings.prev(e);
        const Index after = rings.next(e);
        const bool free = context.params.rules.freeSector;
        const ReciprocalTest test = testReciprocal(
            context.points.position[candidate.point], context.points.normal[candidate.point],
            context.positionAt(free ? before : after), context.positionAt(free ? after : before),
            before == after, s.pivot.frame.origin, context.params.sameAngle,
            context.params.rules.tangent);
        const bool complete = context.params.rules.wallsDone && completeAlongWalls(context, e);
        note(context, Stage::Reciprocal, [&] {
            return ReciprocalEvidence{candidate.point,
                                      rings.point(before),
                                      rings.point(after),
                                      test.pivot.degrees(),
                                      test.limit.degrees(),
                                      complete      ? Verdict::WallComplete
                                      : test.inside ? Verdict::Kept
                                                    : Verdict::NotReciprocal};
        });
        if (test.inside && !complete && (found == kNone || foundBefore(rings, e, found))) found = e;
    }
    return found;
}

}  // namespace

void phaseReciprocal(StepContext& context) {
    State& s = context.state;
    std::vector<Candidate>& all = s.pivot.candidates;
    std::size_t kept = 0;
    for (Candidate& c : all) {
        if (s.status[c.point] > 0) {
            c.instance = findInstance(context, c);
            if (c.instance == kNone) continue;
        }
        all[kept++] = c;
    }
    all.resize(kept);
    s.phase = Phase::Hole;
}

// ---- §6.2: holes --------------------------------------------------------------------------------

namespace {

/// Do p, start and end form a hole of three?
bool isHoleOfThree(const StepContext& context) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    if (!context.params.rules.realHole) return s.rings.length(s.rings.active()) == 3;
    return s.rings.next(n.end) == n.start && !context.openStep(n.end) &&
           n.endAngle.key - n.startAngle.key < kHalfTurnKey;
}

}  // namespace

void phaseHole(StepContext& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    s.phase = Phase::Sphere;
    if (n.candidates.empty() || n.fullTurn() || !isHoleOfThree(context)) return;
    const HolePlane plane = makeHolePlane(
        context.positionAt(n.start), context.positionAt(n.end),
        n.frame.normal + context.normalAt(n.start) + context.normalAt(n.end), n.frame.origin);
    std::size_t kept = 0;
    for (const Candidate& c : n.candidates) {
        const Vec3& x = context.points.position[c.point];
        const bool keeps = plane.keeps(x);
        note(context, Stage::Hole, [&] {
            const double length = std::sqrt(glm::dot(plane.normal, plane.normal));
            const double unit = length > 0.0 ? 1.0 / length : 0.0;
            return HoleEvidence{c.point, plane.normal, plane.side(x) * unit, plane.pivotSide * unit,
                                keeps ? Verdict::Kept : Verdict::FarSide};
        });
        if (keeps) n.candidates[kept++] = c;
    }
    n.candidates.resize(kept);
}

// ---- §6.3: removal ------------------------------------------------------------------------------

namespace {

/// A neighbor on either side of the evaluated point: a candidate, or start or end.
struct Beside {
    Index point;
    Vec3 offset;
    double lengthSq;
    Angle angle;
};

Beside besideAt(const StepContext& context, Index entry, const Angle& angle) {
    const Vec3 offset = context.positionAt(entry) - context.state.pivot.frame.origin;
    return {context.state.rings.point(entry), offset, glm::dot(offset, offset), angle};
}
Beside besideAt(const Candidate& c) { return {c.point, c.offset, c.lengthSq, c.angle}; }

SphereEvidence explain(const SphereTest& test, const Beside& t, const Candidate& q, const Beside& s,
                       const Vec3& p, Verdict verdict) {
    SphereEvidence e{t.point, q.point, s.point, p, 0.0, 0.0, s.angle.degrees() - t.angle.degrees(),
                     verdict};
    if (!test.noCircle) {
        e.center = p + test.center();
        e.radius = test.radius();
        e.distance = test.distance();
    }
    return e;
}

/// §6.3: "If q falls inside the circumsphere or its removal would create an angle difference
/// between s and t of more than 120 degrees, q must be kept."
Verdict judge(StepContext& context, const Beside& t, const Candidate& q, const Beside& s) {
    const SphereTest test =
        testSphere(t.offset, t.lengthSq, s.offset, s.lengthSq, q.offset, q.lengthSq);
    Verdict verdict = Verdict::Removed;
    if (test.noCircle) {
        verdict = Verdict::NoCircle;
    } else if (test.inside()) {
        verdict = Verdict::InsideSphere;
    } else if (exceedsAngle(t.angle, s.angle, context.params.maxGapCosine)) {
        verdict = Verdict::GapTooWide;
    }
    note(context, Stage::Sphere,
         [&] { return explain(test, t, q, s, context.state.pivot.frame.origin, verdict); });
    return verdict;
}

/// §6.3: one pass over the candidates, each looked at once.
void thinOnce(StepContext& context) {
    NeighborRing& n = context.state.pivot;
    std::vector<Candidate>& all = n.candidates;
    Beside t = besideAt(context, n.start, n.startAngle);
    const Beside end = besideAt(context, n.end, n.endAngle);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Beside s = i + 1 < all.size() ? besideAt(all[i + 1]) : end;
        if (judge(context, t, all[i], s) == Verdict::Removed) continue;
        all[kept++] = all[i];
        t = besideAt(all[kept - 1]);
    }
    all.resize(kept);
}

/// Rules::stepBack: after a removal, the point before is looked at again with its new neighbor.
void thinWithStepBack(StepContext& context) {
    NeighborRing& n = context.state.pivot;
    std::vector<Candidate>& all = n.candidates;
    const Beside start = besideAt(context, n.start, n.startAngle);
    const Beside end = besideAt(context, n.end, n.endAngle);
    std::size_t kept = 0;  // all[0 .. kept) passed with their present neighbors.
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[kept++] = all[i];
        const Beside s = i + 1 < all.size() ? besideAt(all[i + 1]) : end;
        while (kept > 0) {
            const Beside t = kept > 1 ? besideAt(all[kept - 2]) : start;
            if (judge(context, t, all[kept - 1], s) != Verdict::Removed) break;
            --kept;
        }
    }
    all.resize(kept);
}

}  // namespace

void phaseSphere(StepContext& context) {
    context.state.phase = Phase::TwoPoint;
    if (context.params.rules.looksAtFan()) {
        context.state.pivot.pool = context.state.pivot.candidates;
    }
    if (context.state.pivot.candidates.empty()) return;
    if (context.params.rules.stepBack) {
        thinWithStepBack(context);
    } else {
        thinOnce(context);
    }
}

// ---- §6.4: triangles ----------------------------------------------------------------------------

void phaseTwoPoint(StepContext& context) {
    State& s = context.state;
    const NeighborRing& n = s.pivot;
    s.phase = context.params.rules.looksAtFan() ? Phase::Guard : Phase::Emit;
    if (!n.candidates.empty() || n.start != n.first || n.end != n.last) return;
    const bool overlaps = overlapsAsTwoPointRing(n.lastAngle);
    note(context, Stage::TwoPoint, [&] {
        return TwoPointEvidence{n.lastAngle.degrees(),
                                overlaps ? Verdict::Discarded : Verdict::Hole};
    });
    if (!overlaps) return;
    ++s.counters.discarded;
    s.phase = Phase::Advance;
}

void layOutFan(StepContext& context) {
    const State& s = context.state;
    NeighborRing& n = context.state.pivot;
    n.fan.clear();
    const auto addEntry = [&](Index e, const Angle& angle) {
        const Vec3 offset = context.positionAt(e) - n.frame.origin;
        n.fan.push_back({s.rings.point(e), e, false, offset, glm::dot(offset, offset), angle});
    };
    const auto addPassed = [&](Index e) {
        addEntry(e, angleOf(n.frame, context.positionAt(e) - n.frame.origin));
    };
    // Between first and start, and end and last, stand the points that were passed (Fig. 4).
    if (n.start != n.first) addEntry(n.first, Angle{});
    for (Index e = n.first; e != n.start;) {
        e = s.rings.prev(e);
        if (e != n.start) addPassed(e);
    }
    addEntry(n.start, n.startAngle);
    for (const Candidate& c : n.candidates) {
        n.fan.push_back({c.point, c.instance, true, c.offset, c.lengthSq, c.angle});
    }
    addEntry(n.end, n.endAngle);
    for (Index e = n.end; e != n.last;) {
        e = s.rings.prev(e);
        if (e != n.last) addPassed(e);
    }
    if (n.end != n.last) addEntry(n.last, n.lastAngle);
}

void phaseEmit(StepContext& context) {
    State& s = context.state;
    if (!context.params.rules.looksAtFan()) layOutFan(context);
    const Index p = s.rings.point(s.pivot.pivot);
    const std::vector<FanPoint>& fan = s.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const Triangle t{p, fan[i].point, fan[i + 1].point};
        s.triangles.push_back(t);
        if (!s.edges.empty()) s.edges.add(t);
        note(context, Stage::Emit, [&] {
            return EmitEvidence{static_cast<Index>(s.triangles.size() - 1), t};
        });
    }
    s.pivotTriangles = static_cast<std::uint32_t>(fan.size() - 1);
    s.phase = Phase::Ring;
}

}  // namespace se
