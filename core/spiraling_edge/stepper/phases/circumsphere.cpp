/// §6.2 and §6.3: candidates beyond a hole go, and those that the circumsphere test gives up.
#include <algorithm>

#include "phases.h"

namespace se {

// ---- §6.2: holes --------------------------------------------------------------------------------

namespace {

/// The edges of the hole that p, start and end form, if it has three, or up to as many as
/// PaperRules::holeSize says; 0 if they form none.
Index edgesOfHole(const AnyContext auto& context) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const Index size = paperOf(context).holeSize;
    if (!context.params.rules.realHole) {
        const Index length = s.rings.length(s.rings.active());
        return length >= 3 && length <= size ? length : 0;
    }
    if (!(n.endAngle.key - n.startAngle.key < kHalfTurnKey)) return 0;
    // p, start and end are two edges; so many lead back from end to start.
    Index e = n.end;
    for (Index edges = 3; edges <= size; ++edges) {
        if (context.openStep(e)) return 0;
        e = s.rings.next(e);
        if (e == n.start) return edges;
    }
    return 0;
}

}  // namespace

void phaseHole(AnyContext auto& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    s.phase = Phase::Sphere;
    if (n.candidates.empty() || n.fullTurn()) return;
    const Index edges = edgesOfHole(context);
    if (edges == 0) return;
    const HolePlane plane = makeHolePlane(
        context.positionAt(n.start), context.positionAt(n.end),
        n.frame.normal + context.normalAt(n.start) + context.normalAt(n.end), n.frame.origin);
    std::size_t kept = 0;
    for (const Candidate& c : n.candidates) {
        const Vec3& x = context.points.position[c.point];
        const bool onSide = plane.keeps(x);
        const auto wish = said(context, Stage::Hole, c.point);
        const bool keeps = wish.value_or(onSide);
        note(context, Stage::Hole, [&] {
            const double length = std::sqrt(glm::dot(plane.normal, plane.normal));
            const double unit = length > 0.0 ? 1.0 / length : 0.0;
            return HoleEvidence{
                c.point,
                plane.normal,
                plane.side(x) * unit,
                plane.pivotSide * unit,
                afterWhatIf(onSide ? Verdict::Kept : Verdict::FarSide, wish, onSide),
                edges};
        });
        if (keeps) n.candidates[kept++] = c;
    }
    n.candidates.resize(kept);
}

// ---- §6.3: removal ------------------------------------------------------------------------------

namespace {

/// start or end, in the form of its neighbors in the ring.
Candidate limitAt(const StepContext& context, Index entry, const Angle& angle) {
    const Vec3 offset = context.positionAt(entry) - context.state.pivot.frame.origin;
    return {context.state.rings.point(entry), entry, angle, offset, glm::dot(offset, offset)};
}

SphereTest testOf(const Candidate& t, const Candidate& q, const Candidate& s) {
    return testSphere(t.offset, t.lengthSq, s.offset, s.lengthSq, q.offset, q.lengthSq);
}

/// Does the test anew: kept in memory for who may want to see it, it would cost everyone time.
SphereEvidence explain(const Candidate& t, const Candidate& q, const Candidate& s, const Vec3& p,
                       Verdict verdict) {
    const SphereTest test = testOf(t, q, s);
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
Verdict judge(const AnyContext auto& context, const Candidate& t, const Candidate& q,
              const Candidate& s) {
    const SphereTest test = testOf(t, q, s);
    if (test.noCircle) return Verdict::NoCircle;
    if (test.inside()) return Verdict::InsideSphere;
    if (paperOf(context).onSphere == OnSphereRule::Kept && test.onSphere()) {
        return Verdict::InsideSphere;
    }
    const bool wide = exceedsAngle(t.angle, s.angle, context.params.maxGapCosine);
    return wide ? Verdict::GapTooWide : Verdict::Removed;
}

bool isRemoved(AnyContext auto& context, const Candidate& t, const Candidate& q,
               const Candidate& s) {
    Verdict verdict = judge(context, t, q, s);
    verdict =
        afterWhatIf(verdict, said(context, Stage::Sphere, q.point), verdict != Verdict::Removed);
    note(context, Stage::Sphere,
         [&, verdict] { return explain(t, q, s, context.state.pivot.frame.origin, verdict); });
    return verdict == Verdict::Removed || verdict == Verdict::WhatIfDropped;
}

/// §6.3: one pass over the candidates, each looked at once.
void thinOnce(AnyContext auto& context) {
    NeighborRing& n = context.state.pivot;
    std::vector<Candidate>& all = n.candidates;
    const Candidate start = limitAt(context, n.start, n.startAngle);
    const Candidate end = limitAt(context, n.end, n.endAngle);
    const Candidate* t = &start;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Candidate& s = i + 1 < all.size() ? all[i + 1] : end;
        if (isRemoved(context, *t, all[i], s)) continue;
        if (kept != i) all[kept] = all[i];
        t = &all[kept++];
    }
    all.resize(kept);
}

/// Rules::stepBack: after a removal, the point before is looked at again with its new neighbor.
void thinWithStepBack(AnyContext auto& context) {
    NeighborRing& n = context.state.pivot;
    std::vector<Candidate>& all = n.candidates;
    const Candidate start = limitAt(context, n.start, n.startAngle);
    const Candidate end = limitAt(context, n.end, n.endAngle);
    std::size_t kept = 0;  // all[0 .. kept) passed with their present neighbors.
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (kept != i) all[kept] = all[i];
        ++kept;
        const Candidate& s = i + 1 < all.size() ? all[i + 1] : end;
        while (kept > 0) {
            const Candidate& t = kept > 1 ? all[kept - 2] : start;
            if (!isRemoved(context, t, all[kept - 1], s)) break;
            --kept;
        }
    }
    all.resize(kept);
}

}  // namespace

void phaseSphere(AnyContext auto& context) {
    context.state.phase = Phase::TwoPoint;
    if (context.params.rules.looksAtFan()) {
        context.state.pivot.pool = context.state.pivot.candidates;
    }
    if (context.state.pivot.candidates.empty() || !paperOf(context).sphere) return;
    if (context.params.rules.stepBack) {
        thinWithStepBack(context);
    } else {
        thinOnce(context);
    }
}

template void phaseHole(SilentContext&);
template void phaseHole(LoggedContext&);
template void phaseSphere(SilentContext&);
template void phaseSphere(LoggedContext&);

}  // namespace se
