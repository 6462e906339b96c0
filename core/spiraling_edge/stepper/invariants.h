/// Conditions that must hold between two pivots. Those with a star hold on well-sampled input, and
/// the paper's rules break them on thin, noisy or undersampled parts:
///   1. Status n > 0 exactly if the point has n entries on the active and the stacked rings
///      together; UNUSED and DONE points have none.
///   2. `prev` and `next` agree; each entry is in one ring; no ring of 0 or 1 entries; none of 2,
///      and no entry between two of one point, whose steps are both mesh edges; the active ring is
///      not on the stack, and no ring is on it twice.
///   3. A ring step that is not open is a directed edge of exactly one triangle, and its reverse of
///      none. *
///   4. A mesh edge with one triangle is such a step, or belonged to a freed ring, or lies at an
///      open step (not checked). *
///   5. No directed edge lies in two triangles. *
///   6. Triangles are only appended; those of one pivot are a fan about it; none has a corner
///      twice.
///   7. DONE is final: no DONE point is in a new triangle.
///   8. Angles in the neighbor ring increase strictly, between start and end.
///   9. A pivot without triangles changes nothing but the position and the circuit counter.
///  10. The number of rings changes by +1 for a seed or split, by -1 for a join or a ring closed or
///      freed, a failed seed's included, by nothing else.
///  11. The circuit counter stays below the active ring's length; the start pointer never goes
///      back. At a seed the points before it are DONE, but for at most one per failed seed, which
///      is UNUSED, and those that wait for a shelved ring.
///  12. An interior point that becomes DONE by §6.5 is inside one closed fan of triangles. *
///  13. At the end every point is DONE.
/// Those that need the state before a pivot are checked by the tests
/// (tests/support/invariant_checker.h).
#pragma once

#include <string>

#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

/// Checks the invariants that hold on any input and that a single State can show: 1, 2, 8, 11
/// and 13. Returns a sentence about the first violation; empty if all hold. Call it between pivots.
/// O(points).
std::string checkInvariants(const State& state, const PointSet& points, const Params& params);

}  // namespace se
