/// Fans that a rule refused, known for as long as nothing about them has changed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The pivots whose fans were refused. Until a ring step or a triangle at a point that the pivot
/// lists changes, or a rule is relaxed, the same fan is refused again: nothing else decides about
/// it. It follows from the run, so it is no part of State.
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
        refusals_[entry] = {pivot, retryLevel};
    }
    /// True if the fan of the entry, at point p between two others, was refused by the same rules,
    /// and none of these points or of those in p's list changed since. O(list).
    bool refuses(Index entry, std::uint32_t retryLevel, std::array<Index, 3> ring,
                 std::span<const Index> list) const {
        if (entry >= refusals_.size() || refusals_[entry].pivot == 0) return false;
        const Refusal& last = refusals_[entry];
        const auto isAsThen = [&](Index p) { return changedAt_[p] < last.pivot; };
        return last.retryLevel == retryLevel && std::all_of(ring.begin(), ring.end(), isAsThen) &&
               std::all_of(list.begin(), list.end(), isAsThen);
    }

  private:
    struct Refusal {
        std::uint32_t pivot = 0;
        std::uint32_t retryLevel = 0;
    };
    std::vector<std::uint32_t> changedAt_;  ///< Per point: the last pivot that changed it.
    std::vector<Refusal> refusals_;         ///< Per entry.
};

}  // namespace se
