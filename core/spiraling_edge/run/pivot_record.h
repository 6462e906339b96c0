/// One pivot of a run as a value: its events and the state before and after it, apart from the
/// timeline, which can go on to another pivot.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "spiraling_edge/run/status_list.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

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
    PaperRules rules;  ///< Of the run.
    /// For the first step after the last pivot: the triangles of the run, which it is the first to
    /// edit. Otherwise null.
    std::shared_ptr<const std::vector<Triangle>> unrepaired;
    bool isLast = false;  ///< Known to be the last of the run, whose end may be unknown.

    /// Position of the event with that address, or of the first event of its stage if n is 0. A
    /// number alone, {n}, is where it begins: at its event of stage Pivot, or, where it has none,
    /// as with fills and steps after the last pivot, at its first event.
    std::optional<std::size_t> find(const Address& address) const;
};

}  // namespace se
