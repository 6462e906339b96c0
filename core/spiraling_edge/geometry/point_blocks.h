/// Points in blocks of eight that lie near each other, and a tree of boxes around the blocks: the
/// distances to all points of a block are computed together.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/box.h"

namespace se {

/// Squared distance of two boxes, 0 if they meet. Never above distanceSquared() of two points in
/// them, not by rounding either: each operation is the same, of numbers that are no larger.
inline double squaredGap(const Box& a, const Box& b) {
    const Vec3 gap = glm::max(glm::max(a.low - b.high, b.low - a.high), Vec3(0.0));
    return gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
}

/// Points in the order of a balanced k-d tree (Bentley 1975), cut into blocks. A point's number in
/// this order is its slot: points of consecutive slots lie near each other.
class PointBlocks {
  public:
    /// Number of points of a block.
    static constexpr std::size_t kBlock = 8;
    /// One number for each point of a block.
    using PerPoint = std::array<double, kBlock>;
    /// Coordinates of a block's points. Slots after the last point are infinitely far away.
    struct Block {
        PerPoint x, y, z;
    };
    /// Consecutive blocks, and the box around their points.
    struct Node {
        Box box{Vec3(0.0)};
        std::uint32_t first = 0;
        std::uint32_t blocks = 0;

        bool isBlock() const { return blocks == 1; }
        std::size_t firstSlot() const { return std::size_t{first} * kBlock; }
    };

    /// The points with usable[p] true, whose positions must be finite. O(n log n). `threads` as in
    /// NeighborOptions; the tree is the same for any.
    PointBlocks(std::span<const Vec3> position, const std::vector<bool>& usable,
                unsigned threads = 0);

    /// Number of points.
    std::size_t size() const { return id_.size(); }
    /// Index of a slot's point in the whole set.
    Index id(std::size_t slot) const { return id_[slot]; }
    Vec3 position(std::size_t slot) const {
        const Block& block = block_[slot / kBlock];
        const std::size_t i = slot % kBlock;
        return {block.x[i], block.y[i], block.z[i]};
    }

    /// The node of all blocks. Requires points.
    const Node& root() const {
        assert(!node_.empty());
        return node_[0];
    }
    /// The halves of a node of more than one block.
    const Node& leftOf(const Node& node) const { return node_[numberOf(node) + 1]; }
    const Node& rightOf(const Node& node) const {
        return node_[numberOf(node) + nodesOf(node.blocks / 2) + 1];
    }

    /// distanceSquared() of p and each point of a block.
    PerPoint squaredDistances(std::size_t block, const Vec3& p) const {
        const Block& points = block_[block];
        PerPoint result;
        for (std::size_t i = 0; i < kBlock; ++i) {
            const double x = points.x[i] - p.x;
            const double y = points.y[i] - p.y;
            const double z = points.z[i] - p.z;
            result[i] = x * x + y * y + z * z;
        }
        return result;
    }

    /// Calls visit(node) with the node of each block whose box is at most this far from `box`,
    /// until it returns false. False if it did.
    template <typename Visit>
    bool forBlocksNear(const Box& box, double squaredReach, Visit&& visit) const {
        std::array<const Node*, kMaxOpen> open;
        std::size_t count = 0;
        open[count++] = &root();
        while (count > 0) {
            const Node& node = *open[--count];
            if (squaredGap(node.box, box) > squaredReach) continue;
            if (node.isBlock()) {
                if (!visit(node)) return false;
                continue;
            }
            assert(count + 2 <= kMaxOpen);
            open[count++] = &rightOf(node);
            open[count++] = &leftOf(node);
        }
        return true;
    }

    /// Room for the nodes that wait during a search: more than halvings of 2^32 points.
    static constexpr std::size_t kMaxOpen = 40;

  private:
    struct Item {
        std::array<double, 3> at;
        std::uint64_t id;  // as wide as a coordinate, so that items are moved in two pieces
    };

    /// Nodes lie in this order: the whole, its left half with all below it, its right half.
    static std::size_t nodesOf(std::size_t blocks) { return 2 * blocks - 1; }
    std::size_t numberOf(const Node& node) const {
        return static_cast<std::size_t>(&node - node_.data());
    }
    static void select(std::span<Item> items, std::size_t middle, std::size_t axis);
    void divide(std::span<Item> items, std::size_t number, std::uint32_t first, unsigned threads);
    void fillBlocks(std::span<const Item> items, unsigned threads);

    std::vector<Block> block_;
    std::vector<Node> node_;
    std::vector<Index> id_;
};

}  // namespace se
