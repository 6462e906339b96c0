/// Runs a whole reconstruction in one call, for callers that do not need to step.
#pragma once

#include <functional>

#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// Points in another order in memory.
struct Renumbered {
    PointSet points;              ///< PointSet::order holds the original order.
    std::vector<Index> original;  ///< The index in the old set of each new point.
};

/// The points and their lists in the order of a Z-curve: neighbors in space are neighbors in
/// memory. A run over them takes the same steps, since it begins at the same points
/// (PointSet::order) and every list keeps its order. O(points + list entries).
Renumbered renumberAlongZCurve(const PointSet& points);

/// Translates a finished State of a run over `renumbered` to the indices of the old set: triangles,
/// mesh, alerts and statuses. Parts that only a continued run would need (edge table, the
/// half-edges of the mesh, the last pivot) keep the new ones.
void restoreIndices(const Renumbered& renumbered, State& state);

/// The result of a run.
struct Reconstruction {
    State state;
    StopReason reason = StopReason::Finished;
};

/// Called between the pivots of a run; returning true ends it. The indices in the State may be
/// those of a renumbered set.
using StopCondition = std::function<bool(const State&)>;

/// Runs the Spiraling Edge algorithm to the end: the same triangles, mesh, statuses, alerts and
/// counters as by Stepper::runUntil(). Large sets whose order is not spatial are renumbered during
/// the run, which halves its time. After StopReason::Condition only the triangles and counters are
/// valid.
Reconstruction reconstruct(const PointSet& points, const Params& params,
                           const StopCondition& stop = {});

}  // namespace se
