/// Test of whether the decision that made a failure unavoidable is its cause: the run forks there
/// with the decision inverted and continues to its end.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/why/failure_moments.h"

namespace se {

/// The outcome for a failure once the decision is inverted.
enum class Inversion : std::uint8_t {
    Gone,      ///< The failure is gone, and there is no new one of its class.
    Later,     ///< The same point is tested again later; gone once that decision is inverted, too.
    Earlier,   ///< Of two triangles: gone, without a new one, if the earlier is not made.
    Replaced,  ///< The failure is gone, but a new one of its class has two of its points.
    /// Another decision leads to the same: a failure of its class has the same points.
    NoEffect,
    NotInvertible,  ///< The decision cannot be inverted.
};
/// "gone", "gone after a second inversion", "gone with the earlier", "another in its place",
/// "stays", "cannot be turned".
std::string_view inversionName(Inversion inversion);

struct CauseInversion {
    Inversion outcome = Inversion::NotInvertible;
    std::vector<WhatIf> inverses;  ///< The what-ifs used; several where a test is repeated.
    /// NotInvertible: the reason. NoEffect: the other decision. Earlier: the decision.
    std::string reason;
};

/// The what-if that inverts a decision: keeps a refused point, drops a taken one, unlists an
/// inserted third point. Nothing where the event cannot be inverted or is no decision.
std::optional<WhatIf> inverseOf(const PointSet& points, const LedgerLine& decision);

/// One inversion for each of the `chosen` among all failures of this run, in their order. Fails if
/// cancelled. A run from the decision to the end and an inspection each. Deterministic.
Result<std::vector<CauseInversion>> invertCauses(const PointSet& points, const Params& params,
                                                 std::span<const RunFailure> failures,
                                                 std::span<const std::size_t> chosen,
                                                 const Progress& progress = {});

/// Positions, ascending, of at most `limit` failures of each class, spread evenly over it.
std::vector<std::size_t> sampleOfEach(std::span<const RunFailure> failures, std::size_t limit);

}  // namespace se
