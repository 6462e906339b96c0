/// The axis of an input that points up.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

enum class UpAxis : std::uint8_t { X, Y, Z };

/// "x", "y", "z": the names in settings and session files.
std::string_view upAxisName(UpAxis axis);
/// Empty if there is no axis of that name.
std::optional<UpAxis> upAxisFromName(std::string_view name);

/// A guess at the up axis of `source`. Scenes, sampled points and points with wall types have z
/// up. Other files lie on their flat side if they have one; otherwise the convention of
/// their format decides: y for formats of meshes, such as PLY, z for all others. O(points).
UpAxis guessUpAxis(const PointSet& points, std::string_view source);

}  // namespace se::view
