/// Two runs on one timeline: the position of the other run for a position of this one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// The common part of the timelines of two runs A and B.
struct RunAlignment {
    std::uint32_t alike = 0;  ///< Number of equal pivots at the start.
    bool parted = false;      ///< The runs are not equal to the end.
    std::uint32_t endA = 0;   ///< Number of pivots of each.
    std::uint32_t endB = 0;
};

/// The pivot of B that matches one of A: the same one up to that of the first difference; after
/// it the same share of what is left, so that both ends match. Monotonic in `pivot`.
std::uint32_t matchingPivot(const RunAlignment& alignment, std::uint32_t pivot);
/// True if both are in the same pivot: then B follows stage by stage, otherwise by whole pivots.
bool inStep(const RunAlignment& alignment, std::uint32_t pivot);

/// The event of B that matches A's event at `cursor`, in the same pivot: that of the same
/// address, otherwise the last one of no later stage. Requires that B has events.
std::size_t matchingEvent(std::span<const Event> a, std::size_t cursor, std::span<const Event> b);

}  // namespace se::view
