/// Whether the decision that made a failure unavoidable is its cause: the run forks there, with the
/// decision the other way, and goes on to its end.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/explain/failure_moments.h"
#include "spiraling_edge/stepper/what_if.h"

namespace se {

/// What became of a failure once the decision went the other way.
enum class Proof : std::uint8_t {
    Gone,       ///< It is gone, and no new one of its class is there.
    Later,      ///< The same point is tested again later; gone once that is turned, too.
    Earlier,    ///< Of two triangles: gone, without a new one, if the earlier is not made.
    Replaced,   ///< It is gone, but a new one of its class has two of its points.
    Stays,      ///< Another decision brings the same about: one of its class has the same points.
    NotTurned,  ///< The decision cannot go the other way.
};
/// "gone", "gone, asked again", "gone with the earlier", "another in its place", "stays", "cannot
/// be turned".
std::string_view proofName(Proof proof);

struct FailureProof {
    Proof proof = Proof::NotTurned;
    std::vector<WhatIf> turns;  ///< What was done instead; several where a test is made again.
    std::string reason;  ///< NotTurned: why. Stays: what does it then. Earlier: the decision.
};

/// The what-if that turns a decision: keep what was refused, drop what was taken, list no third
/// point that was inserted. Nothing where a decision has no other way, or is no decision.
std::optional<WhatIf> turnOf(const PointSet& points, const LedgerLine& decision);

/// One proof for each of the `chosen` among all failures of this run, in their order. Fails if
/// cancelled. A run from the decision to the end and an inspection each. Deterministic.
Result<std::vector<FailureProof>> proveCauses(const PointSet& points, const Params& params,
                                              std::span<const RunFailure> failures,
                                              std::span<const std::size_t> chosen,
                                              const Progress& progress = {});

/// Of each class at most `most`, spread evenly over all of it; their places, ascending.
std::vector<std::size_t> sampleOfEach(std::span<const RunFailure> failures, std::size_t most);

}  // namespace se
