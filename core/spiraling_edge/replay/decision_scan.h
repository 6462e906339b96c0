/// Every decision of a run in order, with its place: the basis of query lines, breakpoints and
/// counts over a run.
#pragma once

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/replay/decision_query.h"
#include "spiraling_edge/replay/scan_run.h"

namespace se {

/// Runs from the start and calls `visit` with each decision, in order. `failures`: fills
/// Decision::failures, which doubles the cost. False if `progress` cancelled. Deterministic.
bool scanDecisions(const PointSet& points, const Params& params, bool failures,
                   const std::function<void(const Decision&, RunPosition)>& visit,
                   const Progress& progress = {});

/// The bit of a class in Decision::failures.
std::uint32_t failureBit(const FailureClass& kind);
/// True if the class can be detected during the run; false for those of the mesh as a whole.
bool appearsInRun(const FailureClass& kind);

}  // namespace se
