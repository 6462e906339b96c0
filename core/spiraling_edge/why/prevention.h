/// The rule that prevents what an answer is about: one of `robust` that is off, and changes the
/// answer when it is on.
#pragma once

#include <cstdint>

#include "spiraling_edge/why/prover.h"

namespace se {

/// Looks for the rule that prevents a failure, or brings an absent subject in, and sets
/// Ledger::preventedBy and a sentence at the end of the answer, which is settled. The rules of
/// `robust` that are off are run one at a time: first those that decide otherwise in a step at the
/// pivots of the cause and of the triangles in question, or after `last`, the number of the last
/// pivot of the run. Of those that change the answer the one with the fewest faults is taken
/// (hasFewerFaults()). At most `left` steps; where they do not last for any that changes it,
/// nothing is said. False if cancelled. Deterministic.
bool addPrevention(const PointSet& points, const Params& params, std::uint32_t last,
                   const ProofAim& aim, std::uint64_t left, Ledger& ledger,
                   const Progress& progress);

}  // namespace se
