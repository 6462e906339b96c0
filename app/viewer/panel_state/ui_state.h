/// State and requests of the user interface. Plain values, no ImGui.
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
    double uiScale = 0.0;  ///< 0: that of the monitor.
    LayerModes layers{};
    int width = 1280;
    int height = 800;
    double playRate = 4.0;
    bool legend = true;
    KeyMap keys;
    std::vector<std::string> complaints;  ///< Errors in the settings, one sentence each.
    MeshStyle meshStyle = MeshStyle::Flat;
    PointTint pointTint = PointTint::Status;
    std::optional<UpAxis> up;  ///< For files; empty: guessed for each.
};

/// Target of the camera once the cursor has arrived.
enum class FrameWish : std::uint8_t { None, Focus, Pivot };

/// Requests of a command or panel, carried out by the application in the same frame.
struct UiRequests {
    bool quit = false;    ///< May open a question first.
    bool reload = false;  ///< May open a question first.
    bool screenshot = false;
    bool fullScreen = false;
    bool closePopups = false;
    int walk = 0;  ///< Keyboard focus to the next panel (+1), or to the previous one (-1).
    bool copyPlace = false;
    bool pastePlace = false;
    bool frameAlert = false;  ///< The camera goes to the chosen alert.
    bool saveSession = false;
    FrameWish frame = FrameWish::None;
    bool undo = false;
    bool redo = false;
    std::optional<Fixes> fixes;  ///< Fixes to open the input with again; empty: the file as it is.
    std::optional<RuleSet> rules;          ///< Rules to re-run with; see withRule().
    Resume resume = Resume::SamePosition;  ///< With `rules`.
    std::string open;                      ///< A path or `scene:ID`; empty: nothing.
    std::string saveSessionAs;             ///< A path; empty: nothing.
    std::string copyText;                  ///< Text for the clipboard; empty: nothing.
    /// An input with its options: prepared in another way, or sampled points.
    std::optional<InputSpec> openSpec;
};

/// The tab that opens by itself when the doctor has found a problem.
inline constexpr const char* kDoctorTab = "Doctor";
inline constexpr const char* kBreakpointsTab = "Breakpoints";
inline constexpr const char* kWatchTab = "Watch";

/// The tab with the alerts.
inline constexpr const char* kAlertsTab = "Alerts";

/// The tab with all rules as switches.
inline constexpr const char* kRulesTab = "Rules";

/// The tab for overriding decisions.
inline constexpr const char* kWhatIfTab = "What if";

/// The command palette.
struct CommandPalette {
    bool open = false;
    bool justOpened = false;  ///< The input line gets the keyboard focus.
    std::array<char, 64> filter{};
    int chosen = 0;

    void show() { *this = {true, true, {}, 0}; }
};

/// The lasso that is being drawn around points of the view, in pixels of the window.
struct Lasso {
    bool drawing = false;
    std::vector<glm::vec2> path;
};

struct UiState {
    /// An overlay above the view takes the keys.
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
    bool quitting = false;  ///< No unsaved work: the window closes.
    LayoutPreset layoutPreset = LayoutPreset::Debug;
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
    bool popupOpen = false;   ///< Overlays, such as a menu, as last drawn.
    std::string notes;        ///< Free text by the user, stored in the session file.
    std::string sessionPath;  ///< File written by Ctrl+S; empty: not known yet.
    std::string
        unsaved;  ///< Annotations in no session file yet, see DocumentController::unsaved().
    std::vector<std::string> recent;  ///< Files opened lately, the latest first.
    StartPage startPage;
    float scale = 1.0F;       ///< Of text and panels, as drawn.
    float viewAspect = 1.3F;  ///< Of the view, as last drawn.
    /// Rectangles of the items drawn in this frame, in pixels of the window: "region view", "tab
    /// Dial", "strip run"
    /// ... For --state-dump, so that test scripts find them.
    std::map<std::string, Rect> where;
    std::string openTab;
    std::string addressLine;  ///< Line above the caption; empty: none.
    std::string shownCheck;   ///< The doctor's finding whose points are highlighted.
    /// Classes of alerts that were folded or unfolded by the user.
    std::map<std::string, bool> alertsOpen;
    bool revealAlert = false;  ///< The list of alerts scrolls to the chosen one.
    std::string wantedTab;     ///< Tab to open in the next frame; empty: unchanged.
    LookBack look;             ///< Whether the state before the decision is shown.
    double clock = 0.0;        ///< Seconds, summed over the frames.
    FactsCache facts;          ///< Of the selection.
    DoubleClickFilter click;   ///< In the view; it may be the first half of a double click.
    Index pointedAt = kNone;   ///< The point under the pointer, determined again in every frame.
    std::array<char, 64> ruleFilter{};
    WhatIfForm whatIf;
};

/// Everything that a command may use.
struct CommandContext {
    Session& session;
    Playback& playback;
    Camera& camera;
    UiState& ui;
};

}  // namespace se::view
