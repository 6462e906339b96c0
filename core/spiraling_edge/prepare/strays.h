/// Strays: points far from all others, which no point of the surface has among its nearest.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Thresholds of strayPoints(), measured on half of the shared sets and judged on the others
/// (docs/robust.md).
struct StrayLimits {
    double farOfAll = 3.0;  ///< Far is more than this times the reach of each point about,
    double far = 4.0;       ///< or than this times their median.
    std::size_t third = 3;  ///< The reach of a point is the distance to its third nearest: past
                            ///< others that are as far, alone or by twos and threes.
    std::size_t asked = 6;  ///< Number of nearest points that must not list the point.
};
inline constexpr StrayLimits kStrayLimits{};

/// True for each stray: its third nearest point is over three times as far away as that of any of
/// its 12 nearest is from it, or over four times as far as those are in the median; and of its six
/// nearest none has it among their 12, but for those that are as far themselves. Up to three that
/// lie side by side are found, four are a piece of their own. Where others have three neighbors, a
/// point with fewer in reach of a list (findNeighbors()) counts as far. `nearest`: the 12 nearest
/// of each point by positions alone, with any normals, copies and points that are not finite left
/// out; `present` is false for those, and for others to leave out, which are no strays and in no
/// list. `threads` as in NeighborOptions; the result is the same for any. O(points).
std::vector<bool> strayPoints(std::span<const Vec3> position, const std::vector<bool>& present,
                              const NeighborLists& nearest, unsigned threads = 0);

}  // namespace se
