/// The causes of a failure in time: three moments of a run, each an address to go to.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/why/inspected_run.h"
#include "spiraling_edge/why/ledger.h"

namespace se {

/// The moments of one failure, in the order of a search for its cause. The last decision that a
/// failure depends on is:
/// - a faulty triangle: the last test in its pivot that took one of its corners, removed a
///   candidate between two of them, or made a triangle of the first and last point alone (§6.4);
/// - a point in no triangle: the last test that refused it, or the fan that it was the pivot of; if
///   it was never tested, the moment at which its last neighbor became DONE;
/// - a hole, a ring left over: the last time that a fan, or a test between two points of the loop,
///   was refused.
/// For an edge of several triangles the third triangle counts, or the second in one direction.
struct FailureMoments {
    /// The failure exists: its last triangle is made, or its point or ring is done.
    LedgerLine created;
    LedgerLine decided;  ///< The last decision that it depends on.
    LedgerLine touched;  ///< The first event about its points.
};

/// One failure of a run.
struct RunFailure {
    MeshFailure failure;
    std::size_t position;           ///< In RunFailureSearch::all.
    std::vector<Triangle> corners;  ///< The corners of failure.triangles, in their order.
    FailureMoments moments;
};

/// Limit of the work of following failures through a run, in events examined for a failure: a fixed
/// amount, plus kMomentWorkPerEvent for each event of the run.
inline constexpr std::uint64_t kMomentWork = 4'000'000;
inline constexpr std::uint64_t kMomentWorkPerEvent = 128;

/// The failures of a run that were followed within the limits of the search.
struct RunFailureSearch {
    std::vector<RunFailure> failures;
    std::vector<MeshFailure> all;    ///< Those that were not followed as well.
    std::vector<FaultPlace> places;  ///< Of `all`.
    MeshVerdict verdict;             ///< ClassTotal::listed: those that were followed.
};

/// Counts and rings for the search for failures, collected while a run is made.
class RunCounts {
  public:
    /// `points` must outlive this object.
    explicit RunCounts(const PointSet& points) : points_(points), eventsAt_(points.size(), 0) {}

    /// Takes the next pivot of the run.
    void add(const SweptPivot& pivot);
    /// Number of events about each point.
    const std::vector<std::uint64_t>& eventsAt() const { return eventsAt_; }
    /// The work that following failures may take.
    std::uint64_t affordable() const { return kMomentWork + kMomentWorkPerEvent * events_; }
    const LeftOverRings& leftOver() const { return leftOver_; }

  private:
    const PointSet& points_;
    std::vector<std::uint64_t> eventsAt_;
    std::uint64_t events_ = 0;
    LeftOverRings leftOver_;
};

/// All failures of a run: those that inspectWithTotals() finds in its mesh, with its limits, and
/// the rings that were left over or that it was stopped at, in the order of failureClasses(). Those
/// that no step created are counted, but not followed; of a stopped run, as lost points that it
/// did not reach, they are left out. Where following all of them through the run exceeds
/// kMomentWork and kMomentWorkPerEvent, the first of each class are taken, an equal number of each
/// where there are enough, at least one. Fails if cancelled. Two runs and an inspection, or four
/// runs with triangles that are whole fans. Deterministic.
Result<RunFailureSearch> searchFailures(const PointSet& points, const Params& params,
                                        const Progress& progress = {});
/// As above for a run that was made: `counts` got all its pivots, `mesh` is its mesh. One run less.
Result<RunFailureSearch> searchFailures(const PointSet& points, const Params& params,
                                        const RunCounts& counts, std::vector<Triangle> mesh,
                                        const Progress& progress = {});
/// The failures at the end of such a run without their moments, none of which is followed: costs
/// an inspection alone. Of a stopped run, points without an event are left out.
RunFailureSearch failuresAtEnd(const PointSet& points, const RunCounts& counts,
                               std::vector<Triangle> mesh);
/// The failures that searchFailures() finds.
Result<std::vector<RunFailure>> failuresOfRun(const PointSet& points, const Params& params,
                                              const Progress& progress = {});

}  // namespace se
