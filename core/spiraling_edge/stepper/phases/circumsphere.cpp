/// §6.3: the circumsphere test with the 120-degree rule, which removes candidates from the neighbor
/// ring. The equator of the sphere is the circle through the pivot and the two neighbors of a
/// candidate; a candidate inside it stays, and so does one whose removal would leave a gap over 120
/// degrees. One pass, O(candidates); with RobustRules::stepBack a removal tests the candidate
/// before it again.
#include "spiraling_edge/stepper/step_context.h"

namespace se {

namespace {

/// start or end, as a candidate.
Candidate limitAt(const StepContext& context, Index entry, const Angle& angle) {
    const Vec3 offset = context.positionAt(entry) - context.state.pivot.frame.origin;
    return {context.state.rings.point(entry), entry, angle, offset, glm::dot(offset, offset)};
}

SphereTest testOf(const Candidate& t, const Candidate& q, const Candidate& s) {
    return testSphere(t.offset, t.lengthSq, s.offset, s.lengthSq, q.offset, q.lengthSq);
}

/// Recomputes the test for the log; storing it would slow every run.
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
Verdict circumsphereVerdict(const AnyContext auto& context, const Candidate& t, const Candidate& q,
                            const Candidate& s) {
    const SphereTest test = testOf(t, q, s);
    if (test.noCircle) return Verdict::NoCircle;
    if (test.inside()) return Verdict::InsideSphere;
    if (paperRules(context).onSphere == OnSphereRule::Kept && test.onSphere()) {
        return Verdict::InsideSphere;
    }
    const bool wide = exceedsAngle(t.angle, s.angle, context.params.maxGapCosine);
    return wide ? Verdict::GapTooWide : Verdict::Removed;
}

bool isRemoved(AnyContext auto& context, const Candidate& t, const Candidate& q,
               const Candidate& s) {
    Verdict verdict = circumsphereVerdict(context, t, q, s);
    verdict = applyOverride(verdict, whatIfOverride(context, Stage::Sphere, q.point),
                            verdict != Verdict::Removed);
    note(context, Stage::Sphere,
         [&, verdict] { return explain(t, q, s, context.state.pivot.frame.origin, verdict); });
    return verdict == Verdict::Removed || verdict == Verdict::WhatIfDropped;
}

/// §6.3: one pass over the candidates, each tested once.
void thinOnce(AnyContext auto& context, const Candidate& start, const Candidate& end) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
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

/// RobustRules::stepBack: after a removal, the point before it is tested again with its new
/// neighbor.
void thinWithStepBack(AnyContext auto& context, const Candidate& start, const Candidate& end) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
    std::size_t kept = 0;  // all[0 .. kept) passed with their current neighbors.
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
    NeighborRing& n = context.state.pivot;
    context.state.phase = Phase::TwoPoint;
    if (context.params.robust.looksAtFan()) n.pool = n.candidates;
    if (n.candidates.empty() || !paperRules(context).sphere) return;
    const Candidate start = limitAt(context, n.start, n.startAngle);
    const Candidate end = limitAt(context, n.end, n.endAngle);
    if (context.params.robust.stepBack) {
        thinWithStepBack(context, start, end);
    } else {
        thinOnce(context, start, end);
    }
}

template void phaseSphere(UnloggedContext&);
template void phaseSphere(LoggedContext&);

}  // namespace se
