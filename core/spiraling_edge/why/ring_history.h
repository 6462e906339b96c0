/// The origin of an edge ring: the sub-step that made it (a seed, a split, a join, §4 and §6.5) and
/// those that led to it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/why/ledger.h"

namespace se {

/// A ring by its address and place. Rings have no names of their own, since splits and joins change
/// them.
struct RingAddress {
    Address at;       ///< Just after this decision; a pivot alone: after its last.
    Index place = 0;  ///< 0: the active ring; else counted from the top of the stack, from 1.
    friend bool operator==(const RingAddress&, const RingAddress&) = default;
};
/// "active ring at 137", "ring #2 at 137.ring.4".
std::string nameOf(const RingAddress& ring);
/// Reads "137", "137#2", "137.ring.4#2". Fails with a sentence.
Result<RingAddress> ringAddressFromString(std::string_view text);

/// The seeds, splits and joins of a ring's ancestry; the cause is the last, which made the ring.
struct RingHistory : Ledger {
    Index length = 0;  ///< Points of the ring there.
};

/// The history of `ring`. Fails if the run has no such address, or no such ring there, or if
/// cancelled. O(run up to it).
Result<RingHistory> whyRing(const PointSet& points, const Params& params, const RingAddress& ring,
                            const Progress& progress = {});

}  // namespace se
