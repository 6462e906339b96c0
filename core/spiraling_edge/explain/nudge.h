/// Which move of which point turns a decision.
#pragma once

#include <optional>

#include "spiraling_edge/explain/closest_calls.h"

namespace se {

/// Where a decision was made.
struct NudgeContext {
    const PointSet& points;
    const Params& params;
    Index pivot, first, last;  ///< Points.
};

/// The shortest move, by Newton steps along the gradient of what was compared; empty if the event
/// has no reading, or if no small move turns it.
std::optional<Nudge> nudgeOf(const Event& event, const NudgeContext& context);

}  // namespace se
