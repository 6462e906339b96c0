/// Going through a whole run pivot by pivot with its events: what every question about a run is
/// answered from. Nothing is stored.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "spiraling_edge/event.h"
#include "spiraling_edge/params.h"
#include "spiraling_edge/point_set.h"
#include "spiraling_edge/prepare.h"
#include "spiraling_edge/state.h"

namespace se {

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
