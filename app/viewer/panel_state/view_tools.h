/// Tools that draw over the view: a piece of a scan, and the drag of a point. Plain values.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se::view {

// The tool that runs a piece of a scan: a box or a lasso drawn over the view. Plain values.

enum class PieceShape : std::uint8_t { Box, Lasso };

/// A line that is being drawn around points of the view.
struct EnclosingLine {
    bool drawing = false;
    PieceShape drawn = PieceShape::Box;  ///< Shape of `path`.
    /// Corners in pixels of the window; of a box its first corner and the pointer.
    std::vector<glm::vec2> path = {};

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

/// The line around points that get a breakpoint.
struct BreakLasso {
    EnclosingLine line = {};
    bool beside = false;  ///< It is drawn in the other view of the layout Compare.
};

struct PieceTool {
    bool on = false;
    PieceShape shape = PieceShape::Box;  ///< Of a drag without Shift.
    EnclosingLine line = {};
    std::vector<Index> inside = {};  ///< Points of the run that are enclosed, ascending.
    std::uint32_t generation = 0;    ///< Of the session that they belong to.
};

// The drag of a point in the view, while the panel What if is open. Plain values.

struct MoveTool {
    int offeredIn = -1;      ///< The last frame in which the panel was drawn.
    Index pressed = kNone;   ///< The point under a press that is no drag yet.
    bool holds = false;      ///< A point is being dragged.
    glm::vec2 offset{0.0F};  ///< From the pointer to the point, in pixels.
    bool alongNormal = false;
    glm::vec3 anchor{0.0F};  ///< View space: where the point came into its present plane or line.
};

}  // namespace se::view
