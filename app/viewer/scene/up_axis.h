/// Which axis of an input points up.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

enum class UpAxis : std::uint8_t { X, Y, Z };

/// "x", "y", "z": as settings and session files name it.
std::string_view upAxisName(UpAxis axis);
/// Nothing if there is none of that name.
std::optional<UpAxis> upAxisFromName(std::string_view name);

/// A guess at the up axis of what `source` holds. Scenes, points made here and points with wall
/// types have z up. Other files lie on their flat side, where they have one; else the habit of
/// their format decides: y for PLY, OBJ, STL and OFF, z for all others. O(points).
UpAxis guessUpAxis(const PointSet& points, std::string_view source);

}  // namespace se::view
