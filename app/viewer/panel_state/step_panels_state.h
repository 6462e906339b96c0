/// State of the panels for moving in the run. Plain values, no ImGui.
#pragma once

#include <array>

#include "layout/panel_rects.h"
#include "rows/lane_picture.h"
#include "rows/step_tree.h"

namespace se::view {

/// The lanes as last painted, and the inputs of that painting.
struct PaintedLanes {
    std::uint32_t generation = 0;
    std::size_t pivots = 0;
    std::size_t changes = 0;
    bool complete = false;
    StripWindow window;
    LaneRoom room;
    LanePicture picture;
};

/// Something that follows the cursor, but only when it moves, so that the user can scroll away.
class CursorWatch {
  public:
    /// True for two frames after a move: sizes are known one frame late.
    bool moved(std::uint32_t generation, std::uint32_t pivot, std::size_t cursor);

  private:
    std::uint32_t generation_ = 0;
    std::uint32_t pivot_ = 0;
    std::size_t cursor_ = 0;
    int again_ = 0;
};

struct Navigation {
    DrawerWish drawer = DrawerWish::Auto;
    bool drawerFolded = false;  ///< As last laid out.
    StripWindow strip;
    PaintedLanes lanes;
    CursorWatch stripWatch;
    StepTree steps;
    CursorWatch stepsWatch;
    std::array<char, 64> stepFilter{};
    CursorWatch paperWatch;
    Index pointedAt = kNone;    ///< The point under the pointer, determined again in every frame.
    Index pointedRing = kNone;  ///< The ring under the pointer, determined again in every frame.
    CursorWatch ringWatch;
    long ringShift = 0;  ///< Offset of the ring strip, in points.

    /// Folds the drawer if it is open, otherwise opens it, regardless of the height of the window.
    void toggleDrawer() { drawer = drawerFolded ? DrawerWish::Open : DrawerWish::Folded; }
};

}  // namespace se::view
