/// The rows of the panel Steps: component > pivot > stage > test. A model of the open rows and
/// their meaning, not a list of rows: a run may have millions.
#pragma once

#include <algorithm>
#include <bitset>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "run/overview.h"
#include "spiraling_edge/run/pivot_record.h"

namespace se::view {

/// The filter line above the tree: words that must all match. Each is the beginning of a stage's
/// name, a word of a verdict, the number of a point or pivot, or `x` for refused tests. Case is
/// ignored.
class StepFilter {
  public:
    StepFilter() = default;
    explicit StepFilter(std::string_view text);

    bool empty() const { return words_.empty(); }
    /// Whether the pivot may have such a decision.
    bool matches(std::uint32_t pivot, const PivotSummary& summary) const;
    /// Matches also words of the sentence that describes the event.
    bool matches(const Event& event) const;

  private:
    struct Word {
        std::string text;
        Findings found;
        bool refused = false;
        Index number = kNone;
    };
    static Word read(std::string text);

    std::vector<Word> words_;
};

/// A run of events of the same stage within a pivot.
struct StageRun {
    Stage stage = Stage::Pivot;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t tests = 0;  ///< Events with a verdict.
    std::size_t refused = 0;

    std::size_t size() const { return end - begin; }
    bool contains(std::size_t event) const { return event >= begin && event < end; }
};

enum class StepRowKind : std::uint8_t { Component, Pivot, Stage, Test };

struct StepRow {
    StepRowKind kind = StepRowKind::Component;
    std::size_t component = 0;  ///< Position in RunOverview::components.
    std::uint32_t pivot = 0;
    std::size_t run = 0;    ///< Stage, test: position in runs().
    std::size_t event = 0;  ///< Test, and a stage of a single event: position in the record.
    friend bool operator==(const StepRow&, const StepRow&) = default;
};

/// The rows follow from what is open. Only the pivot at the cursor has its decisions
/// in memory, so only it can be open.
class StepTree {
  public:
    /// Sets run and cursor. All arguments must outlive the next call.
    void update(const RunOverview& run, std::uint32_t generation, const PivotRecord& record,
                std::size_t cursor);
    /// Shows only rows that match the filter, as a flat list of pivots and tests.
    void setFilter(const std::string& text);
    bool filtered() const { return !filter_.empty(); }

    std::size_t rowCount() const;
    /// Requires row < rowCount(). O(log rows).
    StepRow row(std::size_t row) const;
    /// The row that the cursor is on, or the nearest one around it that is shown.
    std::optional<std::size_t> rowOfCursor() const;

    bool canOpen(const StepRow& row) const;
    bool isOpen(const StepRow& row) const;
    /// Opens or folds a row. Not for a pivot without the cursor: move there instead.
    void toggle(const StepRow& row);
    /// Shows the decisions of the pivot at the cursor.
    void openPivot() { pivotFolded_ = false, layOut(); }

    const std::vector<StageRun>& runs() const { return runs_; }
    std::uint32_t pivotsOf(std::size_t component) const;
    /// The component that a pivot belongs to.
    std::size_t componentOf(std::uint32_t pivot) const;

  private:
    struct OpenComponent {
        std::size_t component = 0;
        std::size_t row = 0;   ///< Of the component itself.
        std::size_t rows = 0;  ///< Below it.
    };

    void layOut();
    void matchPivots();
    void matchEvents();
    bool stageOpen(std::size_t run) const;
    bool componentOpen(std::size_t component) const;
    bool cursorPivotListed() const;
    std::size_t rowsOfPivot() const;
    StepRow rowOfPivot(std::size_t component, std::size_t place) const;
    StepRow rowInPivot(std::size_t place) const;
    std::size_t placeInPivot() const;
    StepRow filteredRow(std::size_t row) const;
    std::optional<std::size_t> filteredCursor() const;

    const RunOverview* run_ = nullptr;
    const PivotRecord* record_ = nullptr;
    std::uint32_t generation_ = 0;
    std::size_t pivotCount_ = 0;
    std::uint32_t recordPivot_ = 0;
    std::size_t cursor_ = 0;
    std::size_t cursorComponent_ = 0;
    std::size_t cursorRun_ = 0;

    std::vector<StageRun> runs_;
    std::vector<std::size_t> runRow_;  ///< Row of each run below the pivot's, and their number.
    std::vector<OpenComponent> open_;  ///< In order.
    std::set<std::size_t> opened_;     ///< Components opened by hand.
    std::bitset<kStageCount> openedStages_;
    bool componentFolded_ = false;  ///< State of the cursor's pivot, set by the user.
    bool pivotFolded_ = false;
    bool stageFolded_ = false;

    std::string filterText_;
    StepFilter filter_;
    std::vector<std::uint32_t> matches_;  ///< Matching pivots, except that of the cursor.
    std::size_t matchedPivots_ = 0;       ///< Number of pivots that were tested.
    std::vector<std::size_t> eventMatches_;
};

// Positions of the counts in the panel Steps: in columns as wide as the largest of them. Plain
// values, no ImGui.

/// The widths of the largest numbers, in pixels.
struct StepNumberWidths {
    float triangles = 0.0F;
    float tests = 0.0F;
    float refused = 0.0F;  ///< Including the cross before it.
};

/// The columns at the right end of a row; x of their right edges, 0 for one that is left out.
struct StepColumns {
    float triangles = 0.0F;
    float tests = 0.0F;
    float refused = 0.0F;
    float labels = 0.0F;  ///< Maximum right end of the labels.
};

/// The columns of a row from `left`, `room` wide. Triangles are left out if the labels would
/// have too little room.
inline StepColumns placeStepColumns(float left, float room, float em,
                                    const StepNumberWidths& widest) {
    // As wide as the titles, in em.
    constexpr float kTriangles = 3.7F;
    constexpr float kTests = 2.6F;
    constexpr float kRefused = 3.2F;
    constexpr float kGap = 0.6F;
    constexpr float kLabels = 7.6F;
    const auto column = [em](float least, float number) {
        return std::max(least * em, number + kGap * em);
    };
    StepColumns c;
    c.refused = left + room - 0.2F * em;
    c.tests = c.refused - column(kRefused, widest.refused);
    c.labels = c.tests - column(0.0F, widest.tests);
    const float triangles = c.tests - column(kTests, widest.tests);
    const float labels = triangles - column(kTriangles, widest.triangles);
    if (labels - left < kLabels * em) return c;
    c.triangles = triangles;
    c.labels = triangles - column(0.0F, widest.triangles);
    return c;
}

}  // namespace se::view
