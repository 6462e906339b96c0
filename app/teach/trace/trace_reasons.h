/// The decisions that account for the first difference between a trace and our run.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "trace_diff.h"

namespace se::teach {

/// The last change of the rings about each point.
using RingChanges = std::unordered_map<Index, Event>;

/// Adds the changes of a pivot.
void takeRingChanges(const std::vector<Event>& events, RingChanges& changes);

/// The difference at a pivot. `run`: nothing if our run has ended. `before`: our events of the
/// pivot before; `events`: those of this one. Without a stage it is the pivot itself that differs.
TraceDifference differenceAt(TracePivot trace, std::optional<TracePivot> run,
                             std::optional<TraceStage> stage, const std::vector<Event>& before,
                             const RingChanges& changes, const std::vector<Event>& events,
                             const PointSet& points);

}  // namespace se::teach
