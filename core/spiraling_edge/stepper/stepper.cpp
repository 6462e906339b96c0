/// The dispatch from State::phase to the phase functions. Each exists in two variants, with and
/// without a log; the choice is made once per call. Runs with non-default paper rules always take
/// the one with a log, and runs with what-ifs at the pivots of those.
#include "spiraling_edge/stepper/stepper.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

template <AnyContext Context>
struct PhaseRow {
    Phase id;
    void (*run)(Context&);
};
/// All phases but Finished, which is never run.
template <AnyContext Context>
constexpr std::array<PhaseRow<Context>, static_cast<std::size_t>(Phase::Finished)> kPhases{
    {{Phase::Seed, phaseSeed},           {Phase::Pivot, phasePivot},
     {Phase::Sort, phaseSort},           {Phase::Limits, phaseLimits},
     {Phase::Convex, phaseConvex},       {Phase::Reciprocal, phaseReciprocal},
     {Phase::Hole, phaseHole},           {Phase::Sphere, phaseSphere},
     {Phase::TwoPoint, phaseTwoPoint},   {Phase::Guard, phaseGuard},
     {Phase::Emit, phaseEmit},           {Phase::Ring, phaseRing},
     {Phase::Link, phaseLink},           {Phase::Fill, phaseFill},
     {Phase::Advance, phaseAdvance},     {Phase::DropFans, phaseDropFans},
     {Phase::DropPatch, phaseDropPatch}, {Phase::Reinsert, phaseReinsert},
     {Phase::CloseHole, phaseCloseHole}, {Phase::Flip, phaseFlip},
     {Phase::Remesh, phaseRemesh}}};
static_assert(isInOrder(kPhases<UnloggedContext>));

/// Inline, since it only dispatches on the phase, 12 times per pivot. Requires an unfinished run.
template <AnyContext Context>
[[gnu::always_inline]] inline void runPhase(Context& context) {
    assert(!context.state.finished());
    kPhases<Context>[static_cast<std::size_t>(context.state.phase)].run(context);
}

/// True for the phases after which the run is between two pivots.
bool endsStep(Phase phase) { return phase == Phase::Advance || isRepair(phase); }

/// The number of the pivot of the next phase.
std::uint32_t presentPivot(const State& state) {
    const Phase phase = state.phase;
    const bool begins = phase == Phase::Seed || phase == Phase::Pivot || phase == Phase::Fill;
    return state.counters.pivots + (begins || isRepair(phase) ? 1 : 0);
}

bool forksAt(const Params& params, std::uint32_t pivot) {
    return std::any_of(params.whatIf.begin(), params.whatIf.end(),
                       [&](const WhatIf& each) { return each.pivot == pivot; });
}

/// The sets of a run by turnedPoints(); empty where those are the given ones.
std::vector<EditedPoints> turnedSets(const PointSet& points,
                                     const std::vector<EditedPoints>& edited,
                                     const Params& params) {
    if (params.paper.turn != TurnRule::Clockwise) return {};
    std::vector<EditedPoints> made{{0, *turnedPoints(points, params)}};
    for (const EditedPoints& each : edited)
        made.push_back({each.from, *turnedPoints(each.points, params)});
    return made;
}

}  // namespace

SharedPoints turnedPoints(SharedPoints points, const Params& params) {
    if (params.paper.turn != TurnRule::Clockwise) return points;
    PointSet turned = *points;
    for (Vec3& each : turned.normal) each = -each;
    for (RimGap& gap : turned.rim) std::swap(gap.from, gap.to);
    return turned;
}

Stepper::Stepper(SharedPoints points, const Params& params, EventLog* log)
    : points_(std::move(points)),
      params_(params),
      edited_(editedPoints(*points_, params)),
      turned_(turnedSets(*points_, edited_, params)),
      altered_(!(params.paper == PaperRules{}) || !params.whatIf.empty()),
      rimAnswers_(params.robust.rim && edited_.empty() ? points_->size() : 0),
      waiting_(params.robust.looksAtFan() && !altered_
                   ? std::make_unique<WaitingFans>(points_->size())
                   : nullptr),
      state_(startState(*points_, params)),
      log_(log) {}

const PointSet& Stepper::points() const { return setAt(edited_); }

const PointSet& Stepper::setAt(const std::vector<EditedPoints>& sets) const {
    const PointSet* found = &*points_;
    const std::uint32_t pivot = sets.empty() ? 0 : presentPivot(state_);
    for (const EditedPoints& each : sets) {
        if (each.from <= pivot) found = &each.points;
    }
    return *found;
}

template <typename Work>
bool Stepper::inContext(Work&& work) {
    const PointSet& points = setAt(turned_.empty() ? edited_ : turned_);
    RimAnswer* const rims = rimAnswers_.empty() ? nullptr : rimAnswers_.data();
#ifndef SPIRALING_EDGE_WITHOUT_LOG
    if (log_ != nullptr || observer_) {
        LoggedContext context{{points, params_, state_, rims, waiting_.get()},
                              log_ != nullptr ? *log_ : observed_};
        return work(context);
    }
#endif
    if (altered_ && (!(params_.paper == PaperRules{}) || forksAt(params_, presentPivot(state_)))) {
        EventLog discardedLog;
        LoggedContext context{{points, params_, state_, rims, waiting_.get()}, discardedLog};
        return work(context);
    }
    UnloggedContext context{{points, params_, state_, rims, waiting_.get()}};
    return work(context);
}

bool Stepper::advance() {
    stopped_ = false;
    if (state_.finished()) return false;
    const EventLog& log = log_ != nullptr ? *log_ : observed_;
    const std::size_t before = log.events().size();
    const bool ends = endsStep(state_.phase);
    inContext([](auto& context) {
        runPhase(context);
        return true;
    });
    if (!observer_) return true;
    for (std::size_t i = before; i < log.events().size(); ++i) {
        stopped_ = observer_(log.events()[i]) || stopped_;
    }
    if (ends) observed_.clear();
    return true;
}

bool Stepper::stepPivotObserved() {
    bool complete = false;
    do {
        complete = endsStep(state_.phase);
        if (!advance()) return false;
    } while (!complete && !stopped_);
    return complete;
}

bool Stepper::stepPivot() {
    if (observer_) return stepPivotObserved();
    return inContext([](auto& context) {
        bool complete = false;
        while (!complete && !context.state.finished()) {
            complete = endsStep(context.state.phase);
            runPhase(context);
        }
        return complete;
    });
}

StopReason Stepper::runUntil(const std::function<bool(const State&)>& condition) {
    while (stepPivot()) {
        if (stopped_) return StopReason::Observer;
        if (condition(state_)) return StopReason::Condition;
    }
    return reason();
}

StopReason Stepper::run() {
    // The choice of the context must be made for each pivot.
    while ((altered_ || observer_) && stepPivot() && !stopped_) {
    }
    if (stopped_) return StopReason::Observer;
    inContext([](auto& context) {
        while (!context.state.finished()) runPhase(context);
        return true;
    });
    return reason();
}

StopReason Stepper::reason() const {
    if (stopped_) return StopReason::Observer;
    return state_.capped() ? StopReason::Capped : StopReason::Finished;
}

void Stepper::freePast() {
    if (isRepair(state_.phase) || state_.finished()) state_.edges = {};
}

State Stepper::takeState() { return exchangeState(startState(*points_, params_)); }

}  // namespace se
