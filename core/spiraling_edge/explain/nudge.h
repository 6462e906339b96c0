/// The least move of a point that inverts a decision.
#pragma once

#include <optional>

#include "spiraling_edge/explain/closest_calls.h"

namespace se {

/// The context of a decision.
struct NudgeContext {
    const PointSet& points;
    const Params& params;
    Index pivot, first, last;  ///< Points.
};

/// The shortest move, by Newton steps along the gradient of the compared number; empty if the event
/// has no reading, or if no small move inverts it.
std::optional<Nudge> nudgeOf(const Event& event, const NudgeContext& context);

}  // namespace se
