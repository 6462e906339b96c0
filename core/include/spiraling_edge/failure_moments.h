/// When a failure of a run came about: three moments, each an address to go to.
#pragma once

#include "spiraling_edge/inspection.h"
#include "spiraling_edge/ledger.h"

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
/// - a faulty triangle: the last test in its pivot that took one of its corners;
/// - a point in no triangle: the last test that refused it, or the fan that it was the pivot of;
/// - a hole: the last time that a fan, or a test between two points of the loop, was refused.
Result<FailureMoments> momentsOf(const PointSet& points, const Params& params,
                                 const MeshFailure& failure, const std::vector<Triangle>& mesh,
                                 const Progress& progress = {});

}  // namespace se
