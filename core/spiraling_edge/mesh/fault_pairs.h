/// Pairs of triangles that are faults: intersections and second layers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/mesh/faults.h"

namespace se {

/// Limits of a search: it ends at the first that is reached.
struct PairLimits {
    /// Those of faults.h, for a mesh of this many triangles.
    static PairLimits ofMesh(std::size_t triangles);

    std::uint64_t work;   ///< In pairs visited.
    std::uint64_t flat;   ///< Pairs in one plane; more of them cost extra work.
    std::uint64_t found;  ///< Intersections, or second layers.
};

/// Tests all pairs of usable triangles: the faults found are in any order, once or twice each.
/// `usable` has a 1 for each triangle with an area. `threads` 0: as many as the machine has; the
/// result is the same for any number.
FaultSearch searchPairs(const PointSet& points, std::span<const Triangle> triangles,
                        std::span<const std::uint8_t> usable, const PairLimits& limits,
                        unsigned threads);

}  // namespace se
