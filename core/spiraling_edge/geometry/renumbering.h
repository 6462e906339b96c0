/// Renumbering of points along a Z-curve: neighbors in space become neighbors in memory, which
/// saves most of the cache misses of work on large sets in random order.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// New numbers of points. Empty: every point keeps its number.
struct Numbering {
    std::vector<Index> original;  ///< The old number of each new one.
    std::vector<Index> place;     ///< The new number of each old one.

    Index originalOf(Index p) const { return original.empty() ? p : original[p]; }
    Index placeOf(Index p) const { return place.empty() ? p : place[p]; }
};

/// True for 100,000 points and more, if most of a thousand samples are far in memory from their
/// nearest neighbor. The data of fewer points fit the caches: renumbering them costs more than it
/// saves.
bool areScattered(const NeighborLists& lists);

/// The numbers in the order of zCurveOrder(). O(points).
Numbering numberingAlongZCurve(std::span<const Vec3> position);

/// The inverse of a permutation.
std::vector<Index> inverse(std::span<const Index> permutation);

/// values[order[0]], values[order[1]], ...
template <typename Values>
auto permuted(const Values& values, std::span<const Index> order) {
    std::vector<typename Values::value_type> result;
    result.reserve(order.size());
    for (const Index i : order) result.push_back(values[i]);
    return result;
}

/// The lists of the points by their new numbers; every list keeps its order. O(points + entries).
NeighborLists renumbered(const NeighborLists& lists, const Numbering& numbering);

}  // namespace se
