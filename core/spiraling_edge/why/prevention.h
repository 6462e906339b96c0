/// The rule that prevents what an answer is about: one of `robust` that is off, decides otherwise
/// where the answer was decided, and changes the answer when it is on.
#pragma once

#include <cstdint>

#include "spiraling_edge/why/prover.h"

namespace se {

/// Looks for the rule that prevents a failure, or brings an absent subject in, and sets
/// Ledger::preventedBy and a sentence at the end of the answer, which is settled. The rules of
/// `robust` that are off make a step at the pivots of the cause and of the triangles in question,
/// and at `last`, the number of the last pivot of the run; the first eight that decide otherwise
/// are run whole. Of those that change the answer, that with the fewest faults left is taken. At
/// most `left` steps: nothing is said where they do not last. False if cancelled. Deterministic.
bool addPrevention(const PointSet& points, const Params& params, std::uint32_t last,
                   const ProofAim& aim, std::uint64_t left, Ledger& ledger,
                   const Progress& progress);

}  // namespace se
