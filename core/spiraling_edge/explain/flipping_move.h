/// The least move of a point that inverts a decision.
#pragma once

#include <optional>

#include "spiraling_edge/explain/nearest_decisions.h"

namespace se {

/// The context of a decision.
struct FlippingMoveContext {
    const PointSet& points;
    const Params& params;
    Index pivot, first, last;  ///< Points.
};

/// The shortest move, by Newton steps along the gradient of the compared number; empty if the event
/// has no reading, or if no small move inverts it.
std::optional<FlippingMove> flippingMoveOf(const Event& event, const FlippingMoveContext& context);

}  // namespace se
