/// The whole run at a glance, for the tree of steps and the strip under the view.
#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "model.h"
#include "spiraling_edge/run/live_check.h"
#include "spiraling_edge/run/ring_lanes.h"
#include "spiraling_edge/run/sweep.h"

namespace se::view {

/// A complete component: its triangles, its position and its boundary. Computed once, by the thread
/// that makes the run, because a pass over all its triangles takes longer than a frame.
struct ComponentShape {
    std::uint32_t pivot = 0;  ///< Pivot at whose end the component was complete.
    std::size_t begin = 0;    ///< Number of its first triangle.
    std::size_t end = 0;      ///< Number after its last triangle.
    glm::vec3 middle{0.0F};   ///< View space.
    /// Directed edges that have a triangle on one side only.
    std::vector<std::array<Index, 2>> rim;
    std::size_t points = 0;  ///< Number of points that its triangles use.
    std::size_t loops = 0;   ///< Number of connected pieces of the rim.
    double seconds = 0.0;    ///< Since the run began to be made, moves included.
};

/// The component that consists of `triangles`; `begin` is the number of the first.
ComponentShape shapeOf(const Model& model, std::span<const Triangle> triangles, std::size_t begin);

/// The component that was complete at the end of `pivot`; null if unknown. `shapes` are in order.
const ComponentShape* shapeAt(std::span<const ComponentShape> shapes, std::uint32_t pivot);

/// An event of the run that deserves a mark.
enum class MarkKind : std::uint8_t { Seed, Split, Join, Alert };

/// The stage whose events report a kind of mark.
Stage stageOf(MarkKind kind);

struct RunMark {
    std::uint32_t pivot;
    MarkKind kind;
    std::uint32_t n = 1;                          ///< Which event of its stage.
    AlertEvidence alert{AlertKind::Hole, kNone};  ///< Of an alert.
};

/// The stages and verdicts that occur among some events, one bit for each.
using Findings = std::bitset<kStageCount + kVerdictCount>;
inline Findings findingOf(Stage stage) { return Findings().set(static_cast<std::size_t>(stage)); }
inline Findings findingOf(Verdict verdict) {
    return Findings().set(kStageCount + static_cast<std::size_t>(verdict));
}

/// Summary of a pivot, available without running it again. At most 24 bytes.
struct PivotSummary {
    Findings found;
    Index point = kNone;
    std::uint16_t tests = 0;  ///< Decisions with a verdict; no more than 65,535 are counted.
    std::uint16_t refused = 0;
};
static_assert(sizeof(PivotSummary) <= 24);

/// Adds an event of the pivot.
void count(PivotSummary& summary, const Event& event);

/// The pivots from a seed to the next one.
struct ComponentSummary {
    std::uint32_t firstPivot = 1;
    std::size_t tests = 0;
    std::size_t refused = 0;
};

/// Maximum number of failures that are kept.
inline constexpr std::size_t kMaxNoticed = 100000;
/// Runs on more points than this are not watched for failures while they proceed: the tables of all
/// edges and cells would need as much memory as the run.
inline constexpr std::size_t kMaxWatched = 300000;

/// Lists of the whole run; those with one element per pivot begin with the first pivot.
struct RunOverview {
    std::vector<std::uint32_t> ringLength;  ///< Of the active ring, per completed pivot.
    std::vector<std::uint32_t> stackDepth;
    std::vector<std::uint32_t> triangles;  ///< So far.
    /// One more than completed pivots if there are events after the last of them.
    std::vector<PivotSummary> pivots;
    std::vector<ComponentSummary> components;  ///< In order; filled by append().
    std::vector<RunMark> marks;
    std::vector<ComponentShape> shapes;  ///< Of the complete components.
    std::vector<LaneChange> laneChanges;
    /// Failures at the decisions that caused them, in the order of the run; of a very
    /// tangled run the first kMaxNoticed.
    std::vector<LiveFailure> failures;
    std::uint32_t lanes = 0;  ///< Maximum at one time.
    std::uint32_t longestRing = 0;
    std::uint32_t deepestStack = 0;
    std::uint32_t lastPivot = 0;  ///< Of the whole run if complete, else the farthest so far.
    bool complete = false;
};

/// Failures at an address, in order.
std::span<const LiveFailure> failuresAt(const RunOverview& run, const Address& address);

/// Reserves the lists per pivot for a run on that many points: growing step by step they would take
/// up to twice the memory.
void reservePivots(RunOverview& overview, std::size_t points);

/// Appends the lists of `fresh` to those of `overview` and copies its figures.
void append(RunOverview& overview, const RunOverview& fresh);

/// Collects the overview of a run while it is made. Counts decisions, stores none.
class RunObserver {
  public:
    /// `start`: the state before the first pivot. `model` must outlive this object.
    RunObserver(const Model& model, const State& start);
    /// Adds the next pivot of the run to `run`.
    void add(const SweptPivot& pivot, RunOverview& run);

  private:
    void noteFigures(const State& state, RunOverview& run);
    void noteEvents(const SweptPivot& pivot, RunOverview& run);
    void noteMarks(const SweptPivot& pivot, RunOverview& run) const;
    void noteShape(const SweptPivot& pivot, RunOverview& run);
    void noteFailures(std::span<const Event> events, RunOverview& run);

    const Model& model_;
    Counters before_;            ///< Before the pivot.
    std::size_t alerts_ = 0;     ///< Before the pivot.
    std::size_t triangles_ = 0;  ///< Before the pivot.
    std::size_t begin_ = 0;      ///< The first triangle of the current component.
    LaneTracker lanes_;
    std::optional<LiveCheck> live_;  ///< Empty for very large inputs.
    std::size_t noticed_ = 0;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace se::view
