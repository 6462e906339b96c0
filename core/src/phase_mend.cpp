/// Beyond the paper: the steps after the last pivot (mend.h), each with a number like a pivot.
#include "phases.h"

namespace se {
namespace {

bool capped(const State& s) {
    return !s.alerts.empty() && s.alerts.back().kind == AlertKind::TriangleCap;
}

}  // namespace

void beginMendPhases(StepContext& context) {
    State& s = context.state;
    const Rules& rules = context.params.rules;
    s.phase = Phase::Finished;
    if ((!rules.reinsert && !rules.flip) || s.triangles.empty() || capped(s)) return;
    s.mend = beginMending(context.points.size(), s.triangles);
    s.phase = rules.reinsert ? Phase::Reinsert : Phase::Flip;
}

void phaseReinsert(StepContext& context) {
    State& s = context.state;
    Index point = kNone;
    if (!reinsertNext(context.points, s.mend, point)) {
        s.phase = context.params.rules.flip ? Phase::Flip : Phase::Finished;
        return;
    }
    ++s.counters.pivots;
    note(context, Stage::Reinsert, [&] { return ReinsertEvidence{point}; });
}

void phaseFlip(StepContext& context) {
    State& s = context.state;
    Flip flip{};
    if (!flipNext(context.points, s.mend, flip)) {
        s.phase = Phase::Finished;
        return;
    }
    ++s.counters.pivots;
    note(context, Stage::Flip, [&] { return FlipEvidence{flip.u, flip.v, flip.x, flip.y}; });
}

}  // namespace se
