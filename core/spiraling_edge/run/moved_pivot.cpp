/// Each position is a run of one pivot from a copy of the state before it, with one what-if more:
/// so a dragged point does what the finished move will do.
#include "spiraling_edge/run/moved_pivot.h"

#include <cassert>
#include <utility>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

namespace {

/// Places on the way at which the outcome is compared, and halvings of the stretch that follows.
constexpr int kPlaces = 24;
constexpr int kHalvings = 10;

RunState withoutTriangles(const State& state) {
    RunState made;
    made.status.assign(state.status);
    made.rings = state.rings.withoutPoints();
    made.triangleCount = state.triangles.size();
    made.counters = state.counters;
    made.finished = state.finished();
    return made;
}

}  // namespace

Outcome outcomeOf(const PivotRecord& record, const PointDecisions& decisions) {
    Outcome found = Outcome::None;
    for (const Event& event : record.events) {
        if (event.address.stage != decisions.stage || subjectOf(event) != decisions.point) continue;
        found = outcomeOf(event);
    }
    return found;
}

std::optional<MovedPivot> MovedPivot::make(const SharedPoints& points, const Params& params,
                                           std::uint32_t pivot,
                                           const std::function<bool()>& keepGoing) {
    constexpr std::uint32_t kAskEvery = 64;
    Stepper stepper(points, params);
    while (stepper.state().counters.pivots + 1 < pivot) {
        const bool asks = stepper.state().counters.pivots % kAskEvery == 0;
        if (asks && keepGoing && !keepGoing()) return std::nullopt;
        if (!stepper.stepPivot()) return std::nullopt;
    }
    if (pivot == 0 || stepper.state().finished() || isRepair(stepper.state().phase))
        return std::nullopt;
    return MovedPivot(points, params, stepper.takeState());
}

std::shared_ptr<const PivotRecord> MovedPivot::record(Index point, const Vec3& to) const {
    assert(point < points_->size());
    Params params = params_;
    params.whatIf.push_back({WhatIfKind::Move, pivot(), Stage::Pivot, point, to, {}});
    EventLog log;
    Stepper stepper(points_, params, &log);
    stepper.setState(before_);
    auto made = std::make_shared<PivotRecord>();
    made->pivot = pivot();
    made->rules = params_.paper;
    made->before = withoutTriangles(before_);
    stepper.stepPivot();
    made->events = log.events();
    made->after = withoutTriangles(stepper.state());
    return made;
}

std::optional<double> MovedPivot::turn(Index point, const Vec3& from, const Vec3& to,
                                       const PointDecisions& decisions,
                                       const std::function<bool()>& keepGoing) const {
    const auto outcomeAt = [&](double share) {
        return outcomeOf(*record(point, from + share * (to - from)), decisions);
    };
    const Outcome first = outcomeAt(0.0);
    double low = 0.0;
    for (int i = 1; i <= kPlaces; ++i) {
        if (keepGoing && !keepGoing()) return std::nullopt;
        double high = static_cast<double>(i) / kPlaces;
        if (outcomeAt(high) == first) {
            low = high;
            continue;
        }
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = 0.5 * (low + high);
            (outcomeAt(middle) == first ? low : high) = middle;
        }
        return high;
    }
    return std::nullopt;
}

}  // namespace se
