/// Edge rings as lists of points, apart from the entries of the run.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/stepper/edge_ring.h"

namespace se {

/// One ring as a list of points, in the direction of the ring.
struct RingPath {
    std::vector<Index> points;
    std::vector<bool> open;  ///< The step from points[i] to the next is no mesh edge.
    bool active = false;
    Index depth = 0;  ///< On the stack, 0 = top.
    Index id = kNone;
    Index number = 0;  ///< Among all rings of the run, as EdgeRings::number().
};

/// The name of a ring for the whole run, by its number: "a" to "z", "aa", "ab" ...
std::string ringName(Index number);

/// One ring, from its head on.
RingPath ringPath(const EdgeRings& rings, Index ring);
/// The rings: the active one first, then the stack from the top.
std::vector<RingPath> ringPaths(const EdgeRings& rings);
/// Number of rings on the stack: all of them if none is active.
std::size_t stackedCount(std::span<const RingPath> rings);

/// The two loops of a split, just after it, or of a join, just before it.
struct RingExchange {
    RingPath a;  ///< The loop that continues; of a join, that of the pivot.
    RingPath b;  ///< The loop that waits on the stack; of a join, the one that was found.
};

}  // namespace se
