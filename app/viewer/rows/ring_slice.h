/// The part of an edge ring that fits into the strip of the panel Rings. Plain arithmetic.
#pragma once

#include <optional>

#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

/// Positions in RingPath::points, in the direction of the ring; each at most once.
struct RingSlice {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t size = 0;  ///< Of the ring.

    std::size_t at(std::size_t i) const { return (first + i) % size; }
    bool whole() const { return count == size; }
};

/// The position of current work: the pivot if it is still on the ring, between first and last if it
/// is there more than once; otherwise where the ring continues; empty in a ring without the pivot.
std::optional<std::size_t> workPlace(const DecisionState& picture, const RingPath& ring);

/// As many points as fit, with `middle` in the middle, moved by `shift` points.
RingSlice sliceAbout(std::size_t size, std::size_t middle, long shift, std::size_t fits);

/// The ring with that id, otherwise the active one; null if there is none.
const RingPath* ringToShow(const DecisionState& picture, Index id);

}  // namespace se::view
