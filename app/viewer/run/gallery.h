/// The built-in scenes, as the viewer opens them.
#pragma once

#include <string_view>

#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

/// The scene of the failure gallery with that id, or of the source `scene:ID`; null if there is
/// none.
const FailureScene* galleryScene(std::string_view idOrSource);
/// The address that the source `scene:ID` opens at: that of the decision it demonstrates. Empty for
/// a scene that opens at its start, and for every other source.
std::string_view openingAddress(std::string_view source);

}  // namespace se::view
