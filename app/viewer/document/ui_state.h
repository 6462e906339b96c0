/// State of the user interface: that of each panel. Plain values, no ImGui.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/comparison.h"
#include "input/key_routing.h"
#include "input/view_drag.h"
#include "lesson/lesson_walk.h"
#include "paint/painter.h"
#include "panel_state/column.h"
#include "panel_state/file_browser_state.h"
#include "panel_state/forms.h"
#include "panel_state/panel_states.h"
#include "panel_state/picture_look.h"
#include "panel_state/settings.h"
#include "panel_state/side_panels.h"
#include "panel_state/view_tools.h"
#include "scene/motion.h"
#include "session/selection_facts.h"
#include "session/session_file.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

/// The clipboard: of the desktop once it is connected, until then a text in memory.
class Clipboard {
  public:
    using Read = std::function<std::string()>;
    using Write = std::function<void(const std::string& text)>;

    void connect(Read read, Write write) {
        read_ = std::move(read);
        write_ = std::move(write);
    }
    std::string text() const { return read_ ? read_() : text_; }
    void copy(const std::string& text) {
        text_ = text;
        if (write_) write_(text);
    }
    /// The last text that this program has copied.
    const std::string& copied() const { return text_; }

  private:
    Read read_;
    Write write_;
    std::string text_;
};

// Files of the reader's machine where the program sees only its own, as in a page.

struct HostFiles {
    /// Lets the reader choose files, which arrive as dropped ones. Empty: the program sees the
    /// machine's files itself.
    std::function<void()> pick;

    /// Files are known only as long as the page: saved ones go to the downloads.
    bool apart() const { return static_cast<bool>(pick); }
};

// The question before unsaved work is left.

enum class LeaveFor : std::uint8_t { Quit, Open, Reload };
enum class LeaveAnswer : std::uint8_t { Save, Discard, Cancel };

/// Destination after the question.
struct Leave {
    LeaveFor what = LeaveFor::Quit;
    std::function<void()> go = nullptr;  ///< Leaves; called between frames.
    bool keeps = false;                  ///< The open input stays open, and nothing is lost.
};

/// The question, while it is open.
struct LeaveQuestion {
    bool asked = false;
    bool justAsked = false;  ///< The first button gets the keyboard focus.
    Leave leave;
    std::string atStake;  ///< Unsaved annotations: "bookmarks and watches".

    void ask(Leave to, std::string unsaved) {
        *this = {true, true, std::move(to), std::move(unsaved)};
    }
};

// Calls that would destroy what is being drawn: they wait for the end of the frame.

class BetweenFrames {
  public:
    /// Makes the call at once, or at the end of the frame that is being drawn.
    void operator()(std::function<void()> call) {
        if (!drawing_) return call();
        waiting_.push_back(std::move(call));
    }
    void beginDrawing() { drawing_ = true; }
    /// Makes the calls that wait, in their order.
    void endDrawing() {
        drawing_ = false;
        for (const auto& call : std::exchange(waiting_, {})) call();
    }

  private:
    bool drawing_ = false;
    std::vector<std::function<void()>> waiting_;
};

/// The box with the address, which is open while another one is typed there.
struct GoToBox {
    bool open = false;
    std::string typed;
};

struct CommandPalette {
    bool open = false;
    bool justOpened = false;  ///< The input line gets the keyboard focus.
    std::array<char, 64> filter{};
    int chosen = 0;

    void show() { *this = {true, true, {}, 0}; }
};

/// Target of the camera once the cursor has arrived.
enum class FrameRequest : std::uint8_t {
    None,
    Home,   ///< All of the input, broadside.
    Focus,  ///< The selection, or the decision.
    Decision,
    Unseen,  ///< The decision, if its pivot is outside of the view.
    Fault,   ///< The chosen place with faults, or alert.
};

/// Motion of the camera with the run.
enum class Follow : std::uint8_t {
    Never,         ///< Turned off by the user.
    LeavingPivot,  ///< While playing, to a pivot that has left the view.
    EachDecision,  ///< To the view of each decision.
};

/// The usual motion in a layout.
inline Follow followIn(LayoutPreset layout) {
    return rowOf(layout).follows ? Follow::EachDecision : Follow::LeavingPivot;
}

/// The page of the menu Help that is open.
enum class HelpPage : std::uint8_t { None, Guide, Keys, ChangeKeys, About };

struct UiState {
    UiState() = default;
    /// Its references are to its own states.
    UiState(const UiState&) = delete;
    UiState& operator=(const UiState&) = delete;

    /// An overlay above the view takes the keys.
    bool coversView() const {
        return fileBrowser || help != HelpPage::None || palette.open || leaving.asked;
    }

    /// The part of the view in which the camera frames its subject.
    ViewPart viewPart() const { return {viewAspect, coveredBelow}; }

    /// What panels remember. Those below are read by others as well.
    PanelStates states;

    ViewSettings settings;
    BetweenFrames betweenFrames;
    Clipboard clipboard;
    HostFiles hostFiles;
    std::string pageAddress;  ///< Of the page that is the program, without #; empty: there is none.
    FrameRequest frame = FrameRequest::None;
    bool takesPicture = false;  ///< The next frame is saved as a picture.
    bool fullScreen = false;    ///< The window is to fill the monitor.
    bool closesPopups = false;  ///< Menus are closed by the next frame.
    GoToBox& goTo = states.of<GoToBox>();
    TypingWait& typing = states.of<TypingWait>();
    HelpPage help = HelpPage::None;
    KeyCapture keyCapture;
    bool fileBrowser = false;
    BrowserTask browser = BrowserTask::Open;
    FileBrowsing& browsing = states.of<FileBrowsing>();
    CommandPalette& palette = states.of<CommandPalette>();
    PrepareForm& prepare = states.of<PrepareForm>();
    PieceTool& piece = states.of<PieceTool>();
    GrowthPage& growth = states.of<GrowthPage>();
    LessonPanel& lesson = states.of<LessonPanel>();
    MeshForm& mesh = states.of<MeshForm>();
    ExportForm& exported = states.of<ExportForm>();
    ComparePage& compare = states.of<ComparePage>();
    LeaveQuestion& leaving = states.of<LeaveQuestion>();
    bool quitting = false;  ///< No unsaved work: the window closes.
    LayoutPreset layoutPreset = LayoutPreset::Debug;
    Bookmarks& bookmarks = states.of<Bookmarks>();
    std::vector<Breakpoint>& breakpoints = states.of<BreakpointsPanel>().all;
    AlertsPanel& alerts = states.of<AlertsPanel>();
    VerdictPart& verdict = states.of<VerdictPart>();
    DoctorPanel& doctor = states.of<DoctorPanel>();
    WatchPanel& watch = states.of<WatchPanel>();
    ViewDrag& viewDrag = states.of<ViewDrag>();
    Navigation& navigation = states.of<Navigation>();
    LedgerPanel& ledger = states.of<LedgerPanel>();
    QueryPanel& query = states.of<QueryPanel>();
    SectionPanel& section = states.of<SectionPanel>();
    KeyWalk& walk = states.of<KeyWalk>();
    bool popupOpen = false;   ///< Overlays, such as a menu, as last drawn.
    std::string notes;        ///< Free text by the user, stored in the session file.
    std::string sessionPath;  ///< File written by Ctrl+S; empty: not known yet.
    /// Annotations in no session file yet, see Document::unsaved().
    std::string unsaved;
    std::vector<std::string> recent;  ///< Files opened lately, the latest first.
    PictureLook picture;
    /// Of the view, and of the one beside it in Compare, as last drawn.
    std::array<std::vector<DrawnLabel>, 2> labels;
    BlankScreen blank = BlankScreen::None;  ///< In the layout Present.
    bool spotlight = false;                 ///< In Present, on the neighborhood of the pivot.
    float scale = 1.0F;                     ///< Of text and panels, as drawn.
    float viewAspect = 1.3F;                ///< Of the view, as last drawn.
    bool phone = false;                     ///< The window has a phone's shape, as last drawn.
    bool offersTour = false;                ///< After the first run, until an answer.
    float coveredBelow = 0.0F;  ///< Share of the view's height that the caption covers at its lower
                                ///< edge, as last drawn.
    Follow follow = Follow::LeavingPivot;
    CameraMove cameraMove;
    /// Rectangles of the items drawn in this frame, in pixels of the window: "region view", "rail
    /// Step", "part Dial", "strip run" ... So that tests find them.
    std::map<std::string, Rect> where;
    Column& column = states.of<Column>();
    LookBack& look = states.of<LookBack>();  ///< Whether the state before the decision is shown.
    double clock = 0.0;                      ///< Seconds, summed over the frames.
    bool reducedMotion = false;              ///< The reader's system asks for little motion.
    /// Clock of the motions of picture and camera: where little motion is asked for they end with
    /// the next frame.
    double motionClock() const { return reducedMotion ? 1000.0 * clock : clock; }
    FactsCache& facts = states.of<FactsCache>();  ///< Of the selection.
    /// In the view; it may be the first half of a double click.
    DoubleClickFilter& click = states.of<DoubleClickFilter>();
};

}  // namespace se::view
