/// The change that prevents what an answer is about: a rule of `robust` that is off, or another
/// preparation of the points.
#pragma once

#include <cstdint>

#include "spiraling_edge/why/prover.h"

namespace se {

/// Looks for the change that prevents a failure, or brings an absent subject in, and sets
/// Ledger::preventedBy and a sentence at the end of the answer, which is settled. The rules of
/// `robust` that are off, but `rim`, are run one at a time: first those that decide otherwise in a
/// step at the pivots of the cause and of the triangles in question, or after `last`, the number of
/// the last pivot of the run; where none changes the answer, the preparations. Of those that change
/// it the one with the fewest faults is taken (hasFewerFaults()): all are judged in the same way;
/// or the first, where the steps do not last for a verdict. At most `left` steps; where they do not
/// last for any that changes it, nothing is said. Fails if cancelled, or as
/// ProofScope::alternatives does. Deterministic.
Status addPrevention(const PointSet& points, const Params& params, std::uint32_t last,
                     const ProofAim& aim, std::uint64_t left, const ProofScope& scope,
                     Ledger& ledger, const Progress& progress);

}  // namespace se
