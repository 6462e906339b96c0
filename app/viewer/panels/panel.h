/// Panels show the session, and call commands and moves. One file each.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "commands/commands.h"
#include "layout/panel_rects.h"
#include "panel_state/panel_states.h"
#include "scene/palette.h"
#include "ui.h"

namespace se {
struct StatusCounts;
}  // namespace se

namespace se::view {

class Moves;
struct DrawList;
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
    /// The moves of the session, for a jump: playback pauses.
    Moves& pausedMoves() const;
    Camera& camera() const { return commands.camera; }
    UiState& ui() const { return commands.ui; }
    /// What a panel remembers between frames, of its own type: state<PrepareForm>().
    template <class State>
    State& state() const {
        return states().of<State>();
    }
    PanelStates& states() const;
    Document& document() const { return commands.document; }
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
/// Legend of the shapes of spreading points, if some are on walls.
void drawGrowthLegend(const PanelContext& context);
/// The strip below the view: transport, cells of the pivot, lanes of the run.
void drawStrip(const PanelContext& context);
/// The scene with its overlays, in a window of that name.
void drawView(const PanelContext& context, const char* window = "##view");
/// The titles and the second view of the layout Compare.
void drawComparedViews(const PanelContext& context);
/// The decision of the context's session: below the view, or on a plate in it, whose place is
/// empty if there is nothing to say.
void drawNarration(const PanelContext& context);
std::optional<Rect> drawCaption(const PanelContext& context);
/// The guide, or what this program is.
void drawHelp(const PanelContext& context);
void drawCommandPalette(const PanelContext& context);
void drawKeySheet(const PanelContext& context);
void drawFileBrowser(const PanelContext& context);
/// Context menu of a point, an edge or a triangle, in the view and in lists. Opened by
/// `state<SubjectMenu>().open(what)` on a right click.
void drawSubjectMenu(const PanelContext& context);
/// The question whether to save annotations before the session is left.
void drawLeaveQuestion(const PanelContext& context);
/// The sum of the finished mesh, with what to do next.
void drawVerdict(const PanelContext& context);
/// The strip of the tool for a piece of a scan, while it is on.
void drawPieceStrip(const PanelContext& context);
/// Notices: loading, failed, or a long move in progress.
void drawNotices(const PanelContext& context);

// Parts of the column, and of menus.
/// The choice of another run, and where the two differ.
void drawCompare(const PanelContext& context);
void drawSteps(const PanelContext& context);
void drawRings(const PanelContext& context);
/// The step of the open lesson, or the list of lessons.
void drawLesson(const PanelContext& context);
void drawInspect(const PanelContext& context);
void drawDial(const PanelContext& context);
/// The profile along the normal at the pivot.
void drawSection(const PanelContext& context);
void drawPaper(const PanelContext& context);
/// Breakpoints, and the log of those that do not stop.
void drawBreakpoints(const PanelContext& context);
/// Watched numbers of the run, and their plots.
void drawWatch(const PanelContext& context);
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

/// The rail of tasks, and the parts of the open one.
void drawColumn(const PanelContext& context);
void drawRail(const PanelContext& context);
/// The handle between view and column, which the user drags; a double click resets the width.
void drawSplitter(const PanelContext& context);

/// Draws all panels.
void drawPanels(const PanelContext& context);

}  // namespace se::view
