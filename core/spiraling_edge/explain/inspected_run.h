/// A run with all its failures, without their moments.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/replay/scan_run.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

struct InspectedRun {
    State end;
    /// The failures that inspectWithTotals() finds, then rings left over; `totals` count all of
    /// them.
    std::vector<MeshFailure> failures;
    std::vector<ClassTotal> totals;

    /// The total of a class of failureClasses().
    const ClassTotal& totalOf(const FailureClass& kind) const {
        return totals[static_cast<std::size_t>(&kind - failureClasses().data())];
    }
};

/// Runs `points` to the end and inspects the result; nothing if `progress` cancelled. Calls
/// `visit`, unless it is empty, with each pivot.
std::optional<InspectedRun> inspectRun(const PointSet& points, const Params& params,
                                       const Progress& progress,
                                       const std::function<void(const ScannedPivot&)>& visit = {});

}  // namespace se
