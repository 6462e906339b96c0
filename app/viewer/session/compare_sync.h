/// Two runs on one timeline: where the other run stands when this one stands somewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// What the timelines of two runs A and B have in common.
struct TwinTimes {
    std::uint32_t alike = 0;  ///< So many pivots do the same.
    bool parted = false;      ///< They do not do the same to the end.
    std::uint32_t endA = 0;   ///< Pivots of each.
    std::uint32_t endB = 0;
};

/// The pivot of B that belongs to one of A: the same one up to that of the first difference; behind
/// it the same share of what is left, so that both ends belong together. Never falls as `pivot`
/// rises.
std::uint32_t twinPivot(const TwinTimes& times, std::uint32_t pivot);
/// True if both are in the same pivot: then B follows stage by stage, else it shows whole pivots.
bool inStep(const TwinTimes& times, std::uint32_t pivot);

/// The event of B that belongs to A's event at `cursor`, in the same pivot: that of the same
/// address, or else the last one of no later stage. Requires that B has events.
std::size_t twinCursor(std::span<const Event> a, std::size_t cursor, std::span<const Event> b);

}  // namespace se::view
