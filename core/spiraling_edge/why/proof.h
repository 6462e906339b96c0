/// Proof of an answer: the decision that, inverted, changes it, found by running on from there.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/other_preparations.h"

namespace se {

/// The extent of a search for a proof, and for what else changes the answer.
struct ProofScope {
    std::size_t inversions = 20;  ///< That are run to the end.
    /// Steps of all inversions, in runs; at least kLeastProofSteps in any case. The change that
    /// prevents the answer is looked for in those that they leave, or in kLeastChangeSteps less
    /// three runs, whichever are more.
    double runs = 3.0;
    /// Found when a change is looked for that prevents the answer. Preparations are tried where no
    /// rule does; without a judge meshes are judged as by PointSet::judge. May be empty.
    std::function<Result<Alternatives>(const Progress&)> alternatives = {};

    /// The scope of --more.
    static ProofScope wide() { return {200, 100.0}; }
};
inline constexpr std::uint64_t kLeastProofSteps = 500'000;
inline constexpr std::uint64_t kLeastChangeSteps = 1'000'000;

/// The question why the subject is in the mesh of a run, or is not, answered with its proof: the
/// ledger of why(), with the lines about triangles in the place of an absent subject, and the
/// decision that, inverted, puts it into the mesh at the end, or keeps it out. That decision is the
/// cause then, and the sentence says so, or ends with the number of inversions that do not change
/// the answer. Inversions that make an absent subject at their own pivot are run first, then that
/// of the cause of why(), then those of the pivot that made the subject, then the later ones.
/// O(three runs + points for each of at most 202 inversions + the runs of `scope`). Fails as why()
/// does. Deterministic.
Result<Ledger> provedWhy(const PointSet& points, const Params& params, const Subject& subject,
                         const ProofScope& scope = {}, const Progress& progress = {});

/// The moments of a failure as a ledger, whose cause is the last decision that it depends on. Not
/// proved, except by a step after the last pivot.
Ledger ledgerOf(const RunFailure& failure);

/// The question why a failure is in the mesh of a run, in the same way: its moments and the
/// decisions that it may come from, with the one that, inverted, takes it away. Preferred is one
/// that leaves no new failure of its class in its place. A point in no triangle is treated as a
/// subject. `known`: all failures of the run. An inspection of the mesh for each inversion. Fails
/// if cancelled. Deterministic.
Result<Ledger> provedWhy(const PointSet& points, const Params& params, const RunFailure& failure,
                         std::span<const MeshFailure> known, const ProofScope& scope = {},
                         const Progress& progress = {});

}  // namespace se
