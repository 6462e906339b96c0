/// The tool that runs a piece of a scan: a box or a lasso drawn over the view. Plain values.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se::view {

enum class PieceShape : std::uint8_t { Box, Lasso };

struct PieceTool {
    bool on = false;
    PieceShape shape = PieceShape::Box;  ///< Of a drag without Shift.
    bool drawing = false;
    PieceShape drawn = PieceShape::Box;  ///< Shape of `path`.
    /// Corners of the line that is being drawn, in pixels of the window; of a box its first corner
    /// and the pointer.
    std::vector<glm::vec2> path = {};
    std::vector<Index> inside = {};  ///< Points of the run that are enclosed, ascending.
    std::uint32_t generation = 0;    ///< Of the session that they belong to.

    void begin(glm::vec2 pointer, PieceShape with) {
        drawing = true;
        drawn = with;
        path.assign(with == PieceShape::Box ? 2 : 1, pointer);
    }
    /// The pointer has moved; corners of a lasso are at least `step` pixels apart.
    void moveTo(glm::vec2 pointer, float step);
    /// Ends the drawing. The closed line; empty if it encloses nothing.
    std::vector<glm::vec2> finish();
};

}  // namespace se::view
