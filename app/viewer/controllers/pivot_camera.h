/// A camera for the picture of one decision.
#pragma once

#include "scene/camera.h"
#include "session/session.h"

namespace se::view {

/// Looks from obliquely above the disc of the pivot at what its decisions are about, as near as
/// leaves room for their names in a view of `size`, in em. Without a pivot nothing happens.
void closeUp(const Session& session, Camera& camera, glm::vec2 size);

}  // namespace se::view
