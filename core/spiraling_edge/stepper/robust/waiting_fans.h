/// Fans that a rule refused, known for as long as nothing about them has changed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

/// The pivots whose fans were refused. Until a ring step or a triangle at a point that the pivot
/// lists changes, the same rules refuse the same fan again: nothing else decides about it. It
/// follows from the run, so it is no part of State.
class WaitingFans {
  public:
    explicit WaitingFans(std::size_t pointCount) : changedAt_(pointCount, 0) {}

    /// Forgets all fans: the run goes on from another place.
    void forget() { refusals_.clear(); }
    /// A ring step or triangle at the point changes in this pivot.
    void change(Index p, std::uint32_t pivot) { changedAt_[p] = pivot; }
    /// The fan of a ring entry is refused in this pivot.
    void refuse(Index entry, std::uint32_t pivot, std::uint32_t retryLevel) {
        if (entry >= refusals_.size()) refusals_.resize(entry + 1 + entry / 2);
        refusals_[entry][retryLevel] = pivot;
    }
    /// True if the fan of the entry, at point p between two others, was refused by the same rules,
    /// and none of these points or of those in p's list changed since. O(list).
    bool refuses(Index entry, std::uint32_t retryLevel, std::array<Index, 3> ring,
                 std::span<const Index> list) const {
        if (entry >= refusals_.size() || refusals_[entry][retryLevel] == 0) return false;
        const std::uint32_t last = refusals_[entry][retryLevel];
        const auto isAsThen = [&](Index p) { return changedAt_[p] < last; };
        return std::all_of(ring.begin(), ring.end(), isAsThen) &&
               std::all_of(list.begin(), list.end(), isAsThen);
    }

  private:
    std::vector<std::uint32_t> changedAt_;  ///< Per point: the last pivot that changed it.
    /// Per entry and State::retryLevel: the last pivot in which its fan was refused; 0 if none was.
    /// By level, since a ring that makes a triangle goes back to level 0.
    std::vector<std::array<std::uint32_t, kFillFailed + 1>> refusals_;
};

}  // namespace se
