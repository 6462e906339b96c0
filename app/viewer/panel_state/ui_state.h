/// What the user interface remembers and what it asks for. Plain values, no ImGui.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare_page.h"
#include "file_browser_state.h"
#include "growth_page.h"
#include "input/double_click_filter.h"
#include "input/go_to_box.h"
#include "input/key_map.h"
#include "input/tab_order.h"
#include "input/typing_wait.h"
#include "input/view_drag.h"
#include "layers/layer.h"
#include "layout/panel_rects.h"
#include "mesh_form.h"
#include "prepare_form.h"
#include "query_panel_state.h"
#include "rows/watch_plot.h"
#include "run/doctor_fixes.h"
#include "run/same_position.h"
#include "scene/camera.h"
#include "scene/mesh_style.h"
#include "scene/motion.h"
#include "scene/palette.h"
#include "scene/point_tint.h"
#include "session/annotations.h"
#include "session/layout_preset.h"
#include "session/playback.h"
#include "session/selection_facts.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/replay/breakpoint.h"
#include "start_page.h"
#include "step_panels_state.h"
#include "unsaved_prompt.h"
#include "what_if_offers.h"

namespace se::view {

class Session;

/// Kept in the settings.
struct ViewSettings {
    Theme theme = Theme::Dark;
    double uiScale = 0.0;  ///< 0: as the monitor says.
    LayerModes layers{};
    int width = 1280;
    int height = 800;
    double playRate = 4.0;
    bool legend = true;
    KeyMap keys;
    std::vector<std::string> complaints;  ///< What the settings say wrongly, one sentence each.
    MeshStyle meshStyle = MeshStyle::Flat;
    PointTint pointTint = PointTint::Status;
    std::optional<UpAxis> up;  ///< Of files; empty: guessed for each.
};

/// What the camera frames once the cursor is where it was sent.
enum class FrameWish : std::uint8_t { None, Focus, Pivot };

/// Asked for by a command or panel, carried out by the application in the same frame.
struct UiRequests {
    bool quit = false;    ///< May be asked about.
    bool reload = false;  ///< Likewise.
    bool screenshot = false;
    bool fullScreen = false;
    bool closePopups = false;
    int walk = 0;  ///< The keyboard goes to the next panel (+1), or to the one before (-1).
    bool copyPlace = false;
    bool pastePlace = false;
    bool frameAlert = false;  ///< The camera goes to the alert that is looked at.
    bool saveSession = false;
    FrameWish frame = FrameWish::None;
    bool undo = false;
    bool redo = false;
    std::optional<Cures> cures;    ///< To open the input anew with; none at all: as the file is.
    std::optional<RuleSet> rules;  ///< To run anew by; see withRule().
    Resume resume = Resume::SamePlace;  ///< With `rules`.
    std::string open;                   ///< A path or `scene:ID`; empty: nothing.
    std::string saveSessionAs;          ///< A path; empty: nothing.
    std::string copyText;               ///< For the clipboard; empty: nothing.
    /// An input with its options: prepared in another way, or points that were made here.
    std::optional<InputSpec> openSpec;
};

/// The tab that opens by itself when the doctor has found something.
inline constexpr const char* kDoctorTab = "Doctor";
inline constexpr const char* kBreakpointsTab = "Breakpoints";
inline constexpr const char* kWatchTab = "Watch";

/// The tab with what went wrong.
inline constexpr const char* kAlertsTab = "Alerts";

/// The tab with all rules as switches.
inline constexpr const char* kRulesTab = "Rules";

/// The tab with what may happen otherwise.
inline constexpr const char* kWhatIfTab = "What if";

/// The list of actions that one types into.
struct CommandPalette {
    bool open = false;
    bool justOpened = false;  ///< The line to type into gets the keyboard.
    std::array<char, 64> filter{};
    int chosen = 0;

    void show() { *this = {true, true, {}, 0}; }
};

/// The line that is being drawn about points of the view, in pixels of the window.
struct Lasso {
    bool drawing = false;
    std::vector<glm::vec2> path;
};

struct UiState {
    /// Something lies over the view that the keys are meant for.
    bool dialogOpen() const {
        return fileBrowser || cheatSheet || keyEditor || palette.open || goTo.active() ||
               prepare.open || leaving.asked;
    }

    /// The text fields that are open or about to be, as bits of TypedField.
    unsigned typedFields() const {
        return (palette.open ? kPaletteField : kNoField) |
               (fileBrowser && !mesh.waits() ? kBrowserField : kNoField) |
               (query.wantsKeyboard ? kQueryField : kNoField) |
               (ledger.wantsKeyboard ? kLedgerField : kNoField);
    }

    ViewSettings settings;
    UiRequests requests;
    GoToBox goTo;
    TypingWait typing;
    bool cheatSheet = false;
    bool keyEditor = false;
    KeyCapture keyCapture;
    bool fileBrowser = false;
    BrowserTask browser = BrowserTask::Open;
    FileBrowsing browsing;
    CommandPalette palette;
    PrepareForm prepare;
    GrowthPage growth;
    MeshForm mesh;
    ComparePage compare;
    LeaveQuestion leaving;
    bool quitting = false;  ///< Nothing is in the way: the window closes.
    Arrangement arrangement = Arrangement::Debug;
    Bookmarks bookmarks;
    std::vector<Breakpoint> breakpoints;
    std::vector<std::string> watches;  ///< Expressions, see core's watch.h.
    std::map<std::string, PaintedPlot> plots;
    Lasso lasso;
    ViewDrag viewDrag;
    Navigation navigation;
    LedgerPanel ledger;
    QueryPanel query;
    SubjectMenu subjectMenu;
    KeyWalk walk;
    bool popupOpen = false;           ///< A menu, say, as last drawn.
    std::string notes;                ///< Free text of the person, kept in the session file.
    std::string sessionPath;          ///< What Ctrl+S writes to; empty: not known yet.
    std::string unsaved;              ///< What is in no session file yet, see Filing::unsaved().
    std::vector<std::string> recent;  ///< Files opened lately, the latest first.
    StartPage startPage;
    float scale = 1.0F;       ///< Of text and panels, as drawn.
    float viewAspect = 1.3F;  ///< Of the view, as last drawn.
    /// Where what was drawn in this frame is, in pixels of the window: "region view", "tab Dial",
    /// "strip run"
    /// ... For --state-dump, so that whoever drives the window finds it.
    std::map<std::string, Rect> where;
    std::string openTab;
    std::string addressLine;  ///< What stands above the caption; empty: nothing.
    std::string shownCheck;   ///< Of the doctor: the finding whose points are marked.
    /// Classes of alerts that are folded or unfolded by hand.
    std::map<std::string, bool> alertsOpen;
    bool revealAlert = false;  ///< The list of alerts is to show the chosen one.
    std::string wantedTab;     ///< To be opened in the next frame; empty: as it is.
    LookBack look;             ///< At the state before the decision.
    double clock = 0.0;        ///< Seconds, as the frames count them.
    FactsCache facts;          ///< Of the selection.
    ClickWait click;           ///< In the view; it may be the first half of a double click.
    Index pointedAt = kNone;   ///< The point under the pointer, found anew in every frame.
    std::array<char, 64> ruleFilter{};
    WhatIfForm whatIf;
};

/// Everything a command may work on.
struct CommandContext {
    Session& session;
    Playback& playback;
    Camera& camera;
    UiState& ui;
};

}  // namespace se::view
