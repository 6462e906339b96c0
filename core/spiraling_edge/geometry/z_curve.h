/// Points in the order of a Z-curve (Morton 1966): what is near in space is near in memory.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The indices 0 .. position.size() - 1 along a Z-curve through the bounding box of the finite
/// positions, at 2^10 steps a side; equal steps by index. Positions that are not finite come last.
/// O(points).
std::vector<Index> zCurveOrder(std::span<const Vec3> position);

}  // namespace se
