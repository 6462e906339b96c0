// A pivot is run phase by phase; what a stage leaves is read off the State after its phase, so that
// a trace needs no log.
#include "trace_run.h"

#include <cassert>

namespace se::teach {
namespace {

std::vector<Index> candidatePoints(const State& state) {
    std::vector<Index> points;
    points.reserve(state.pivot.candidates.size());
    for (const Candidate& each : state.pivot.candidates) points.push_back(each.point);
    return points;
}

void addOpenSteps(const EdgeRings& rings, Index ring, std::vector<RingStep>& open) {
    for (const Index entry : rings.entriesOf(ring)) {
        if (rings.open(entry)) open.push_back({rings.point(entry), rings.point(rings.next(entry))});
    }
}

/// The rings after a pivot.
void recordRings(const State& state, TracePivot& pivot) {
    const EdgeRings& rings = state.rings;
    pivot.ring.emplace();
    pivot.next = kNone;
    if (rings.active() != kNone) {
        pivot.ring = ringFrom(rings, state.pivot.pivot);
        pivot.next = pivot.ring->front();
        addOpenSteps(rings, rings.active(), pivot.open);
    }
    for (const Index ring : rings.stack()) {
        pivot.stack.push_back(ringFrom(rings, rings.head(ring)));
        addOpenSteps(rings, ring, pivot.open);
    }
}

/// Records what the phase that just ran has left.
void recordStage(Phase phase, const State& state, TracePivot& pivot) {
    for (const TraceStageRow& row : traceStages()) {
        if (row.phase == phase && row.id < TraceStage::Emit)
            pivot.*row.points = candidatePoints(state);
    }
    if (phase != Phase::Convex) return;
    pivot.start = state.rings.point(state.pivot.start);
    pivot.end = state.rings.point(state.pivot.end);
}

[[maybe_unused]] bool isBetweenPivots(Phase phase) {
    return phase == Phase::Seed || phase == Phase::Pivot || phase == Phase::Fill ||
           phase == Phase::Finished || isRepair(phase);
}

/// The pivot at the phase that begins it.
TracePivot beginningOf(const State& state) {
    TracePivot pivot;
    const Index entry = state.pivot.pivot;
    pivot.p = state.rings.point(entry);
    pivot.first = state.rings.point(state.rings.prev(entry));
    pivot.last = state.rings.point(state.rings.next(entry));
    pivot.fan.emplace();
    return pivot;
}

}  // namespace

std::vector<Index> ringFrom(const EdgeRings& rings, Index entry) {
    std::vector<Index> points;
    for (Index left = rings.length(rings.ringOf(entry)); left > 0; --left) {
        points.push_back(rings.point(entry));
        entry = rings.next(entry);
    }
    return points;
}

TraceStep stepTraced(Stepper& stepper, TraceDetail detail) {
    assert(isBetweenPivots(stepper.state().phase));
    TraceStep step;
    const std::size_t doneBefore = stepper.state().done.size();
    while (true) {
        const Phase phase = stepper.state().phase;
        if (!stepper.advance()) return step;
        const State& state = stepper.state();
        if (isRepair(phase)) {
            step.ran = true;
            return step;
        }
        if (phase == Phase::Pivot || phase == Phase::Fill) step.pivot = beginningOf(state);
        if (!step.pivot) continue;
        if (phase == Phase::Emit) step.pivot->fan = state.pivot.spokes;
        if (detail == TraceDetail::Stages) recordStage(phase, state, *step.pivot);
        if (phase != Phase::Advance) continue;
        step.ran = true;
        if (detail == TraceDetail::Fans) return step;
        recordRings(state, *step.pivot);
        step.pivot->done.assign(state.done.begin() + static_cast<std::ptrdiff_t>(doneBefore),
                                state.done.end());
        return step;
    }
}

}  // namespace se::teach
