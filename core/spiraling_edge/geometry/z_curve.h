/// Points in the order of a curve that fills space: neighbors in space are neighbors in memory.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The indices 0 .. position.size() - 1 along a Z-curve (Morton 1966) through the bounding box of
/// the finite positions, with 2^10 steps per side; ties by index. Positions that are not finite
/// come last. O(points).
std::vector<Index> zCurveOrder(std::span<const Vec3> position);

/// The indices along a Gray-code curve (Faloutsos 1986), otherwise as above. Each of its steps goes
/// along one axis; those of a Z-curve also go back along two or three, so that boxes around groups
/// of neighbors are larger.
std::vector<Index> grayCurveOrder(std::span<const Vec3> position);

}  // namespace se
