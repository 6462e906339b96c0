/// Shapes of points and signs of rings.
#pragma once

#include "painter.h"
#include "scene/palette.h"

namespace se::view {

/// Draws the shape of a point, as shaders/point.frag draws it. `halo`, if over 0: draws only the
/// line around the shape that reaches so far beyond it.
void drawShape(Painter& painter, glm::vec2 center, float size, Shape shape, const Ink& ink,
               float halo = 0.0F);

/// Draws the sign of the active ring, thick, from the middle of its left end; `em`: its scale.
void drawActiveRing(Painter& painter, glm::vec2 left, float em, const Ink& ink);
/// Draws the sign of a ring on the stack, dashed.
void drawWaitingRing(Painter& painter, glm::vec2 left, float em, const Ink& ink);

}  // namespace se::view
