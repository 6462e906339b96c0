/// State of the panels of the column and of the strips. Plain values, no ImGui.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "layout/panel_rects.h"
#include "rows/lane_picture.h"
#include "rows/normal_section.h"
#include "rows/step_tree.h"
#include "run/selection.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/why/ring_history.h"

namespace se::view {

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
    StripChoice strips = StripChoice::Auto;
    bool stripFolded = false;  ///< As last laid out.
    StripWindow strip;
    StepTree steps;
    std::array<char, 64> stepFilter{};
    Index pointedAt = kNone;    ///< The point under the pointer, determined again in every frame.
    Index pointedRing = kNone;  ///< The ring under the pointer, determined again in every frame.
    bool opensLayers = false;   ///< The menu of the layers is to be opened in this frame.
    bool opensNotes = false;    ///< The menu of the bookmarks and notes, too.
    bool phoneLegend = false;   ///< On a phone, where it covers much of the view.

    /// Folds the strip below the view to its first row if it is open, otherwise opens all of it.
    void toggleStrips() { strips = stripFolded ? StripChoice::Open : StripChoice::Folded; }
};

struct AlertsPanel {
    bool reveal = false;  ///< The list scrolls to the chosen alert.
};

/// A request to close holes, answered when the new mesh has been checked.
struct HoleClosing {
    double width = 0.0;      ///< The largest hole to close, scene units.
    std::size_t before = 0;  ///< Open loops before.
};

/// The part that sums up the finished mesh.
struct VerdictPart {
    bool fixing = false;  ///< The best settings are applied when all are tried.
    /// The pointer is on Fix, or on its numbers: the view shows what it changes. Determined again
    /// in every frame.
    bool pointedAt = false;
    std::optional<HoleClosing> closing;
};

struct DoctorPanel {
    std::string shownCheck;  ///< The finding whose points are highlighted.
    std::string askedCheck;  ///< Check whose fix drops most points, after the first click on it.
};

struct BreakpointsPanel {
    std::vector<Breakpoint> all;
};

struct WatchPanel {
    std::vector<std::string> expressions;  ///< See core's watch.h.
};

/// A list of decisions that follows the cursor.
struct LineList {
    CursorWatch watch;
    const void* answer = nullptr;       ///< Lines that were drawn last; only compared.
    int settling = 0;                   ///< Frames without scrolling to the cursor.
    std::vector<std::size_t> unfolded;  ///< The first lines of repeats that the user has unfolded.
};

struct LedgerPanel {
    std::string typed;      ///< Text in the box.
    std::string complaint;  ///< Error of the typed text.
    Selection seen;         ///< Selection when the panel was drawn last.
    std::optional<Address>
        asked;  ///< The decision at the cursor when the selection was asked about.
    LineList list;
};

/// The lists of the panel Query.
enum class QueryList : std::uint8_t { Found, Closest };

struct QueryPanel {
    std::string typed;
    bool typing = false;  ///< The line requests the keyboard focus.
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
