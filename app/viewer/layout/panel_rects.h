/// Areas of the window, from its size and that of the text. Plain arithmetic.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "session/layout_preset.h"

namespace se::view {

// Sizes of panels that the user sets. Plain values.

struct PanelSizes {
    float column = 0.0F;  ///< Width of the column in em; 0: automatic.
    bool folded = false;  ///< The column is folded to its rail.
    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

struct Rect {
    glm::vec2 min{0.0F};
    glm::vec2 size{0.0F};

    glm::vec2 max() const { return min + size; }
    bool contains(glm::vec2 p) const {
        return p.x >= min.x && p.y >= min.y && p.x < max().x && p.y < max().y;
    }
};

/// The strip below the view. Auto: its lanes are folded on a finished run and in a low window.
enum class StripChoice : std::uint8_t { Auto, Folded, Open };

struct PanelRects {
    Rect menu;
    Rect view;
    /// The sentence below the view, where it does not lie in it (Present, pages, a phone's shape).
    Rect narration;
    Rect column;  ///< The panel of the task; empty: it is folded.
    Rect rail;    ///< The tasks: right of the column, or in a phone's shape below all.
    Rect strip;   ///< Below the view: its parts follow, each empty where there is no room for it.
    Rect transport;
    Rect pivotStrip;  ///< The decisions of the pivot; empty on a finished run.
    Rect figures;     ///< The most important counts of the run.
    Rect runStrip;    ///< The lanes of the run; in a folded strip a line of it.
    Rect stageStrip;
    Rect left;                 ///< The form of a page.
    Rect dial;                 ///< Beside a view alone.
    Rect splitter;             ///< Handle between view and column.
    bool phone = false;        ///< A phone's shape: one column, of which the sheet takes half.
    bool stripFolded = false;  ///< The run is a line beside the transport.
    LayoutPreset layoutPreset = LayoutPreset::Debug;
    /// Height of the line with the address at the top of the narration; 0: it has none.
    float addressLine = 0.0F;
    float caption = 1.0F;  ///< Size of the text below the view, relative to that over it.

    // Compare: `view` and `narration` are those of the open run.
    Rect title;  ///< Above the view.
    Rect otherView;
    Rect otherTitle;

    glm::vec2 window{0.0F};  ///< Size of all.

    /// The views, with the titles above them, span this height from the top.
    float viewsTop() const { return title.size.y > 0.0F ? title.min.y : view.min.y; }
    bool captionInView() const { return narration.size.y <= 0.0F; }
};

/// State of the window on which the areas depend, beside its size.
struct WindowState {
    LayoutPreset layoutPreset = LayoutPreset::Debug;
    StripChoice strip = StripChoice::Auto;
    PanelSizes sizes;
    bool sheet = false;     ///< In a phone's shape: the sheet is pulled up.
    bool asks = false;      ///< In a phone's shape: a question needs the room of rail and strip.
    bool finished = false;  ///< The finished mesh is shown: no pivot has decisions.
    bool lesson = false;    ///< In Present: the text of a lesson is the caption, without the strip.
    float captionEms = 0.0F;  ///< Height of that text in em, up to a limit; 0: not known yet.
    bool beside = false;      ///< In Present: a second view beside the first.
};

/// A page with a form and controls of its own: menu, left column, view, and below it the narration
/// as the area of the controls. No other area has a size.
PanelRects computePageRects(glm::vec2 size, float em);

/// Least height of what a finger taps, in em: 44 pixels of a phone.
inline constexpr float kFinger = 2.75F;
/// Largest share of the height that the text of a lesson has in Present.
inline constexpr float kLargestLessonShare = 0.4F;
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

/// Menu above, column and rail to the right, strip below; the view has the rest. Present has no
/// panel but view, caption and the lanes of the run. Compare has two views, beside or above each
/// other, whichever gives them more room.
PanelRects computePanelRects(glm::vec2 size, float em, const WindowState& state = {});

}  // namespace se::view
