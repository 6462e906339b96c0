/// Traversal of a whole run, pivot by pivot, with its events: the basis of every query about a run.
/// Nothing is stored.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

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
struct ScannedPivot {
    Index point = kNone;            ///< pivotPoint() of the events.
    std::span<const Event> events;  ///< All events of the pivot, in order.
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

/// Runs `points` under `params` from the start and calls `visit` with each pivot that has events.
/// Returns the state at the end; nothing if `progress` cancelled (its share counts the points that
/// are DONE). Requires a valid PointSet. Deterministic.
std::optional<State> scanRun(const PointSet& points, const Params& params,
                             const std::function<void(const ScannedPivot&)>& visit,
                             const Progress& progress = {});

}  // namespace se
