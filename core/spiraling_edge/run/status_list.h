/// The status of every point, with a count of each kind: a value that is cheap to copy.
#pragma once

#include <span>

#include "spiraling_edge/base/block_list.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

/// Number of points in each state.
struct StatusCounts {
    std::size_t unused = 0;
    std::size_t used = 0;
    std::size_t done = 0;
    friend bool operator==(const StatusCounts&, const StatusCounts&) = default;
};

class StatusList {
  public:
    std::size_t size() const { return list_.size(); }
    PointStatus operator[](std::size_t point) const { return list_[point]; }
    const StatusCounts& counts() const { return counts_; }
    const BlockList<PointStatus>& blocks() const { return list_; }

    void set(Index point, PointStatus status);
    /// Takes the values of `all`. Blocks without a change stay shared.
    void assign(std::span<const PointStatus> all);

    friend bool operator==(const StatusList& a, const StatusList& b) { return a.list_ == b.list_; }

  private:
    BlockList<PointStatus> list_;
    StatusCounts counts_;
};

}  // namespace se
