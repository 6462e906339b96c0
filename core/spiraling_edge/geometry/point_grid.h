/// Points in the cells of a grid, to find those near a place.
#pragma once

#include <array>
#include <cassert>
#include <glm/common.hpp>
#include <glm/fwd.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Points in the cells of a grid, to find those near a place. Memory is allocated in blocks of 8 x
/// 8 x 8 cells, only for blocks with points, so that time and memory are proportional to the number
/// of points on a surface, not to the volume around it.
class CellGrid {
  public:
    /// Requires a cell above 0 and low <= high; points outside belong to the cells at the border.
    CellGrid(const Vec3& low, const Vec3& high, double cell) : low_(low), cell_(cell) {
        assert(cell > 0.0 && low.x <= high.x && low.y <= high.y && low.z <= high.z);
        while (blocksOf(high) > kMaxBlocks) cell_ *= 1.25;
        for (int i = 0; i < 3; ++i) count_[i] = static_cast<int>((high[i] - low_[i]) / cell_) + 1;
        blocks_ = (count_ - 1) / kSide + 1;
        block_.assign(blockOf(count_ - 1) + 1, kNone);
    }
    /// Adds the next point; they are numbered in this order.
    void add(const Vec3& x) {
        const glm::ivec3 cell = cellOf(x);
        Index& block = block_[blockOf(cell)];
        if (block == kNone) {
            block = static_cast<Index>(first_.size());
            first_.emplace_back().fill(kNone);
        }
        Index& first = first_[block][slotIn(cell)];
        next_.push_back(first);
        first = static_cast<Index>(next_.size() - 1);
    }
    /// Calls `visit` with all points within the width of a cell of `x`, and with some farther ones.
    template <typename Visit>
    void near(const Vec3& x, Visit&& visit) const {
        const glm::ivec3 from = glm::max(cellOf(x) - 1, glm::ivec3(0));
        const glm::ivec3 to = glm::min(cellOf(x) + 1, count_ - 1);
        for (int k = from.z; k <= to.z; ++k) {
            for (int j = from.y; j <= to.y; ++j) {
                for (int i = from.x; i <= to.x; ++i) {
                    for (Index p = firstIn({i, j, k}); p != kNone; p = next_[p]) visit(p);
                }
            }
        }
    }

  private:
    /// Cells along an edge of a block.
    static constexpr int kSide = 8;
    /// Beyond this, the table of blocks costs more than visiting more points per cell.
    static constexpr double kMaxBlocks = 16e6;

    double blocksOf(const Vec3& high) const {
        const Vec3 count = (high - low_) / (cell_ * kSide) + 1.0;
        return count.x * count.y * count.z;
    }
    glm::ivec3 cellOf(const Vec3& x) const {
        return glm::clamp(glm::ivec3((x - low_) / cell_), glm::ivec3(0), count_ - 1);
    }
    std::size_t blockOf(const glm::ivec3& cell) const {
        const glm::i64vec3 wide(cell / kSide);
        return static_cast<std::size_t>((wide.z * blocks_.y + wide.y) * blocks_.x + wide.x);
    }
    static std::size_t slotIn(const glm::ivec3& cell) {
        const glm::i64vec3 in(cell % kSide);
        return static_cast<std::size_t>((in.z * kSide + in.y) * kSide + in.x);
    }
    Index firstIn(const glm::ivec3& cell) const {
        const Index block = block_[blockOf(cell)];
        return block == kNone ? kNone : first_[block][slotIn(cell)];
    }

    Vec3 low_;
    double cell_;
    glm::ivec3 count_{}, blocks_{};
    std::vector<Index> block_;  ///< Position of the block in `first_`; kNone: without points.
    std::vector<std::array<Index, kSide * kSide * kSide>> first_;  ///< First point of each cell.
    std::vector<Index> next_;                                      ///< Next point in the same cell.
};

}  // namespace se
