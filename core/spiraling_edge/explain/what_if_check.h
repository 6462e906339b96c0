/// Which what-ifs of a run can be done, and why the others cannot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// One answer for each of params.whatIf, in their order: success, or the reason why it has no
/// effect or must not have it. A what-if is refused if nothing is tested at its place, if it
/// changes nothing, or if behind its pivot an invariant of docs/architecture.md would not hold
/// that holds without it. Nothing if `progress` cancelled. O(run up to the last of them).
std::optional<std::vector<Status>> checkWhatIfs(const PointSet& points, const Params& params,
                                                const Progress& progress = {});

/// The same for the last of params.whatIf alone, at a state before its pivot. O(points).
Status checkLastWhatIf(const PointSet& points, const Params& params, const State& before);

/// Why a test that ended like this cannot end otherwise; empty if it can, or if there is nothing to
/// say.
std::string reasonAgainst(Verdict verdict, Index point);

/// The first reason among them, with what it is about; success if all can be done.
Status requireWhatIfs(const PointSet& points, const Params& params);

/// stateHash() with the what-ifs of the run in it; without any it is stateHash().
std::uint64_t runHash(const State& state, const Params& params);

}  // namespace se
