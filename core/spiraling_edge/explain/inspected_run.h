/// A run with everything that went wrong in it, without the moments.
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
    /// As inspectWithTotals() finds them, then rings left over; totals are of all of them.
    std::vector<MeshFailure> failures;
    std::vector<ClassTotal> totals;

    /// Of a class of failureClasses().
    const ClassTotal& totalOf(const FailureClass& kind) const {
        return totals[static_cast<std::size_t>(&kind - failureClasses().data())];
    }
};

/// Runs `points` to the end and looks at what came out; nothing if `progress` cancelled.
/// `visit` is shown each pivot, if it is given.
std::optional<InspectedRun> inspectRun(const PointSet& points, const Params& params,
                                       const Progress& progress,
                                       const std::function<void(const ScannedPivot&)>& visit = {});

}  // namespace se
