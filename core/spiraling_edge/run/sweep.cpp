#include "spiraling_edge/run/sweep.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/run/reading.h"

namespace se {

Index pivotPoint(std::span<const Event> events) {
    for (const Event& event : events) {
        if (const auto* pivot = as<PivotEvidence>(event)) return pivot->pivot;
        if (const auto* fill = as<FillEvidence>(event)) return fill->pivot;
    }
    return kNone;
}

PivotTally tallyOf(std::span<const Event> events) {
    PivotTally tally;
    for (const Event& event : events) {
        if (const auto* pivot = as<PivotEvidence>(event)) tally.ringLength = pivot->ringLength;
        const Outcome outcome = outcomeOf(event);
        if (outcome == Outcome::None) continue;
        ++tally.tests;
        const bool sorted = isA<SortEvidence>(event);
        if (sorted && outcome == Outcome::Taken) ++tally.candidates;
    }
    return tally;
}

Sweep::Sweep(SharedPoints points, const Params& params, PivotVisitor visit, PivotChoice wants)
    : visit_(std::move(visit)),
      wants_(std::move(wants)),
      stepper_(std::move(points), params, &log_) {
    assert(validate(stepper_.points()).ok());
}

std::optional<Index> Sweep::passedOver() const {
    const State& before = stepper_.state();
    if (!wants_ || before.phase != Phase::Pivot) return {};
    const Index point = before.rings.point(before.pivot.pivot);
    return wants_(point, before) ? std::nullopt : std::optional(point);
}

bool Sweep::advance(std::uint32_t pivots) {
    for (; pivots > 0; --pivots) {
        const std::optional<Index> passed = passedOver();
        stepper_.setLog(passed ? nullptr : &log_);
        const bool more = stepper_.stepPivot();
        stepper_.freePast();
        const std::vector<Event>& events = log_.events();
        if (passed || !events.empty())
            visit_({passed.value_or(pivotPoint(events)), events, stepper_.state()});
        log_.clear();
        if (!more) return false;
    }
    return true;
}

double Sweep::share() const {
    const std::size_t points = std::max<std::size_t>(stepper_.points().size(), 1);
    return static_cast<double>(stepper_.state().done.size()) / static_cast<double>(points);
}

std::optional<State> sweep(const PointSet& points, const Params& params, const PivotVisitor& visit,
                           const Progress& progress, const PivotChoice& wants) {
    Sweep pass(points, params, visit, wants);
    do {
        if (progress && !progress(pass.share())) return {};
    } while (pass.advance(kPivotsPerReport));
    return pass.takeState();
}

}  // namespace se
