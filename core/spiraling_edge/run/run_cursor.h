/// A cursor at any decision of a run, for debuggers and viewers: forward and back by decision, by
/// phase and by pivot, to an address, and to the next decision that meets a condition.
#pragma once

#include <memory>

#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/run/timeline.h"

namespace se {

/// The size of a step of a RunCursor.
enum class StepUnit : std::uint8_t {
    Decision,  ///< To the next event.
    Phase,     ///< To the next event that is the last of its stage.
    Pivot,     ///< To the next event that is the last of its pivot.
};

/// A place in a run: the start, or just after an event. Back and forward are symmetric: a step back
/// goes to the previous place of that unit, at last to the start.
///
/// Example: `RunCursor at(points, params); at.goTo({137, Stage::Sphere, 2}); draw(at.state());`
class RunCursor {
  public:
    /// At the start of the run. The points must pass validate().
    RunCursor(const SharedPoints& points, const Params& params);

    /// The event just before the cursor; null at the start. Valid until the cursor moves: an Event
    /// is a value, copy it to keep it.
    const Event* event() const;
    /// The state at the cursor: rings, neighbor ring, candidates, fan and statuses.
    DecisionState state() const { return replay_.after(event_); }
    /// The state just before event().
    DecisionState stateBefore() const { return replay_.before(event_); }
    /// The pivot of event(), with all its events.
    const PivotRecord& pivot() const { return replay_.record(); }
    /// The run between two pivots: its mesh, its length.
    const Timeline& timeline() const { return timeline_; }

    /// Goes to the next place. False, unmoved, if there is none.
    bool forward(StepUnit unit = StepUnit::Decision);
    /// Goes to the previous place. False, unmoved, at the start.
    bool back(StepUnit unit = StepUnit::Decision);
    /// Goes to a decision, or to the first one of its stage if Address::n is 0; a number alone,
    /// {n}, is where it begins (PivotRecord::find()), also of the steps after the last pivot.
    /// False, unmoved, if the run has no such decision.
    bool goTo(const Address& address);
    void goToStart();
    /// Goes to the last event of the run.
    void goToEnd();
    /// Goes to the next decision after the cursor that meets the condition; the run is made only as
    /// far as that. If there is none: false, and the cursor is at the end of the run.
    /// Decision::failures is 0: for conditions on failures see findDecisions().
    bool runUntil(const DecisionCondition& condition);
    /// Goes to the next decision after the cursor that matches a query line. Requires
    /// !query.needsFailures().
    bool runUntil(const DecisionQuery& query);

  private:
    bool isPlace(std::size_t i, StepUnit unit) const;
    bool load(std::uint32_t pivot);

    Timeline timeline_;
    PivotReplay replay_;
    std::size_t event_ = 0;  ///< Position in the events of the pivot.
};

}  // namespace se
