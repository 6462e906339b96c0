/// The search for the neighbor list of a single point.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/point_blocks.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

/// The rule for which points are listed, the same for all lists. Never listed are points at the
/// place of the point itself, and those whose normal opposes its own, where normals are given.
struct ListRule {
    /// All points within the reach; if false, at most `length` of them, at least 1.
    bool all = false;
    std::size_t length = 0;
    /// Number of nearest points of which all are taken that do not oppose; not below `length`.
    std::size_t examined = 0;
    double opposingCosine = 0.0;  ///< As in NeighborOptions.
    /// Squared distance of the farthest point that is listed.
    double squaredReach = std::numeric_limits<double>::max();
};

/// Searches the boxes of a tree, the nearest first: as fast wherever the other points lie.
class SingleSearch {
  public:
    /// `normal`: of each slot; empty: opposing ones are not left out. All three must outlive this.
    SingleSearch(const PointBlocks& blocks, std::span<const Vec3> normal, const ListRule& rule)
        : blocks_(blocks), normal_(normal), rule_(rule) {}

    /// The list of a slot's point, nearest first; valid until the next call.
    std::span<const Neighbor> list(std::size_t slot);

  private:
    struct Limits {
        std::size_t length = 0;   ///< At least 1.
        std::size_t dropped = 0;  ///< The search ends without a result when more are left out.
        bool dropOpposing = false;
    };
    /// A point that was found. Ordered as lists are.
    struct Found {
        Neighbor neighbor;
        std::size_t slot;
        friend bool operator<(const Found& a, const Found& b) { return a.neighbor < b.neighbor; }
    };

    bool search(const Limits& limits);
    bool scan(const PointBlocks::Node& node);
    void insert(const Found& candidate);
    bool full() const { return found_.size() == limits_.length; }
    bool opposes(std::size_t slot) const {
        return !normal_.empty() &&
               normalsOppose(normal_[slot_], normal_[slot], rule_.opposingCosine);
    }

    const PointBlocks& blocks_;
    std::span<const Vec3> normal_;
    const ListRule& rule_;
    Limits limits_;
    std::size_t slot_ = 0;
    Vec3 place_{0.0};
    std::size_t dropped_ = 0;
    double bound_ = 0.0;        // no point that is farther counts any more
    std::vector<Found> found_;  // as soon as it is full, a heap with the farthest in front
    std::vector<Neighbor> list_;
};

}  // namespace se
