/// The visible state at one event: the state before the pivot plus the events up to the cursor.
#pragma once

#include <optional>
#include <vector>

#include "model.h"
#include "pivot_record.h"
#include "ring_replay.h"

namespace se::view {

/// State of a neighbor of the pivot at the cursor.
enum class CandidateState : std::uint8_t { Kept, Rejected };

struct CandidateMark {
    Index point = kNone;
    double degrees = 0.0;  ///< Angle at the pivot.
    CandidateState state = CandidateState::Kept;
    Verdict verdict = Verdict::Kept;  ///< Of the last test.
    Stage stage = Stage::Sort;        ///< Of the last test.
};

/// A ring that was freed after a full circuit without a triangle (§7), as it was before.
struct ShownFreedRing {
    RingPath path;
    std::optional<FreeEvidence> evidence;  ///< Empty while its points leave one by one.
    std::optional<AlertKind> alert;        ///< Problem of the ring, if any.
};

struct Picture {
    std::optional<Event> event;  ///< The event just before this state; empty at the beginning.
    /// The last event of every stage of this pivot so far, in order: a pinned layer keeps showing
    /// it.
    std::vector<Event> latest;
    Index pivot = kNone;  ///< Point; kNone at the beginning and where there is no pivot.
    Index first = kNone;
    Index last = kNone;
    Index start = kNone;
    Index end = kNone;
    Index nextPivot = kNone;     ///< Known at the advance event.
    Index underTest = kNone;     ///< Subject of the event at the cursor.
    double sectorDegrees = 0.0;  ///< Free sector from first to last.
    double startDegrees = 0.0;
    double endDegrees = 0.0;
    bool complete = false;  ///< The cursor is on the last event of the pivot.
    std::vector<CandidateMark> candidates;
    std::optional<SphereEvidence> sphere;
    std::optional<HoleEvidence> hole;
    std::vector<Triangle> newTriangles;
    std::vector<Triangle> goneTriangles;  ///< Triangles removed by a step after the last pivot.
    std::size_t finishedTriangles = 0;    ///< Number of triangles of earlier pivots.
    /// If not null: drawn instead of the finished triangles.
    std::shared_ptr<const std::vector<Triangle>> repaired;
    std::vector<RingPath> rings;  ///< The active one first, then the stack from the top.
    /// The rings before §6.5 changed them; empty before that.
    std::vector<RingPath> oldRings;
    std::vector<RingEvidence> ringChanges;  ///< So far, in order.
    /// The loops of the last split or join so far, as they were at that moment.
    std::optional<RingExchange> exchange;
    std::optional<ShownFreedRing> freed;  ///< At `done`.
    StatusList status;

    /// The evidence of the last event of a stage if it is of that kind, otherwise null.
    template <typename Kind>
    const Kind* evidence(Stage stage) const {
        for (const Event& each : latest) {
            if (each.address.stage == stage) return std::get_if<Kind>(&each.evidence);
        }
        return nullptr;
    }
};

/// Makes the picture at events[cursor] of the record; without events, the picture of the state.
Picture makePicture(const PivotRecord& record, std::size_t cursor);
/// Makes the picture of the state before events[cursor].
Picture makePictureBefore(const PivotRecord& record, std::size_t cursor);

/// The subject point of an event, kNone if it has none.
Index subjectOf(const Event& event);
/// The points that the decisions of a pivot involve: the pivot, its ends, the candidates that are
/// left, and other points named by the event at the cursor; in order, none twice. Without a pivot:
/// the point under test, if there is one.
std::vector<Index> neighborhoodOf(const Picture& picture);
/// True if the event removes its point from the neighbor ring.
bool rejects(const Event& event);

}  // namespace se::view
