/// Twins: points in pairs much nearer to each other than to the rest, as two stations leave.
#pragma once

#include <glm/geometric.hpp>
#include <span>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// A twin's nearest point is nearer than this share of the distance to the fourth nearest.
inline constexpr double kTwinShare = 0.25;

/// The nearest point of a twin; else kNone. `nearest`: the nearest points of p, in order. Points
/// whose normals oppose are the two sides of a thin plate; `normal` may be empty.
inline Index twinOf(std::span<const Vec3> position, std::span<const Vec3> normal, Index p,
                    std::span<const Index> nearest) {
    if (nearest.size() < 4) return kNone;
    if (!normal.empty() && glm::dot(normal[p], normal[nearest[0]]) < 0.0) return kNone;
    const bool isTwin = glm::distance(position[p], position[nearest[0]]) <
                        kTwinShare * glm::distance(position[p], position[nearest[3]]);
    return isTwin ? nearest[0] : kNone;
}

}  // namespace se
