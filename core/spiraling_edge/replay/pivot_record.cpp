#include "pivot_record.h"

#include <algorithm>
#include <limits>

namespace se::view {

namespace {

/// `state` without its triangles; `last` are the statuses of an earlier record.
RunState withoutTriangles(const State& state, StatusList& last) {
    last.assign(state.status);
    RunState copy{last,
                  state.rings.withoutPoints(),
                  state.triangles.size(),
                  state.counters,
                  state.finished(),
                  nullptr};
    if (!state.repair.empty()) {
        copy.repaired = std::make_shared<const std::vector<Triangle>>(state.repair.triangles);
    }
    return copy;
}

}  // namespace

std::optional<std::size_t> PivotRecord::find(const Address& address) const {
    const auto matches = [&](const Event& event) {
        return event.address.stage == address.stage &&
               (address.n == 0 || event.address.n == address.n);
    };
    const auto found = std::find_if(events.begin(), events.end(), matches);
    if (address.pivot != pivot || found == events.end()) return std::nullopt;
    return static_cast<std::size_t>(found - events.begin());
}

std::shared_ptr<const PivotRecord> recordPivot(Timeline& timeline, std::uint32_t pivot) {
    StatusList none;
    return recordPivot(timeline, pivot, none);
}

std::shared_ptr<const PivotRecord> recordPivot(Timeline& timeline, std::uint32_t pivot,
                                               StatusList& last) {
    auto record = std::make_shared<PivotRecord>();
    record->events = timeline.eventsOf(pivot);
    if (record->events.empty() && pivot > 0) {
        timeline.seek(std::numeric_limits<std::uint32_t>::max());
        pivot = timeline.lastPivot();
        record->events = timeline.eventsOf(pivot);
    }
    record->pivot = pivot;
    if (pivot == 0) {
        timeline.seek(0);
        record->before = record->after = withoutTriangles(timeline.state(), last);
        record->isLast = timeline.endKnown() && timeline.lastPivot() == 0;
        return record;
    }
    record->before = withoutTriangles(timeline.state(), last);
    timeline.stepPivot();
    record->after = withoutTriangles(timeline.state(), last);
    if (record->after.repaired && !record->before.repaired) {
        // The list of emitted triangles stays unchanged while a copy of it is edited.
        record->unrepaired =
            std::make_shared<const std::vector<Triangle>>(timeline.state().triangles);
    }
    record->isLast = timeline.endKnown() && pivot == timeline.lastPivot();
    return record;
}

}  // namespace se::view
