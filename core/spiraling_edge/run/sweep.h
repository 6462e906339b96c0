/// A pass through a whole run, pivot by pivot, with its events: the basis of every query about a
/// run. Nothing is stored.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// Position of an event in a run. Addresses do not give this order, since stages may be repeated
/// within a pivot (docs/robust.md).
struct RunPosition {
    std::uint32_t pivot = 0;  ///< As in the address; 0 is the start of the run.
    std::uint32_t event = 0;  ///< From 0, among all events of that number.
    friend auto operator<=>(const RunPosition&, const RunPosition&) = default;
};

/// The point of the pivot that these events are of; kNone where there is none.
Index pivotPoint(std::span<const Event> events);

/// One pivot of a run, or one step after the last pivot.
struct SweptPivot {
    Index point = kNone;            ///< The pivot, also one passed over; kNone: there is none.
    std::span<const Event> events;  ///< All events of the pivot, in order; none if passed over.
    const State& after;             ///< The state after the pivot.
};

/// The work of a pivot in numbers, for charts and query lines.
struct PivotTally {
    /// Points of the active ring when the pivot began; 0 where there was no ring entry.
    std::uint32_t ringLength = 0;
    std::uint32_t candidates = 0;  ///< Neighbors that the sort of §6.1 kept, Fig. 3.
    std::uint32_t tests = 0;       ///< Decisions that took or refused something: the cost.
};

/// The tally of one pivot; `events` are all of its events.
PivotTally tallyOf(std::span<const Event> events);

/// Called with each pivot of a run that has events, in order, and with each that is passed over.
using PivotVisitor = std::function<void(const SweptPivot&)>;
/// True if the events of a pivot at `point` are wanted, given the state before it. Else they are
/// not made. Seeds, ears and the steps after the last pivot are always wanted.
using PivotChoice = std::function<bool(Index point, const State& before)>;

/// One pass through a run from the start, which can be made a few pivots at a time: a thread makes
/// it in one go, a program without threads between two pictures. Deterministic.
class Sweep {
  public:
    /// Requires a valid PointSet. Without `wants` every pivot is wanted.
    Sweep(SharedPoints points, const Params& params, PivotVisitor visit, PivotChoice wants = {});
    // The stepper writes to the log of this object.
    Sweep(const Sweep&) = delete;
    Sweep& operator=(const Sweep&) = delete;
    ~Sweep() = default;

    /// Runs `pivots` more pivots, or those that are left. False once the run is complete.
    bool advance(std::uint32_t pivots);
    /// Share of the points that are DONE, in [0, 1].
    double share() const;
    const State& state() const { return stepper_.state(); }
    /// The state at the present place, moved out: the pass cannot go on.
    State takeState() { return stepper_.takeState(); }

  private:
    /// The point of the next pivot if it is passed over.
    std::optional<Index> passedOver() const;

    PivotVisitor visit_;
    PivotChoice wants_;
    EventLog log_;
    Stepper stepper_;
};

/// A whole pass. Returns the state at the end; nothing if `progress`, which gets Sweep::share(),
/// cancelled.
std::optional<State> sweep(const PointSet& points, const Params& params, const PivotVisitor& visit,
                           const Progress& progress = {}, const PivotChoice& wants = {});

/// A question about a run that one pass answers. It borrows the points and params of the run.
template <typename Answer>
struct Question {
    PivotVisitor visit;
    std::function<Result<Answer>(const State& end)> answer;
    PivotChoice wants = {};
};

/// Makes the pass that answers a question. Fails also if `progress` cancelled.
template <typename Answer>
Result<Answer> ask(const PointSet& points, const Params& params, const Question<Answer>& question,
                   const Progress& progress = {}) {
    const std::optional<State> end =
        sweep(points, params, question.visit, progress, question.wants);
    if (!end) return Error{"Cancelled."};
    return question.answer(*end);
}

}  // namespace se
