/// The texts over a view and above it: labels, and the title of one of two views.
#pragma once

#include <span>

#include "painter.h"
#include "scene/draw_list.h"
#include "session/compare_with.h"

namespace se::view {

/// Draws labels of a list on their plates. `other`: the list in the other theme; null: not needed.
void drawLabels(Painter& painter, std::span<const DrawnLabel> labels, const DrawList& list,
                const DrawList* other = nullptr);

/// Draws "A  paper rules", and at the right end the note, if there is room for it.
void drawTitleBar(Painter& painter, const Rect& bar, const ComparedTitle& title);

}  // namespace se::view
