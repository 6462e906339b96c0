/// What a pivot had to do, as numbers: what the charts count and query lines ask for.
#pragma once

#include <cstdint>
#include <span>

#include "spiraling_edge/stepper/event.h"

namespace se {

struct PivotTally {
    /// Points of the active ring as the pivot began; 0 where no ring entry was looked at.
    std::uint32_t ringLength = 0;
    std::uint32_t candidates = 0;  ///< Neighbors that the sort of §6.1 kept, Fig. 3.
    std::uint32_t tests = 0;       ///< Decisions that took or refused something: what it cost.
};

/// Requires all events of one pivot.
PivotTally tallyOf(std::span<const Event> events);

}  // namespace se
