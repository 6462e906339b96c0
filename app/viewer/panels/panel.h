/// Panels show the session and request commands and moves. One file each.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "commands/commands.h"
#include "layout/panel_rects.h"
#include "panel_state/side_panels.h"
#include "scene/palette.h"
#include "ui.h"

namespace se {
struct Event;
struct StatusCounts;
}  // namespace se

namespace se::view {

struct DrawList;
struct UiRequests;
struct ViewSettings;

/// The second view of the layout Compare.
struct OtherView {
    CommandContext* commands;  ///< Of the other run; null: a finished mesh.
    const DrawList& list;
    const StatusCounts& counts;
    unsigned texture;
};

struct PanelContext {
    CommandContext& commands;
    const Palette& palette;
    const Fonts& fonts;
    const PanelRects& rects;
    const DrawList& drawList;  ///< For labels over the view.
    const StatusCounts& counts;
    float em;
    unsigned viewTexture;
    const OtherView* other = nullptr;   ///< Null: there is none.
    bool beside = false;                ///< This is the other view of the layout Compare.
    const Session* otherRun = nullptr;  ///< The run in the other view than this; null: none.

    Session& session() const { return commands.session; }
    Playback& playback() const { return commands.playback; }
    Camera& camera() const { return commands.camera; }
    UiState& ui() const { return commands.ui; }
    /// The part of ui() that a panel remembers, by its type: state<PrepareForm>(). Only the types
    /// named in panel.cpp.
    template <class State>
    State& state() const;
    UiRequests& requests() const;
    ViewSettings& settings() const;
    /// Rectangles of the items drawn in this frame, for test scripts and the camera.
    std::map<std::string, Rect>& where() const;
    /// First key of a command, with the user's changes.
    std::string key(const Command& command) const;
    std::string key(std::string_view command) const { return key(*findCommand(command)); }
    void run(std::string_view command) const { runCommand(*findCommand(command), commands); }
};

void drawMenuBar(const PanelContext& context);
/// Replaces all panels while no input is open.
void drawStartPage(const PanelContext& context);
/// Replaces all panels while new points spread; the open input waits.
void drawGrowthPage(const PanelContext& context);
void drawTransport(const PanelContext& context);
/// The scene with its overlays, in a window of that name.
void drawView(const PanelContext& context, const char* window = "##view");
/// The column, the titles, the second view and its sentence of the layout Compare.
void drawCompareColumn(const PanelContext& context);
void drawComparedViews(const PanelContext& context);
/// The decision of the context's session, in a window of that name.
void drawNarration(const PanelContext& context, const char* window = "##narration");
void drawDrawer(const PanelContext& context);
void drawStatusBar(const PanelContext& context);
void drawCheatSheet(const PanelContext& context);
/// The guide, or what this program is.
void drawHelp(const PanelContext& context);
void drawCommandPalette(const PanelContext& context);
void drawKeyEditor(const PanelContext& context);
void drawFileBrowser(const PanelContext& context);
/// Context menu of a point, an edge or a triangle, in the view and in lists. Opened by
/// `state<SubjectMenu>().open(what)` on a right click.
void drawSubjectMenu(const PanelContext& context);
/// The question whether to save annotations before the session is left.
void drawLeaveQuestion(const PanelContext& context);
/// The card that sums up the finished mesh, with what to do next.
void drawVerdict(const PanelContext& context);
/// The strip of the tool for a piece of a scan, while it is on.
void drawPieceStrip(const PanelContext& context);
/// Notices: loading, failed, or a long move in progress.
void drawNotices(const PanelContext& context);

// Contents of the side columns.
void drawSteps(const PanelContext& context);
void drawRings(const PanelContext& context);
/// The step of the open lesson, or the list of lessons.
void drawLesson(const PanelContext& context);
void drawInspect(const PanelContext& context);
void drawCounters(const PanelContext& context);
void drawDial(const PanelContext& context);
/// The profile along the normal at the pivot.
void drawSection(const PanelContext& context);
void drawPaper(const PanelContext& context);
/// Bookmarks, and the user's own text.
void drawNotes(const PanelContext& context);
/// Breakpoints, and the log of those that do not stop.
void drawBreakpoints(const PanelContext& context);
/// Watched numbers of the run, and their plots.
void drawWatch(const PanelContext& context);
/// Points that take no part in the run, by reason; nothing if there are none. Requires an open run.
void drawAside(const PanelContext& context);
/// The best settings that were tried, and a button of this name that takes them.
void drawBestTrial(const PanelContext& context, const std::string& name);
/// Findings of the doctor.
void drawDoctor(const PanelContext& context);
/// Failures of the run.
void drawAlerts(const PanelContext& context);
/// What-ifs that are possible at the cursor, and those that are active.
void drawWhatIf(const PanelContext& context);
/// Banner above the view while what-ifs are active.
void drawWhatIfBanner(const PanelContext& context);
/// The form for what is derived from the points of the input.
void drawPrepare(const PanelContext& context);
/// All rules as switches.
void drawRules(const PanelContext& context);
void drawLayerSwitches(const PanelContext& context);
/// Reasons why something is in the mesh, or why it is not.
void drawLedger(const PanelContext& context);
/// Decisions found by a query line, and the closest decisions.
void drawQuery(const PanelContext& context);
/// The whole run as charts.
void drawCharts(const PanelContext& context);

// Parts used by several panels.
/// Updates the tree of steps from the session: at the beginning of a frame, and after a click that
/// may have moved the cursor to another pivot.
void keepSteps(const PanelContext& context);
/// An input line of query terms (core's decision_query.h), as wide as the next item width. True if
/// the line changed. The field takes any text, and is red where a word is not understood.
bool queryField(const PanelContext& context, const char* id, const char* hint, std::string& line);
/// Error of a line, without the list of all terms; empty if there is none.
std::string queryComplaint(const PanelContext& context, const std::string& line);
/// A dim "?" with a tooltip that explains all terms.
void queryHelp(const PanelContext& context);
/// The evidence of an event as rows of values and thresholds.
void drawEvidence(const PanelContext& context, const Event& event);

/// One panel with a tab.
struct SidePanel {
    const char* title;
    PanelGroup group;
    void (*draw)(const PanelContext& context);
    /// The line that sums it up until the user opens it, in Find and Change. Null: none.
    std::string (*line)(const PanelContext& context) = nullptr;
};
std::span<const SidePanel> sidePanels();
std::string alertsLine(const PanelContext& context);
std::string doctorLine(const PanelContext& context);

/// Where a panel stands.
enum class PanelPlace : std::uint8_t { Tab, Apart, Nowhere };
PanelPlace placeOf(const PanelRects& rects, const SidePanel& panel);
/// Opens the requested tab, at the beginning of a frame.
void openWantedTab(const PanelContext& context);
/// Whether both Find and Change show a line alone.
bool groupsAreQuiet(const PanelContext& context);
/// A column with the tabs of these groups: if there are several, with a row that chooses one.
void drawGroups(const PanelContext& context, std::span<const PanelGroup> groups);
/// The areas of Find and Change.
void drawLowerGroups(const PanelContext& context);
/// The handles between areas, which the user drags; a double click resets the size.
void drawSplitters(const PanelContext& context);

/// Draws all panels.
void drawPanels(const PanelContext& context);

}  // namespace se::view
