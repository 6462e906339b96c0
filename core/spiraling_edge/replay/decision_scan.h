/// Every decision of a run, one after the other, with its place: what query lines, breakpoints and
/// counts over a run are made of.
#pragma once

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/replay/decision_query.h"
#include "spiraling_edge/replay/scan_run.h"

namespace se {

/// Makes the run and shows each decision to `visit`, in order. `failures`: with
/// Decision::failures, which costs about as much again. False if `progress` cancelled.
/// Deterministic.
bool scanDecisions(const PointSet& points, const Params& params, bool failures,
                   const std::function<void(const Decision&, RunPlace)>& visit,
                   const Progress& progress = {});

/// The bit of a class in Decision::failures.
std::uint32_t failureBit(const FailureClass& kind);
/// Can the class be told while the run goes on? Those of the mesh as a whole cannot.
bool appearsInRun(const FailureClass& kind);

}  // namespace se
