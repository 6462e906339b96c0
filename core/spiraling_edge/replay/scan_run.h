/// Traversal of a whole run, pivot by pivot, with its events: the basis of every query about a run.
/// Nothing is stored.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
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

/// Assigns the events of a run their places. next() must be called with every event, in order.
class PositionCounter {
  public:
    RunPosition next(const Event& event) {
        const bool same = event.address.pivot == place_.pivot;
        place_ = {event.address.pivot, same ? place_.event + 1 : 0};
        return place_;
    }

  private:
    RunPosition place_;
};

/// One pivot of a run, or one step after the last pivot.
struct ScannedPivot {
    Index point = kNone;            ///< The pivot's point; kNone where there is none.
    std::span<const Event> events;  ///< All events of the pivot, in order.
    const State& after;             ///< The state after the pivot.
};

/// Runs `points` under `params` from the start and calls `visit` with each pivot that has events.
/// Returns the state at the end; nothing if `progress` cancelled (its share counts the points that
/// are DONE). Requires a valid PointSet. Deterministic.
std::optional<State> scanRun(const PointSet& points, const Params& params,
                             const std::function<void(const ScannedPivot&)>& visit,
                             const Progress& progress = {});

}  // namespace se
