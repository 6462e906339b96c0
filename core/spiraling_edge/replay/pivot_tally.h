/// The work of a pivot in numbers, for charts and query lines.
#pragma once

#include <cstdint>
#include <span>

#include "spiraling_edge/stepper/event.h"

namespace se {

struct PivotTally {
    /// Points of the active ring when the pivot began; 0 where there was no ring entry.
    std::uint32_t ringLength = 0;
    std::uint32_t candidates = 0;  ///< Neighbors that the sort of §6.1 kept, Fig. 3.
    std::uint32_t tests = 0;       ///< Decisions that took or refused something: the cost.
};

/// The tally of one pivot; `events` are all of its events.
PivotTally tallyOf(std::span<const Event> events);

}  // namespace se
