/// The whole way from points to mesh at once, for who does not want to step.
#pragma once

#include <functional>

#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// The same points in another order in memory.
struct Renumbered {
    PointSet points;              ///< PointSet::order holds the order that they had.
    std::vector<Index> original;  ///< The index in the old set of each new point.
};

/// The points and their lists in the order of a Z-curve: what is near in space is near in memory. A
/// run over them takes the same steps, since it begins at the same points (PointSet::order) and
/// every list keeps its order. O(points + list entries).
Renumbered renumberAlongZCurve(const PointSet& points);

/// Gives a finished State of a run over `renumbered` the indices of the old set: in triangles, mesh
/// and alerts, and in who is DONE. What only a run that goes on would need (edge table, the
/// half-edges of the mesh, the last pivot) keeps the new ones.
void restoreIndices(const Renumbered& renumbered, State& state);

/// How a run ended, and what it left.
struct Reconstruction {
    State state;
    StopReason reason = StopReason::Finished;
};

/// Called now and then during a run; returning true ends it. The indices in the State need not be
/// those of the points.
using StopCondition = std::function<bool(const State&)>;

/// Runs the Spiraling Edge algorithm to the end: the same triangles, mesh, statuses,
/// alerts and counters as by Stepper::runUntil(). Many points in an order without regard to their
/// place are renumbered for the time of the run, which halves it. After StopReason::Condition only
/// the triangles and counters are of use.
Reconstruction reconstruct(const PointSet& points, const Params& params,
                           const StopCondition& stop = {});

}  // namespace se
