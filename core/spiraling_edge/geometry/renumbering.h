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

/// Points and their lists in an order that keeps neighbors near in memory: renumbered along a
/// Z-curve if they are scattered, else as they are.
class OrderedPoints {
  public:
    /// Positions and lists must outlive this object.
    OrderedPoints(std::span<const Vec3> position, const NeighborLists& lists);
    /// Takes the lists over, which saves the memory of a copy. The positions must outlive it.
    OrderedPoints(std::span<const Vec3> position, NeighborLists&& lists);
    OrderedPoints(const OrderedPoints&) = delete;
    OrderedPoints& operator=(const OrderedPoints&) = delete;

    /// The numbers; empty if the points are not scattered.
    const Numbering& numbering() const { return numbering_; }
    std::span<const Vec3> position() const { return position_; }
    const NeighborLists& lists() const { return *lists_; }

    /// The values of points by their new numbers, given those by the old ones.
    std::vector<Vec3> renumbered(std::vector<Vec3> values) const;
    /// The values of points by their old numbers, given those by the new ones.
    std::vector<Vec3> restored(std::vector<Vec3> values) const;

  private:
    void renumberIfScattered();

    Numbering numbering_;
    std::vector<Vec3> ownPosition_;
    NeighborLists ownLists_;
    std::span<const Vec3> position_;
    const NeighborLists* lists_;
};

}  // namespace se
