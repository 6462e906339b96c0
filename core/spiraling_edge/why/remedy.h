/// The rules beyond the paper that would have prevented a failure, found by running again with one
/// rule on.
#pragma once

#include <string_view>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se {

/// The effect of a rule that is off, or of a whole set of rules.
struct Remedy {
    const RuleSetting* rule = nullptr;  ///< Null: the whole set.
    std::string_view set;               ///< The name of a whole set.
    bool prevents = false;              ///< The failure is gone.
    bool unknown = false;               ///< Undecided: the list of its class is incomplete.
    /// Failures of its class, and of all classes, of that run; a lower bound if the run is tangled.
    std::size_t ofClass = 0;
    std::size_t all = 0;
};
/// The name of the rule or the set.
std::string_view nameOf(const Remedy& remedy);

struct Remedies {
    /// Each rule of `robust` that is off, by itself, and then the sets `corrected` and `robust`:
    /// those that prevent the failure first, of these those that leave the fewest failures.
    std::vector<Remedy> tried;
    std::size_t ofClass = 0;  ///< Failures of its class without a remedy.
    std::size_t all = 0;
};

/// True if the failure is still among `failures`. One of its class that shares two points with it,
/// or its only point, counts as the same: a hole that has become smaller is still there.
bool isStillThere(const MeshFailure& failure, const std::vector<MeshFailure>& failures);

/// The rules that `robust` has on and `params` has off, in the order of the table.
std::vector<const RuleSetting*> rulesToAdd(const Params& params);

/// Tries them all, a run and an inspection each. Fails if cancelled. Deterministic. Points that
/// `robust` would set aside for noise stay: the points are the same in all runs.
Result<Remedies> findRemedies(const PointSet& points, const Params& params,
                              const MeshFailure& failure, const Progress& progress = {});

}  // namespace se
