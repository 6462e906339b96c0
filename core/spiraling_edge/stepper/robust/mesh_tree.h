/// The triangles of a mesh that is edited, to find those near a box.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// A tree of boxes over triangles. At first its leaves hold triangles that follow each other in the
/// list and share corners, along a Gray-code curve: a list of fans holds most neighbors together. A
/// triangle that is put later goes where the boxes grow the least (Guttman 1984, R-trees), unless
/// it stays near; the boxes of nodes never shrink, until it isWorn(). Which triangles a search
/// finds does not depend on earlier changes, the order in which it visits them does.
class MeshTree {
  public:
    /// Children of a node.
    static constexpr Index kWidth = 4;

    /// The points must outlive it.
    MeshTree(const PointSet& points, std::span<const Triangle> triangles);

    /// Triangle `t` was made, or has other corners. Expected O(log triangles).
    void put(Index t, const Triangle& corners);
    /// Triangle `t` is gone, if there was one.
    void remove(Index t);

    /// True if so many leaves were added, without an order, that a new tree pays: on uneven points
    /// a search in it visits a third of the nodes.
    bool isWorn() const { return added_ > nodes_.size() / kMostAdded; }

    /// Calls visit(t) for each triangle whose conflictBox() meets `box`, until it returns true.
    /// True if it did.
    template <typename Visit>
    bool anyNear(const Box& box, Visit&& visit) const {
        return anyUnder(root_, bounds(box), visit);
    }

  private:
    /// A tree is worn with one added leaf among this many nodes.
    static constexpr std::size_t kMostAdded = 16;

    static constexpr float kFar = std::numeric_limits<float>::infinity();

    /// A box about the middle of all points, in units of their extent, rounded outward.
    struct Bounds {
        std::array<float, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};

        void add(const Bounds& o);
        bool holds(const Bounds& o) const;
        float size() const { return high[0] - low[0] + high[1] - low[1] + high[2] - low[2]; }
    };
    struct Node {
        /// Of the boxes of the children, by axis: compared four at a time.
        std::array<std::array<float, kWidth>, 3> low, high;
        std::array<Index, kWidth> child{kNone, kNone, kNone, kNone};  ///< Triangles or nodes.
        Index parent = kNone;  ///< kWidth times the parent, plus the position there.
        bool isLeaf = true;    ///< The children are triangles.

        Node();
        /// A bit for each child whose box meets another; an empty box meets none.
        unsigned meeting(const Bounds& o) const {
            std::array<int, kWidth> hit{};
            for (std::size_t i = 0; i < kWidth; ++i)
                hit[i] = int{low[0][i] <= o.high[0]} & int{o.low[0] <= high[0][i]} &
                         int{low[1][i] <= o.high[1]} & int{o.low[1] <= high[1][i]} &
                         int{low[2][i] <= o.high[2]} & int{o.low[2] <= high[2][i]};
            return static_cast<unsigned>(hit[0] | hit[1] << 1 | hit[2] << 2 | hit[3] << 3);
        }
        Bounds box(std::size_t place) const;
        void setBox(std::size_t place, const Bounds& box);
        Bounds all() const;
    };

    template <typename Visit>
    bool anyUnder(Index at, const Bounds& box, Visit&& visit) const {
        const Node& node = nodes_[at];
        for (unsigned left = node.meeting(box); left != 0; left &= left - 1) {
            const Index child = node.child[static_cast<std::size_t>(std::countr_zero(left))];
            if (node.isLeaf ? visit(child) : anyUnder(child, box, visit)) return true;
        }
        return false;
    }
    Bounds bounds(const Box& box) const;
    void set(Index node, Index place, Index child, const Bounds& box);
    void grow(Index node, const Bounds& box);
    Index leafFor(const Bounds& box) const;
    Index leafBeside(Index leaf);
    Index freePlace(Index node) const;

    const PointSet& points_;
    Vec3 middle_{0.0};
    double scale_ = 1.0;
    std::vector<Node> nodes_;
    Index root_ = 0;
    std::size_t added_ = 0;       ///< Leaves, since the tree was made.
    std::vector<Index> placeOf_;  ///< Per triangle: kWidth times its leaf, plus the position there.
};

}  // namespace se
