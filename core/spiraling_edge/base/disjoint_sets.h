/// Groups of numbers, joined pair by pair.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se {

/// Each group is named by its least member. By path halving.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), Index{0});
    }
    Index find(Index x) {
        while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
        return x;
    }
    /// True if the two were apart.
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
