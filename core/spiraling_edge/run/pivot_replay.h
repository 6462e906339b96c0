/// The state of a run at any decision of a pivot, also between two that the stepper makes in one
/// phase: the state before the pivot and the events up to the decision.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "spiraling_edge/run/pivot_record.h"
#include "spiraling_edge/run/ring_path.h"

namespace se {

/// State of a neighbor of the pivot.
enum class CandidateState : std::uint8_t { Kept, Rejected };

/// A neighbor of the pivot that was tested.
struct CandidateMark {
    Index point = kNone;
    double degrees = 0.0;  ///< Angle at the pivot.
    CandidateState state = CandidateState::Kept;
    Verdict verdict = Verdict::Kept;  ///< Of the last test.
    Stage stage = Stage::Sort;        ///< Of the last test.
};

/// A ring that was freed after a full circuit without a triangle (§7), as it was before.
struct FreedRingState {
    RingPath path;
    std::optional<FreeEvidence> evidence;  ///< Empty while its points leave one by one.
    std::optional<AlertKind> alert;        ///< Problem of the ring, if any.
};

/// A place of the neighbor ring.
struct RingPoint {
    Index point = kNone;
    double degrees = 0.0;  ///< Angle at the pivot, counterclockwise from first (§6.1).
    friend bool operator==(const RingPoint&, const RingPoint&) = default;
};

/// The state of a run just after one event.
struct DecisionState {
    std::optional<Event> event;  ///< The event just before this state; empty at the beginning.
    /// The last event of every stage of this pivot so far, in order.
    std::vector<Event> latest;
    Index pivot = kNone;  ///< Point; kNone at the beginning and where there is no pivot.
    Index first = kNone;
    Index last = kNone;
    Index start = kNone;
    Index end = kNone;
    Index nextPivot = kNone;     ///< Known from the advance event on.
    Index underTest = kNone;     ///< Subject of `event`.
    double sectorDegrees = 0.0;  ///< Free sector from first to last.
    double startDegrees = 0.0;
    double endDegrees = 0.0;
    /// The places that start and end have moved to, in order (Fig. 4).
    std::vector<RingPoint> startPath, endPath;
    bool complete = false;  ///< `event` is the last of the pivot.
    /// The tested neighbors, kept or rejected, in the order of their first test.
    std::vector<CandidateMark> candidates;
    std::optional<SphereEvidence> sphere;
    std::optional<HoleEvidence> hole;
    std::vector<Triangle> newTriangles;   ///< Those that the pivot has made so far (§6.4).
    std::vector<Triangle> goneTriangles;  ///< Triangles removed by a step after the last pivot.
    std::size_t finishedTriangles = 0;    ///< Number of triangles of earlier pivots.
    /// Beyond the paper: the mesh as edited after the last pivot; null before.
    std::shared_ptr<const std::vector<Triangle>> repaired;
    std::vector<RingPath> rings;  ///< The active one first, then the stack from the top.
    /// The rings before §6.5 changed them; empty before that.
    std::vector<RingPath> oldRings;
    std::vector<RingEvidence> ringChanges;  ///< So far, in order.
    /// The loops of the last split or join so far, as they were at that moment.
    std::optional<RingExchange> exchange;
    std::optional<FreedRingState> freed;  ///< At `done`.
    StatusList status;

    /// The neighbor ring (§6.1): start, the candidates that are left by increasing angle, end.
    /// Empty where there is no pivot.
    std::vector<RingPoint> neighborRing() const;
    /// The points of the fan as it would be laid now (§6.4): the neighbor ring, and those that
    /// start and end have passed. Each two that follow each other make a triangle with the pivot,
    /// unless the fan is refused.
    std::vector<RingPoint> fan() const;
    /// The evidence of the last event of a stage if it is of that kind, otherwise null.
    template <typename Kind>
    const Kind* evidence(Stage stage) const& {
        for (const Event& each : latest) {
            if (each.address.stage == stage) return std::get_if<Kind>(&each.evidence);
        }
        return nullptr;
    }
    template <typename Kind>
    const Kind* evidence(Stage stage) && = delete;  // it would point into a temporary
};

/// Computes the states of one pivot. O(events and changed points of the pivot, length of the rings)
/// for each.
class PivotReplay {
  public:
    /// See Timeline::record().
    explicit PivotReplay(std::shared_ptr<const PivotRecord> record) : record_(std::move(record)) {}

    const PivotRecord& record() const { return *record_; }
    /// The state just after events[i], or after the last one if there are fewer. Without events:
    /// the state of the run there.
    DecisionState after(std::size_t i) const;
    /// The state just before events[i].
    DecisionState before(std::size_t i) const;

  private:
    std::shared_ptr<const PivotRecord> record_;
};

}  // namespace se
