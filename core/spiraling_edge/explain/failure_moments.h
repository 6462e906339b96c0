/// When a failure of a run came about: three moments, each an address to go to.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/explain/ledger.h"
#include "spiraling_edge/mesh/inspection.h"

namespace se {

/// The moments of one failure, in the order in which one looks for the cause.
struct FailureMoments {
    LedgerLine created;      ///< It is there: its last triangle, or its point or ring is done with.
    LedgerLine unavoidable;  ///< The decision after which it had to come.
    LedgerLine touched;      ///< The run came to its points for the first time.
};

/// Finds them by running again. `mesh` is that of the run, which `failure` was found in. Fails if
/// the failure is none of this run's mesh, or if cancelled. Which decision made a failure
/// unavoidable:
/// - a faulty triangle: the last test in its pivot that took one of its corners, took away what lay
///   between two of them, or made a triangle of the first and last point alone (§6.4);
/// - a point in no triangle: the last test that refused it, or the fan that it was the pivot of; of
///   one that was never tested the moment at which its last neighbor became DONE;
/// - a hole, a ring left over: the last time that a fan, or a test between two points of the loop,
///   was refused.
/// Of an edge of several triangles the third counts, or the second in one direction.
Result<FailureMoments> momentsOf(const PointSet& points, const Params& params,
                                 const MeshFailure& failure, const std::vector<Triangle>& mesh,
                                 const Progress& progress = {});

/// Of all failures of a run at once, in one go through it: nothing for one that is none of this
/// run's. Fails if cancelled. O(run + events about their points).
Result<std::vector<std::optional<FailureMoments>>> momentsOfAll(
    const PointSet& points, const Params& params, std::span<const MeshFailure> failures,
    const std::vector<Triangle>& mesh, const Progress& progress = {});

/// One failure of a run.
struct RunFailure {
    MeshFailure failure;
    std::vector<Triangle> corners;  ///< Of failure.triangles, one by one.
    FailureMoments moments;
};

/// The work of following failures through a run, in events looked at for a failure: a fixed amount,
/// and so much more for each event of the run.
inline constexpr std::uint64_t kMomentWork = 4'000'000;
inline constexpr std::uint64_t kMomentWorkPerEvent = 128;

/// The failures of a run that were followed within the limits of the search.
struct RunFailureSearch {
    std::vector<RunFailure> failures;
    std::vector<ClassTotal> totals;  ///< Of each of failureClasses(), in its order.
};

/// All that went wrong in a run: what inspectWithTotals() finds in its mesh, with its limits, and
/// the rings that it left over or was stopped at, in the order of failureClasses(). Where following
/// all of them through the run exceeds kMomentWork and kMomentWorkPerEvent, the first of each class
/// are taken, as many of each as of the others if there are; one of each in any case. Fails if
/// cancelled. Two runs and an inspection, or three with triangles that are whole fans.
/// Deterministic.
Result<RunFailureSearch> searchFailures(const PointSet& points, const Params& params,
                                        const Progress& progress = {});
/// RunFailureSearch::failures of searchFailures().
Result<std::vector<RunFailure>> failuresOfRun(const PointSet& points, const Params& params,
                                              const Progress& progress = {});
/// The first of them in the run: the place of the one that was created first; size() of none.
std::size_t firstCreated(std::span<const RunFailure> failures);

}  // namespace se
