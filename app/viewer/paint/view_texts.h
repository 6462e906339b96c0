/// What stands over a view and above it: labels, and the title of one of two views.
#pragma once

#include <span>

#include "painter.h"
#include "scene/draw_list.h"
#include "session/compare_with.h"

namespace se::view {

/// One label of a view where it is drawn, in pixels of the window.
struct DrawnLabel {
    std::size_t index = 0;  ///< Into the labels of the draw list.
    glm::vec2 at{0.0F};     ///< The labeled point.
    Rect plate;             ///< Behind the text.
    glm::vec2 text{0.0F};   ///< Upper left corner of the text.
    Type type;
    bool leader = false;  ///< A line leads from `at` to the plate.

    DrawnLabel movedBy(glm::vec2 way) const {
        return {index, at + way, {plate.min + way, plate.size}, text + way, type, leader};
    }
};

/// Draws labels of a list on their plates. `other`: the list in the other theme; null: not needed.
void drawLabels(Painter& painter, std::span<const DrawnLabel> labels, const DrawList& list,
                const DrawList* other = nullptr);

/// Draws "A  paper rules", and at the right end the note, if there is room for it.
void drawTitleBar(Painter& painter, const Rect& bar, const ComparedTitle& title);

}  // namespace se::view
