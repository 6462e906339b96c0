/// What there is to see at one event: the state before the pivot plus the events up to the cursor.
#pragma once

#include <optional>
#include <vector>

#include "model.h"
#include "pivot_record.h"

namespace se::view {

/// How a neighbor of the pivot stands at the cursor.
enum class CandidateState : std::uint8_t { Kept, Rejected };

struct CandidateMark {
    Index point = kNone;
    double degrees = 0.0;  ///< Angle at the pivot.
    CandidateState state = CandidateState::Kept;
    Verdict verdict = Verdict::Kept;  ///< Of the last test.
    Stage stage = Stage::Sort;        ///< Of the last test.
};

/// One ring as a list of points, in the direction of the ring.
struct RingPath {
    std::vector<Index> points;
    std::vector<bool> open;  ///< The step from points[i] to the next is no mesh edge.
    bool active = false;
    Index depth = 0;  ///< On the stack, 0 = top.
    Index id = kNone;
};

struct Picture {
    Index pivot = kNone;  ///< Point; kNone at the beginning and where no pivot is.
    Index first = kNone;
    Index last = kNone;
    Index start = kNone;
    Index end = kNone;
    Index nextPivot = kNone;     ///< Known at the advance event.
    Index underTest = kNone;     ///< Subject of the event at the cursor.
    double sectorDegrees = 0.0;  ///< Free sector from first to last.
    double startDegrees = 0.0;
    double endDegrees = 0.0;
    bool complete = false;  ///< The cursor stands on the last event of the pivot.
    std::vector<CandidateMark> candidates;
    std::optional<SphereEvidence> sphere;
    std::optional<HoleEvidence> hole;
    std::vector<Triangle> newTriangles;
    std::size_t finishedTriangles = 0;  ///< Those of earlier pivots.
    /// If not null: drawn instead of the finished triangles.
    std::shared_ptr<const std::vector<Triangle>> mended;
    std::vector<RingPath> rings;  ///< The active one first, then the stack from the top.
    StatusList status;
};

/// Makes the picture at events[cursor] of the record; with no events, that of the state itself.
Picture makePicture(const PivotRecord& record, std::size_t cursor);

/// The rings of a state: the active one first, then the stack from the top.
std::vector<RingPath> ringPaths(const RunState& state);

/// The point an event is about, kNone if it is about none.
Index subjectOf(const Event& event);
/// The verdict of an event that has one.
std::optional<Verdict> verdictOf(const Event& event);
/// True if the event takes its point out of the neighbor ring.
bool rejects(const Event& event);

}  // namespace se::view
