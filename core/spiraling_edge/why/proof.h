/// Proof of an answer: the decision that, inverted, changes it, found by running on from there.
#pragma once

#include <cstdint>

#include "spiraling_edge/why/ledger.h"

namespace se {

/// The limits of a search for a proof.
struct ProofLimits {
    std::size_t inversions = 20;  ///< That are run to the end.
    /// Pivots of all inversions, in runs; at least kLeastProofPivots in any case.
    double runs = 3.0;
};
inline constexpr std::uint64_t kLeastProofPivots = 500'000;

/// The question why the subject is in the mesh of a run, or is not, answered with its proof: the
/// ledger of why(), with the lines about triangles in the place of an absent subject, and the
/// decision that, inverted, puts it into the mesh at the end, or keeps it out. That decision is the
/// cause then, and the sentence says so, or says that no inversion changes anything. Inversions
/// that show the change at their own pivot are run first, then those of the pivot that made the
/// subject, then the later ones. O(two runs, and those of `limits`). Fails as why() does.
/// Deterministic.
Result<Ledger> provedWhy(const PointSet& points, const Params& params, const Subject& subject,
                         const ProofLimits& limits = {}, const Progress& progress = {});

}  // namespace se
