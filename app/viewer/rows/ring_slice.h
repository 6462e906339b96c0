/// The part of an edge ring that the strip in the panel Rings has room for. Plain arithmetic.
#pragma once

#include <optional>
#include <vector>

#include "run/picture.h"

namespace se::view {

/// Places in RingPath::points, in the direction of the ring; each at most once.
struct RingSlice {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t size = 0;  ///< Of the ring.

    std::size_t at(std::size_t i) const { return (first + i) % size; }
    bool whole() const { return count == size; }
};

/// Where the ring is worked on: the pivot if it still stands there, between first and last if it
/// stands there more than once; else where it goes on; nothing in a ring that the pivot is not on.
std::optional<std::size_t> workPlace(const Picture& picture, const RingPath& ring);

/// So many points as fit, with `middle` in the middle, moved on by `shift` points.
RingSlice sliceAbout(std::size_t size, std::size_t middle, long shift, std::size_t fits);

/// The ring with that id, else the active one; null if there is none.
const RingPath* ringToShow(const Picture& picture, Index id);

}  // namespace se::view
