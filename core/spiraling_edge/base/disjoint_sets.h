/// Disjoint sets of numbers (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se {

/// Disjoint sets, each named by its least member. Path halving (Tarjan and van Leeuwen 1984).
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), Index{0});
    }
    Index find(Index x) {
        while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
        return x;
    }
    /// Joins the sets of x and y. True if they were different.
    bool unite(Index x, Index y) {
        x = find(x);
        y = find(y);
        parent_[std::max(x, y)] = std::min(x, y);
        return x != y;
    }

  private:
    std::vector<Index> parent_;
};

}  // namespace se
