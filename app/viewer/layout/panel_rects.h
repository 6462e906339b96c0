/// Areas of the panels, from the size of the window and of the text. Plain arithmetic.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "session/layout_preset.h"

namespace se::view {

struct Rect {
    glm::vec2 min{0.0F};
    glm::vec2 size{0.0F};

    glm::vec2 max() const { return min + size; }
    bool contains(glm::vec2 p) const {
        return p.x >= min.x && p.y >= min.y && p.x < max().x && p.y < max().y;
    }
};

/// The drawer with the strips under the view. Auto: folded in a low window.
enum class DrawerChoice : std::uint8_t { Auto, Folded, Open };

struct PanelRects {
    Rect menu;
    Rect transport;
    Rect left;  ///< Empty in a narrow window: then the right column holds everything, as tabs.
    Rect dial;  ///< Above the right column; empty in a narrow or low window: then it is a tab.
    Rect right;
    Rect view;
    Rect narration;
    Rect drawer;
    Rect status;
    bool dialApart = false;     ///< The dial has an area of its own.
    bool narrow = false;        ///< One side column only.
    bool drawerFolded = false;  ///< It holds the RUN strip alone.
    LayoutPreset layoutPreset = LayoutPreset::Debug;
    /// Height of the line with the address at the top of the narration; 0: the status bar has it.
    float addressLine = 0.0F;
    float caption =
        1.0F;  ///< Size of the text below the view, relative to that of the Debug layout.

    // Compare: `view` and `narration` are those of the open run.
    Rect title;  ///< Above the view.
    Rect otherView;
    Rect otherTitle;
    Rect otherNarration;

    // Parts of the drawer; the last two are empty if it is folded.
    Rect runStrip;
    Rect pivotStrip;
    Rect stageStrip;
};

/// A page with a form and controls of its own: menu, left column, view, and below it the narration
/// as the area of the controls. No other area has a size.
PanelRects computePageRects(glm::vec2 size, float em);

/// The view alone: no other area has a size.
inline PanelRects viewAlone(glm::vec2 size) {
    PanelRects rects;
    rects.view.size = size;
    return rects;
}

/// The view never gets less than 40 % of the width. Learn has all side panels in the left column;
/// Present has no panel but view, caption and the strip of the run: the other areas are empty.
/// Compare has two views, beside or above each other, whichever gives them more room.
PanelRects computePanelRects(glm::vec2 size, float em,
                             LayoutPreset layoutPreset = LayoutPreset::Debug,
                             DrawerChoice drawer = DrawerChoice::Auto);

}  // namespace se::view
