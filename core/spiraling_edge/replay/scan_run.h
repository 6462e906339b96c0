/// Going through a whole run pivot by pivot with its events: what every question about a run is
/// answered from. Nothing is stored.
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

/// Which event of which pivot: the order of a run. Addresses alone do not have it, since stages may
/// come round again within a pivot (docs/robust.md).
struct RunPlace {
    std::uint32_t pivot = 0;  ///< As in the address; 0 is the start of the run.
    std::uint32_t event = 0;  ///< From 0, among all events of that number.
    friend auto operator<=>(const RunPlace&, const RunPlace&) = default;
};

/// Gives the events of a run their places; it must be shown all of them, in order.
class PlaceCounter {
  public:
    RunPlace next(const Event& event) {
        const bool same = event.address.pivot == place_.pivot;
        place_ = {event.address.pivot, same ? place_.event + 1 : 0};
        return place_;
    }

  private:
    RunPlace place_;
};

/// One pivot of a run, or one step after the last pivot.
struct ScannedPivot {
    Index point = kNone;            ///< The pivot's point; kNone where there is none.
    std::span<const Event> events;  ///< All of them, in order; addresses as everywhere.
    const State& after;             ///< The state behind the pivot.
};

/// Runs `points` under `params` from the start and shows each pivot that has events to `visit`. The
/// state at the end; nothing if `progress` cancelled (its share counts the points that are DONE).
/// Requires a valid PointSet. Deterministic.
std::optional<State> scanRun(const PointSet& points, const Params& params,
                             const std::function<void(const ScannedPivot&)>& visit,
                             const Progress& progress = {});

}  // namespace se
