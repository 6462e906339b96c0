/// The panels of the side columns and of the drawer: the titles of their tabs, and what each
/// remembers. Plain values, no ImGui.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "layout/panel_rects.h"
#include "rows/lane_picture.h"
#include "rows/normal_section.h"
#include "rows/step_tree.h"
#include "rows/watch_plot.h"
#include "run/selection.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::view {

// Titles of panels that commands open.
inline constexpr const char* kLessonTab = "Lesson";
inline constexpr const char* kDoctorTab = "Doctor";  ///< Opens by itself if it has found a problem.
inline constexpr const char* kBreakpointsTab = "Breakpoints";
inline constexpr const char* kWatchTab = "Watch";
inline constexpr const char* kAlertsTab = "Alerts";
inline constexpr const char* kRulesTab = "Rules";
inline constexpr const char* kSectionTab = "Section";
inline constexpr const char* kWhatIfTab = "What if";
inline constexpr const char* kPrepareTab = "Prepare";
inline constexpr const char* kLedgerTab = "Ledger";
inline constexpr const char* kQueryTab = "Query";
inline constexpr const char* kChartsTab = "Charts";

/// Panels that share a row of tabs, by what the user wants to do.
enum class PanelGroup : std::uint8_t { Steps, Understand, Find, Change };
inline constexpr std::size_t kPanelGroupCount = 4;

/// The open tabs.
struct OpenTab {
    /// By group; empty: the first one.
    using ByGroup = std::array<std::string, kPanelGroupCount>;

    std::string title;   ///< The one opened last.
    std::string wanted;  ///< To be opened in the next frame; empty: unchanged.
    /// By a finding, not by the user: below the view one line says so, and the view keeps its size.
    bool byFinding = false;
    ByGroup open;
    ByGroup learn;                              ///< In the layout Learn.
    PanelGroup group = PanelGroup::Understand;  ///< Shown where several groups share a column.
    /// Whether the tab was opened: until then it is one line.
    std::array<bool, kPanelGroupCount> asked{};
};

/// The inputs of a painting of the lanes.
struct LaneInputs {
    std::uint32_t generation = 0;
    std::size_t pivots = 0;
    std::size_t changes = 0;
    bool complete = false;
    StripWindow window;
    LaneRoom room;
    friend bool operator==(const LaneInputs&, const LaneInputs&) = default;
};

/// The lanes as last painted.
struct PaintedLanes {
    LaneInputs inputs;
    LanePicture picture;
};

/// Something that follows the cursor, but only when it moves, so that the user can scroll away.
class CursorWatch {
  public:
    /// True for two frames after a move: sizes are known one frame late.
    bool moved(std::uint32_t generation, std::uint32_t pivot, std::size_t cursor) {
        if (generation_ != generation || pivot_ != pivot || cursor_ != cursor) again_ = 2;
        generation_ = generation;
        pivot_ = pivot;
        cursor_ = cursor;
        return again_ > 0 && again_-- > 0;
    }

  private:
    std::uint32_t generation_ = 0;
    std::uint32_t pivot_ = 0;
    std::size_t cursor_ = 0;
    int again_ = 0;
};

struct Navigation {
    DrawerChoice drawer = DrawerChoice::Auto;
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
    void toggleDrawer() { drawer = drawerFolded ? DrawerChoice::Open : DrawerChoice::Folded; }
};

struct AlertsPanel {
    std::map<std::string, bool> open;  ///< Classes that were folded or unfolded by the user.
    bool reveal = false;               ///< The list scrolls to the chosen alert.
};

/// The card over the view that sums up the finished mesh.
/// A request to close holes, answered when the new mesh has been checked.
struct HoleClosing {
    double width = 0.0;      ///< The largest hole to close, scene units.
    std::size_t before = 0;  ///< Open loops before.
};

struct VerdictCard {
    bool closed = false;  ///< By the user, until another input is opened.
    bool fixing = false;  ///< The best settings are applied when all are tried.
    /// The pointer is on Fix, or on its numbers: the view shows what it changes. Determined again
    /// in every frame.
    bool pointedAt = false;
    bool faded = false;  ///< The pointer is on Fix of the card, as last drawn: it hides less.
    std::optional<HoleClosing> closing;
};

struct DoctorPanel {
    std::string shownCheck;  ///< The finding whose points are highlighted.
    std::string askedCheck;  ///< Check whose fix drops most points, after the first click on it.
};

struct WatchPanel {
    std::vector<std::string> expressions;  ///< See core's watch.h.
    std::map<std::string, PaintedPlot> plots;
};

/// A list of decisions that follows the cursor.
struct LineList {
    CursorWatch watch;
    const void* answer = nullptr;  ///< Line that was drawn last.
    int settling = 0;              ///< Frames without scrolling to the cursor.
};

struct LedgerPanel {
    std::string typed;      ///< Text in the box.
    std::string complaint;  ///< Error of the typed text.
    Selection seen;         ///< Selection when the panel was drawn last.
    bool wantsKeyboard = false;
    LineList list;
};

/// The lists of the panel Query.
enum class QueryList : std::uint8_t { Found, Closest };

struct QueryPanel {
    std::string typed;
    bool typing = false;  ///< The line requests the keyboard focus.
    bool wantsKeyboard = false;
    QueryList shown = QueryList::Found;
    LineList found;
    LineList closest;
};

/// The inputs of a section.
struct SectionInputs {
    std::uint32_t generation = 0;
    std::uint32_t revision = 0;
    double turnDegrees = 0.0;
    friend bool operator==(const SectionInputs&, const SectionInputs&) = default;
};

struct SectionPanel {
    double turnDegrees = 0.0;  ///< Of the plane about the normal, in (-180, 180].
    SectionInputs inputs;      ///< Of the section as last made.
    NormalSection made;
    int shownIn = -1;  ///< The last frame in which the panel was drawn.

    void turn(double degrees) {
        const double sum = std::remainder(turnDegrees + degrees, 360.0);
        turnDegrees = sum <= -180.0 ? 180.0 : sum;
    }
};

/// Context menu of a thing in the view or in a list.
struct SubjectMenu {
    Selection what;
    std::optional<RingAddress> ring;  ///< Instead of a selection.
    bool wanted = false;              ///< To be opened in this frame.
    bool other = false;               ///< In the view of the other run (layout Compare).

    void open(const Selection& subject) {
        *this = {subject, std::nullopt, subject.kind != SelectionKind::None};
    }
    /// In the view of the other run, or of a finished mesh, which cannot be queried.
    void openBeside(const Selection& subject) { *this = {subject, std::nullopt, true, true}; }
    void open(const RingAddress& place) { *this = {Selection{}, place, true}; }
};

}  // namespace se::view
