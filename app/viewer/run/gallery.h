/// The scenes that fail, as the viewer opens them.
#pragma once

#include <string_view>

#include "spiraling_edge/scenes.h"

namespace se::view {

/// The scene of the failure gallery with that id, or of the source `scene:ID`; null if there is
/// none.
const FailureScene* galleryScene(std::string_view idOrSource);

}  // namespace se::view
