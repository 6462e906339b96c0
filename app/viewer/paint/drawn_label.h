/// Where a label of a view is drawn.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "layout/panel_rects.h"
#include "painter.h"

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

}  // namespace se::view
