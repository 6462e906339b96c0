/// Pictures of the program's frames, without a window: their size, and how they are drawn.
#pragma once

#include <glm/vec2.hpp>

#include "panel_state/picture_look.h"
#include "panel_state/settings.h"
#include "render/context.h"
#include "render/gl_objects.h"
#include "scene/picture.h"

namespace se::view {

class Application;

/// Scale of text in a picture of that size, which is looked at as a whole: 1 up to 1280x800.
double textScale(glm::ivec2 size);

/// Pixels to draw for the size of the settings; sets their scale of text to that of the look.
glm::ivec2 drawnSize(ViewSettings& settings, const PictureLook& look);

/// Fails with a sentence if a picture of `size` pixels cannot be drawn, not even in tiles of which
/// no side exceeds `most` pixels.
Status checkDrawn(glm::ivec2 size, double uiScale, int most = greatestPicture());

/// Draws `frames` frames of `size` pixels, of which the first may only determine the layout, and
/// returns the last as the look has it: on no background, reduced. A picture with a side over
/// `most` pixels is drawn in tiles. Call with a current context.
Picture drawPicture(Application& application, Target& target, glm::ivec2 size, int frames,
                    int most = greatestPicture());

}  // namespace se::view
