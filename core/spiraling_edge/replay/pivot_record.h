/// One pivot of a run, copied from the timeline so that the window can show it while the timeline
/// works on another.
#pragma once

#include <memory>

#include "spiraling_edge/replay/timeline.h"
#include "status_list.h"

namespace se::view {

/// A State without its triangles, of which the number suffices: they are only ever appended.
struct RunState {
    StatusList status;
    EdgeRings rings;  ///< As EdgeRings::withoutPoints() gives them: their size goes with the rings.
    std::size_t triangleCount = 0;
    Counters counters;
    bool finished = false;
    /// Beyond the paper: the mesh that the steps after the last pivot edit; null before them.
    std::shared_ptr<const std::vector<Triangle>> repaired;
};

/// Everything about pivot number `pivot`. 0 is the beginning of the run and has no events.
struct PivotRecord {
    std::uint32_t pivot = 0;
    std::vector<Event> events;
    RunState before;
    RunState after;
    /// For the first step after the last pivot: the triangles of the run, which it is the first to
    /// edit. Otherwise null.
    std::shared_ptr<const std::vector<Triangle>> unrepaired;
    bool isLast = false;  ///< No event of the run follows.

    /// Position of the event with that address, or of the first event of its stage if n is 0.
    std::optional<std::size_t> find(const Address& address) const;
};

/// Takes pivot number `pivot` from the timeline, or the last one if the run is shorter.
std::shared_ptr<const PivotRecord> recordPivot(Timeline& timeline, std::uint32_t pivot);
/// Takes a pivot and shares with `last`, the statuses of an earlier record, the unchanged blocks;
/// `last` becomes the statuses of this one.
std::shared_ptr<const PivotRecord> recordPivot(Timeline& timeline, std::uint32_t pivot,
                                               StatusList& last);

}  // namespace se::view
