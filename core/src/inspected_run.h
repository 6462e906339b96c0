/// A run with everything that went wrong in it, without the moments.
#pragma once

#include <optional>
#include <vector>

#include "spiraling_edge/inspection.h"
#include "spiraling_edge/params.h"
#include "spiraling_edge/prepare.h"
#include "spiraling_edge/state.h"

namespace se {

struct InspectedRun {
    State end;
    std::vector<MeshFailure> failures;  ///< As inspectMesh() finds them, then rings left over.
};

/// Runs `points` to the end and looks at what came out; nothing if `progress` cancelled.
std::optional<InspectedRun> inspectRun(const PointSet& points, const Params& params,
                                       const Progress& progress);

}  // namespace se
