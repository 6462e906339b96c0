/// Names of points, as the letters of a figure: "p", "first", "q".
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "spiraling_edge/base/types.h"

namespace se {

/// The name of one point.
struct PointName {
    Index point = kNone;
    std::string name;
    friend bool operator==(const PointName&, const PointName&) = default;
};

/// The name of a point: its number where `names` has none for it, "none" for kNone.
inline std::string nameOf(Index point, std::span<const PointName> names) {
    const auto named = std::find_if(names.begin(), names.end(),
                                    [&](const PointName& each) { return each.point == point; });
    if (named != names.end()) return named->name;
    return point == kNone ? "none" : std::to_string(point);
}

}  // namespace se
