#include "spiraling_edge/run/run_cursor.h"

#include <cassert>
#include <limits>
#include <optional>

namespace se {
namespace {

/// The first of `events`, from number `from` on, that meets the condition.
std::optional<std::size_t> firstMatch(const PointSet& points, const Params& params,
                                      std::span<const Event> events, std::size_t from,
                                      const DecisionCondition& condition) {
    const Index pivot = pivotPoint(events);
    for (std::size_t i = from; i < events.size(); ++i) {
        const auto reading = readingOf(events[i], {points, params, pivot});
        if (condition({events[i], pivot, reading, points, events})) return i;
    }
    return {};
}

}  // namespace

RunCursor::RunCursor(const SharedPoints& points, const Params& params)
    : timeline_(points, params), replay_(timeline_.record(0)) {}

const Event* RunCursor::event() const {
    return pivot().events.empty() ? nullptr : &pivot().events[event_];
}

bool RunCursor::isPlace(std::size_t i, StepUnit unit) const {
    const std::vector<Event>& events = pivot().events;
    if (unit == StepUnit::Decision || i + 1 == events.size()) return true;
    return unit == StepUnit::Phase && events[i].address.stage != events[i + 1].address.stage;
}

/// Makes `pivot` the present one, with the cursor at its first event. False, unmoved, if the run
/// has no such pivot.
bool RunCursor::load(std::uint32_t pivot) {
    auto record = timeline_.record(pivot);
    if (record->pivot != pivot) {
        timeline_.seek(this->pivot().pivot);
        return false;
    }
    replay_ = PivotReplay(std::move(record));
    event_ = 0;
    return true;
}

bool RunCursor::forward(StepUnit unit) {
    const std::size_t count = pivot().events.size();
    std::size_t i = event_ + 1;
    if (i >= count) {
        if (pivot().isLast || !load(pivot().pivot + 1)) return false;
        i = 0;
    }
    while (!isPlace(i, unit)) ++i;
    event_ = i;
    return true;
}

bool RunCursor::back(StepUnit unit) {
    if (event() == nullptr) return false;
    for (std::size_t i = event_; i > 0; --i) {
        if (!isPlace(i - 1, unit)) continue;
        event_ = i - 1;
        return true;
    }
    load(pivot().pivot - 1);
    if (event() != nullptr) event_ = pivot().events.size() - 1;
    return true;
}

bool RunCursor::goTo(const Address& address) {
    std::shared_ptr<const PivotRecord> record = timeline_.record(address.pivot);
    const auto found = record->find(address);
    if (!found) {
        timeline_.seek(pivot().pivot);
        return false;
    }
    replay_ = PivotReplay(std::move(record));
    event_ = *found;
    return true;
}

void RunCursor::goToStart() { load(0); }

void RunCursor::goToEnd() {
    replay_ = PivotReplay(timeline_.record(std::numeric_limits<std::uint32_t>::max()));
    event_ = pivot().events.empty() ? 0 : pivot().events.size() - 1;
}

bool RunCursor::runUntil(const DecisionCondition& condition) {
    // What-ifs may move points: those of the pivot are in force before it.
    timeline_.seek(pivot().pivot == 0 ? 0 : pivot().pivot - 1);
    const auto here =
        firstMatch(timeline_.points(), timeline_.params(), pivot().events, event_ + 1, condition);
    timeline_.seek(pivot().pivot);
    if (here) {
        event_ = *here;
        return true;
    }
    EventLog log;
    for (bool more = true; more; log.clear()) {
        const std::uint32_t number = timeline_.position() + 1;
        const PointSet& points = timeline_.points();
        more = timeline_.stepPivot(&log);
        const auto found = firstMatch(points, timeline_.params(), log.events(), 0, condition);
        if (!found) continue;
        load(number);
        event_ = *found;
        return true;
    }
    goToEnd();
    return false;
}

bool RunCursor::runUntil(const DecisionQuery& query) {
    assert(!query.needsFailures());
    return runUntil([&](const Decision& decision) { return query.matches(decision); });
}

}  // namespace se
