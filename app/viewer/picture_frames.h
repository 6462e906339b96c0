/// Pictures of the program's frames, without a window: their size, and how they are drawn.
#pragma once

#include <glm/vec2.hpp>

#include "panel_state/picture_look.h"
#include "panel_state/settings.h"
#include "render/gl_objects.h"
#include "scene/picture.h"

namespace se::view {

class Application;

/// Pixels to draw for the size of the settings; sets their scale of text to that of the look.
glm::ivec2 drawnSize(ViewSettings& settings, const PictureLook& look);

/// Draws `frames` frames of `size` pixels, of which the first may only determine the layout, and
/// returns the last as the look has it: on no background, reduced. Call with a current context.
Picture drawPicture(Application& application, Target& target, glm::ivec2 size, int frames);

}  // namespace se::view
