/// Beyond the paper: the steps after the last pivot (repair.h), each with a number like a pivot.
/// Each kind runs until it finds nothing more, in the order reinsert, flip, reseat, kRepairRounds
/// times; the last round takes no point out, since none could be put back.
#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

struct RepairPhase {
    Phase phase;
    bool RobustRules::*on;
};
constexpr RepairPhase kOrder[] = {
    {Phase::Reinsert, &RobustRules::reinsert},
    {Phase::Flip, &RobustRules::flip},
    {Phase::RemoveFolded, &RobustRules::removeFolded},
};

/// Goes to the first phase at or after position `from` of the order whose rule is on.
bool enterFrom(StepContext& context, std::size_t from) {
    for (std::size_t i = from; i < std::size(kOrder); ++i) {
        if (!(context.params.robust.*kOrder[i].on)) continue;
        const bool lastRound = context.state.repair.round + 1 == kRepairRounds;
        if (lastRound && kOrder[i].phase == Phase::RemoveFolded) continue;
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
    if (++s.repair.round == kRepairRounds) return;
    s.repair.nextPoint = 0;
    s.repair.nextTriangle = 0;
    enterFrom(context, 0);
}

}  // namespace

void beginRepairPhases(StepContext& context) {
    State& s = context.state;
    s.phase = Phase::Finished;
    s.pivotTriangles = 0;
    if (s.triangles.empty() || s.capped() || !enterFrom(context, 0)) return;
    s.repair = beginRepair(context.points.size(), s.triangles);
}

void phaseReinsert(AnyContext auto& context) {
    State& s = context.state;
    Index point = kNone;
    if (!reinsertNext(context.points, s.repair, point)) return enterNext(context);
    ++s.counters.pivots;
    note(context, Stage::Reinsert, [&] { return ReinsertEvidence{point}; });
}

void phaseFlip(AnyContext auto& context) {
    State& s = context.state;
    Flip flip{};
    if (!flipNext(context.points, context.params.thresholds, s.repair, flip))
        return enterNext(context);
    ++s.counters.pivots;
    note(context, Stage::Flip, [&] { return FlipEvidence{flip.u, flip.v, flip.x, flip.y}; });
}

void phaseRemoveFolded(AnyContext auto& context) {
    State& s = context.state;
    Index point = kNone;
    if (!removeFoldedPoint(context.points, s.repair, point)) return enterNext(context);
    ++s.counters.pivots;
    note(context, Stage::RemoveFolded, [&] { return RemoveFoldedEvidence{point}; });
}

template void phaseReinsert(UnloggedContext&);
template void phaseReinsert(LoggedContext&);
template void phaseFlip(UnloggedContext&);
template void phaseFlip(LoggedContext&);
template void phaseRemoveFolded(UnloggedContext&);
template void phaseRemoveFolded(LoggedContext&);

}  // namespace se
