/// Labels where they were drawn, for pictures made of shapes.
#pragma once

#include <cstddef>

#include "panel_rects.h"

namespace se::view {

/// Opacity of a plate, and opacity and width in em of the line that leads to it.
inline constexpr float kPlateAlpha = 0.78F;
inline constexpr float kLeaderAlpha = 0.7F;
inline constexpr float kLeaderEms = 0.06F;

/// One label of a view, in pixels of the window.
struct DrawnLabel {
    std::size_t index = 0;  ///< Into the labels of the draw list.
    glm::vec2 at{0.0F};     ///< The labeled point.
    Rect plate;             ///< Behind the text.
    glm::vec2 text{0.0F};   ///< Upper left corner of the text.
    float size = 16.0F;     ///< Height of a line.
    bool leader = false;    ///< A line leads from `at` to the plate.

    DrawnLabel movedBy(glm::vec2 way) const {
        return {index, at + way, {plate.min + way, plate.size}, text + way, size, leader};
    }
};

}  // namespace se::view
