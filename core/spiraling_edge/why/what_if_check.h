/// Checks of what-ifs: whether each can take effect, and if not, why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// One status for each of params.whatIf, in their order: success, or the reason for its refusal. A
/// what-if is refused if nothing is tested at its place, if it has no effect, or if after its pivot
/// an invariant of stepper/invariants.h would not hold that holds without it. Nothing if `progress`
/// cancelled. O(run up to the last of them).
std::optional<std::vector<Status>> checkWhatIfs(const PointSet& points, const Params& params,
                                                const Progress& progress = {});

/// The triangles that the pivot of the last of params.whatIf makes with it, from a state before
/// that pivot; fails as checkWhatIfs() if that what-if is refused. Requires a what-if. O(points).
Result<std::vector<Triangle>> madeWithLastWhatIf(const PointSet& points, const Params& params,
                                                 const State& before);

/// The reason why a test with this verdict cannot be inverted; empty if it can, or if no reason is
/// known.
std::string reasonAgainst(Verdict verdict, Index point);

/// The first reason of a refusal, with its what-if; success if all can be done.
Status requireWhatIfs(const PointSet& points, const Params& params);

/// stateHash() combined with the what-ifs of the run; without any it is stateHash().
std::uint64_t runHash(const State& state, const Params& params);

}  // namespace se
