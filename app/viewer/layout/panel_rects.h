/// Areas of the panels, from the size of the window and of the text. Plain arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "panel_sizes.h"
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

/// Handle of a splitter, which the user drags; empty where there is none.
struct SplitterPlace {
    Rect handle;
    bool sideways = false;  ///< Moves left and right, else up and down.
    float from = 0.0F;      ///< Edge of the part that it resizes, in pixels.
    float sign = 1.0F;      ///< -1: the part grows towards lower coordinates.
};

struct PanelRects {
    Rect menu;
    Rect transport;
    Rect left;   ///< Steps and rings, in Learn the groups; empty in a narrow window.
    Rect rings;  ///< Lower part of `left`; empty: the rings are a tab.
    Rect dial;   ///< Above the right column, in Learn below the left; empty: the dial is a tab.
    Rect right;
    Rect find;    ///< Below Steps and the view; empty: the groups share a column.
    Rect change;  ///< Beside `find`.
    Rect view;
    Rect narration;
    Rect drawer;
    Rect status;
    bool dialApart = false;     ///< The dial has an area of its own.
    bool narrow = false;        ///< One side column only.
    bool drawerFolded = false;  ///< It holds the RUN strip alone.
    bool groupsApart = false;   ///< `find` and `change` are there.
    std::array<SplitterPlace, kSplitterCount> splitters{};
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

/// Height of the title above each of two views, in em.
inline constexpr float kViewTitle = 1.7F;
/// Width of the line between two views of a picture, in em.
inline constexpr float kDividerEms = 0.1F;

/// Sizes of what a view alone has with it, in pixels; 0: it is not there.
struct BesideView {
    float narration = 0.0F;  ///< Height, below.
    float title = 0.0F;      ///< Height, above each of the two views of Compare.
    float dial = 0.0F;       ///< Width, to the right.
};
/// The view alone, or the two views of Compare: no other area has a size.
PanelRects viewAlone(glm::vec2 size, const BesideView& beside = {});

/// The view never gets less than 40 % of the width. Learn has all side panels in the left column,
/// the dial below; Present has no panel but view, caption and the strip of the run: the other areas
/// are empty. Compare has two views, beside or above each other, whichever gives them more room.
PanelRects computePanelRects(glm::vec2 size, float em,
                             LayoutPreset layoutPreset = LayoutPreset::Debug,
                             DrawerChoice drawer = DrawerChoice::Auto,
                             const PanelSizes& sizes = {});

}  // namespace se::view
