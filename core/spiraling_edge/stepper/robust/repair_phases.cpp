/// Beyond the paper: the steps after the last pivot (repair.h), each with a number like a pivot.
/// Each kind runs until it finds nothing more, in the order reinsert, flip, reseat, kMendRounds
/// times; the last round takes no point out, since none could be put back.
#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

struct MendPhase {
    Phase phase;
    bool Rules::*on;
};
constexpr MendPhase kOrder[] = {
    {Phase::Reinsert, &Rules::reinsert},
    {Phase::Flip, &Rules::flip},
    {Phase::Reseat, &Rules::reseat},
};

/// Goes to the first phase at or after position `from` of the order whose rule is on.
bool enterFrom(StepContext& context, std::size_t from) {
    for (std::size_t i = from; i < std::size(kOrder); ++i) {
        if (!(context.params.rules.*kOrder[i].on)) continue;
        const bool lastRound = context.state.mend.round + 1 == kMendRounds;
        if (lastRound && kOrder[i].phase == Phase::Reseat) continue;
        context.state.phase = kOrder[i].phase;
        return true;
    }
    return false;
}

/// Goes to the phase after the current one, which has nothing left to do.
void enterNext(StepContext& context) {
    State& s = context.state;
    std::size_t place = 0;
    while (kOrder[place].phase != s.phase) ++place;
    if (enterFrom(context, place + 1)) return;
    s.phase = Phase::Finished;
    if (++s.mend.round == kMendRounds) return;
    s.mend.nextPoint = 0;
    s.mend.nextTriangle = 0;
    enterFrom(context, 0);
}

}  // namespace

void beginMendPhases(StepContext& context) {
    State& s = context.state;
    s.phase = Phase::Finished;
    s.pivotTriangles = 0;
    if (s.triangles.empty() || s.capped() || !enterFrom(context, 0)) return;
    s.mend = beginMending(context.points.size(), s.triangles);
}

void phaseReinsert(AnyContext auto& context) {
    State& s = context.state;
    Index point = kNone;
    if (!reinsertNext(context.points, s.mend, point)) return enterNext(context);
    ++s.counters.pivots;
    note(context, Stage::Reinsert, [&] { return ReinsertEvidence{point}; });
}

void phaseFlip(AnyContext auto& context) {
    State& s = context.state;
    Flip flip{};
    if (!flipNext(context.points, context.params.limits, s.mend, flip)) return enterNext(context);
    ++s.counters.pivots;
    note(context, Stage::Flip, [&] { return FlipEvidence{flip.u, flip.v, flip.x, flip.y}; });
}

void phaseReseat(AnyContext auto& context) {
    State& s = context.state;
    Index point = kNone;
    if (!reseatNext(context.points, s.mend, point)) return enterNext(context);
    ++s.counters.pivots;
    note(context, Stage::Reseat, [&] { return ReseatEvidence{point}; });
}

template void phaseReinsert(SilentContext&);
template void phaseReinsert(LoggedContext&);
template void phaseFlip(SilentContext&);
template void phaseFlip(LoggedContext&);
template void phaseReseat(SilentContext&);
template void phaseReseat(LoggedContext&);

}  // namespace se
