/// Components of points in lists, and the sides that their normals face within each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/geometry/renumbering.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// Points with lists and unit normals; those with a zero normal take no part.
struct SidesInput {
    std::span<const Vec3> position;
    std::span<const Vec3> normal;
    const NeighborLists& lists;
    NeighborLists listedBy;  ///< listersOf(lists)
    /// The points' own numbers are the old ones: they break ties and order sums.
    const Numbering& numbering;
    unsigned threads = 0;  ///< As in NeighborOptions.

    bool hasNormal(Index p) const { return normal[p] != Vec3(0.0); }
};

/// Cosine between the normal of q and that of p mirrored at the plane halfway between them: 1 if a
/// circle runs through both, also across a thin part. The same for (q, p), bit for bit.
double agreementOf(const SidesInput& input, Index p, Index q);

/// The sides of the points, along one forest of the lists.
struct PointSides {
    /// Number of each point's component, in the order of their first points; kNone: no normal.
    std::vector<Index> component;
    std::size_t components = 0;
    std::vector<std::uint8_t> opposed;  ///< 0 or 1: which of the two sides of the component.
};

/// The sides along the minimum spanning forest of the lists in both directions. The weight of an
/// edge is 1 less the absolute agreement of its ends, plus `steepCost` times the squared sine of
/// its angle with the tangent plane of one of them, the steeper one. Deterministic: ties by old
/// number; the same for any number of threads. Fails if `progress` cancels.
Result<PointSides> sidesAlongForest(const SidesInput& input, double steepCost,
                                    const Progress& progress);

}  // namespace se
