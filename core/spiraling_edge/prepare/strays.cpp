#include "spiraling_edge/prepare/strays.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "spiraling_edge/base/median.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {
namespace {

constexpr std::size_t kPointsPerThread = 8192;

/// Points, the lists of the nearest of each, and how far the third of each is away.
class Reaches {
  public:
    Reaches(std::span<const Vec3> position, const std::vector<bool>& present,
            const NeighborLists& nearest, unsigned threads)
        : present_(present), nearest_(nearest), reach_(position.size(), 0.0) {
        forEachItem(position.size(), threads, kPointsPerThread, [&](std::size_t i) {
            const auto p = static_cast<Index>(i);
            const auto list = nearest[p];
            if (!present[p]) return;
            reach_[p] = list.size() < kStrayLimits.third
                            ? kNoReach
                            : std::sqrt(distanceSquared(position[list[kStrayLimits.third - 1]],
                                                        position[p]));
        });
        haveReach_ = std::any_of(reach_.begin(), reach_.end(),
                                 [](double reach) { return reach > 0.0 && reach < kNoReach; });
    }

    /// True if the point is far from its nearest, by their reaches.
    bool isFar(Index p) const {
        if (!present_[p]) return false;
        if (reach_[p] == kNoReach) return haveReach_;
        std::vector<double> others;
        others.reserve(nearest_[p].size());
        for (const Index q : nearest_[p]) others.push_back(reach_[q]);
        if (reach_[p] > kStrayLimits.farOfAll * *std::max_element(others.begin(), others.end()))
            return true;
        return reach_[p] > kStrayLimits.far * medianOf(others);
    }

  private:
    static constexpr double kNoReach = std::numeric_limits<double>::infinity();

    const std::vector<bool>& present_;
    const NeighborLists& nearest_;
    std::vector<double> reach_;
    bool haveReach_ = false;  ///< Some point has three neighbors.
};

/// True if one of the nearest, not far itself, has the point in its list.
bool isListed(const NeighborLists& nearest, const std::vector<std::uint8_t>& far, Index p) {
    const auto list = nearest[p].first(std::min(kStrayLimits.asked, nearest[p].size()));
    return std::any_of(list.begin(), list.end(), [&](Index q) {
        const auto theirs = nearest[q];
        return far[q] == 0 && std::find(theirs.begin(), theirs.end(), p) != theirs.end();
    });
}

}  // namespace

std::vector<bool> strayPoints(std::span<const Vec3> position, const std::vector<bool>& present,
                              const NeighborLists& nearest, unsigned threads) {
    assert(present.size() == position.size() && nearest.size() == position.size());
    const Reaches reaches(position, present, nearest, threads);
    // Bytes, since threads write side by side.
    std::vector<std::uint8_t> far(position.size(), 0);
    forEachItem(position.size(), threads, kPointsPerThread,
                [&](std::size_t i) { far[i] = reaches.isFar(static_cast<Index>(i)) ? 1 : 0; });
    std::vector<bool> stray(position.size(), false);
    for (Index p = 0; p < position.size(); ++p)
        stray[p] = far[p] != 0 && !isListed(nearest, far, p);
    return stray;
}

}  // namespace se
