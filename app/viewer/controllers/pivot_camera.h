/// A camera for the picture of one decision.
#pragma once

#include "scene/camera.h"
#include "session/session.h"

namespace se::view {

/// Looks from obliquely above the disc of the pivot at the points of its decisions, as close as
/// their names allow in a view of `size`, in em. No effect without a pivot.
void framePivotNeighborhood(const Session& session, Camera& camera, glm::vec2 size);

}  // namespace se::view
