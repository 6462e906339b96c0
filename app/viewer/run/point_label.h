/// Labels of points: their numbers, or in a figure of the paper its letters.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/points/point_name.h"

namespace se::view {

/// "S 20", "20", "S first"; "q" alone where the name is that of the role.
inline std::string pointLabel(std::string_view role, Index point,
                              std::span<const PointName> names) {
    const std::string name = nameOf(point, names);
    return role.empty() || role == name ? name : std::string(role) + " " + name;
}

}  // namespace se::view
