/// The shape of the active ring.
#pragma once

#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/stepper/step_context.h"

namespace se {

using RingShape = LoopShape;
/// The shape of the active ring. Requires one. O(ring).
RingShape shapeOfRing(const StepContext& context);

}  // namespace se
