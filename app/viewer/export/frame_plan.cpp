#include "frame_plan.h"

#include <algorithm>
#include <set>
#include <variant>

#include "spiraling_edge/run/run_cursor.h"
#include "teach/lesson_runs.h"

namespace se::view {

namespace {

/// Whether the frame of this event is one of the range.
bool isFrame(const RunCursor& cursor, FrameUnit unit) {
    const Event* event = cursor.event();
    if (event == nullptr || unit == FrameUnit::SubStep) return true;
    if (unit == FrameUnit::Pivot) return event == &cursor.pivot().events.back();
    const Stage stage = event->address.stage;
    return stage == Stage::Seed || stage == Stage::Split || stage == Stage::Join ||
           std::holds_alternative<AlertEvidence>(event->evidence);
}

/// A position without a stage ends with its pivot.
Status goToLast(RunCursor& cursor, const std::string& place) {
    const Status moved = teach::goToPlace(cursor, place);
    if (moved && place.find_first_not_of("0123456789") == std::string::npos && place != "0")
        cursor.goTo(cursor.pivot().events.back().address);
    return moved;
}

/// Collects the points that the decisions of the frames are about.
class PointCollector {
  public:
    void add(const DecisionState& state) {
        if (state.pivot != kNone) pivots_.insert(state.pivot);
        for (const Index p : {state.pivot, state.first, state.last, state.start, state.end,
                              state.nextPivot, state.underTest}) {
            if (p != kNone) points_.insert(p);
        }
        for (const CandidateMark& each : state.candidates) points_.insert(each.point);
        for (const Triangle& t : state.newTriangles) points_.insert({t.a, t.b, t.c});
    }
    void moveTo(FramePlan& plan) const {
        plan.points.assign(points_.begin(), points_.end());
        plan.pivots.assign(pivots_.begin(), pivots_.end());
    }

  private:
    std::set<Index> points_;
    std::set<Index> pivots_;
};

}  // namespace

Result<FramePlan> planFrames(const Model& model, const FrameRange& range) {
    RunCursor cursor(model.points, model.params);
    if (const Status moved = goToLast(cursor, range.to); !moved) return moved.error();
    const bool toStart = cursor.event() == nullptr;
    const Address last = toStart ? Address{} : cursor.event()->address;
    if (const Status moved = teach::goToPlace(cursor, range.from); !moved) return moved.error();
    FramePlan plan;
    PointCollector collector;
    for (;;) {
        const Event* event = cursor.event();
        if (isFrame(cursor, range.unit)) {
            if (plan.places.size() == kMaxFrames)
                return Error{"over " + std::to_string(kMaxFrames) +
                             " frames; choose a shorter range, or --unit pivot"};
            plan.places.push_back(event != nullptr ? toString(event->address) : "");
            collector.add(cursor.state());
        }
        const bool there = event == nullptr ? toStart : event->address == last;
        if (there) break;
        if (!cursor.forward()) return Error{range.to + " is before " + range.from};
    }
    if (plan.places.empty())
        return Error{"there is no split, join, seed or alert from " + range.from + " to " +
                     range.to};
    collector.moveTo(plan);
    return plan;
}

}  // namespace se::view
