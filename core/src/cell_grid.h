/// Points in the cells of a grid, to find those near a place.
#pragma once

#include <glm/common.hpp>
#include <glm/fwd.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "spiraling_edge/point_set.h"

namespace se {

/// Points in the cells of a grid, to find those near a place.
class CellGrid {
  public:
    /// Requires a cell above 0 and low <= high; what lies outside counts to the cells at the
    /// border.
    CellGrid(const Vec3& low, const Vec3& high, double cell) : low_(low), cell_(cell) {
        while (cellsOf(high) > kMostCells) cell_ *= 1.25;
        for (int i = 0; i < 3; ++i) count_[i] = static_cast<int>((high[i] - low_[i]) / cell_) + 1;
        first_.assign(slot(count_ - 1) + 1, kNone);
    }
    /// Adds the next point; they are numbered in this order.
    void add(const Vec3& x) {
        Index& first = first_[slot(cellOf(x))];
        next_.push_back(first);
        first = static_cast<Index>(next_.size() - 1);
    }
    /// Calls `see` with all points within the width of a cell, and with some farther ones.
    template <typename See>
    void near(const Vec3& x, See&& see) const {
        const glm::ivec3 from = glm::max(cellOf(x) - 1, glm::ivec3(0));
        const glm::ivec3 to = glm::min(cellOf(x) + 1, count_ - 1);
        for (int k = from.z; k <= to.z; ++k) {
            for (int j = from.y; j <= to.y; ++j) {
                for (int i = from.x; i <= to.x; ++i) {
                    for (Index p = first_[slot({i, j, k})]; p != kNone; p = next_[p]) see(p);
                }
            }
        }
    }

  private:
    /// Surfaces leave most cells empty: beyond this, memory costs more than a look at more points.
    static constexpr double kMostCells = 16e6;

    double cellsOf(const Vec3& high) const {
        const Vec3 count = (high - low_) / cell_ + 1.0;
        return count.x * count.y * count.z;
    }
    glm::ivec3 cellOf(const Vec3& x) const {
        return glm::clamp(glm::ivec3((x - low_) / cell_), glm::ivec3(0), count_ - 1);
    }
    std::size_t slot(const glm::ivec3& cell) const {
        const glm::i64vec3 wide(cell);
        return static_cast<std::size_t>((wide.z * count_.y + wide.y) * count_.x + wide.x);
    }

    Vec3 low_;
    double cell_;
    glm::ivec3 count_{};
    std::vector<Index> first_, next_;  ///< Of each cell; after each point, in the same cell.
};

}  // namespace se
