/// Shapes of points and signs of rings.
#pragma once

#include <span>

#include "painter.h"
#include "scene/draw_list.h"
#include "session/compare_with.h"

namespace se::view {

/// Draws the shape of a point, as shaders/point.frag draws it. `halo`, if over 0: draws only the
/// line around the shape that reaches so far beyond it.
void drawShape(Painter& painter, glm::vec2 center, float size, Shape shape, const Ink& ink,
               float halo = 0.0F);

/// Draws the sign of the active ring, thick, from the middle of its left end; `em`: its scale.
void drawActiveRing(Painter& painter, glm::vec2 left, float em, const Ink& ink);
/// The same of a ring that waits, in dashes.
void drawWaitingRing(Painter& painter, glm::vec2 left, float em, const Ink& ink);

// What stands over a view and above it: labels, and the title of one of two views.

/// Draws labels of a list on their plates. `other`: the list in the other theme; null: not needed.
void drawLabels(Painter& painter, std::span<const DrawnLabel> labels, const DrawList& list,
                const DrawList* other = nullptr);

/// Draws "A  paper rules", and at the right end the note, if there is room for it.
void drawTitleBar(Painter& painter, const Rect& bar, const ComparedTitle& title);

}  // namespace se::view
