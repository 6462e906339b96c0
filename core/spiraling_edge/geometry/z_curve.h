/// Points in the order of a Z-curve (Morton 1966): neighbors in space are neighbors in memory.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The indices 0 .. position.size() - 1 along a Z-curve through the bounding box of the finite
/// positions, with 2^10 steps per side; ties by index. Positions that are not finite come last.
/// O(points).
std::vector<Index> zCurveOrder(std::span<const Vec3> position);

}  // namespace se
