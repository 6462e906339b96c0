/// Inputs without a surface.
#pragma once

#include <algorithm>
#include <vector>

#include "spiraling_edge/points/point_set.h"
#include "support/oracles.h"

namespace se::test {

/// Random inputs: points in a cube, lists of random others, random normals and types.
inline PointSet randomPoints(std::uint64_t seed) {
    Random random(seed);
    PointSet points;
    const std::size_t count = 20 + random.below(40);
    const std::size_t longest = 4 + random.below(16);
    const bool flat = random.below(3) == 0;
    const bool typed = random.below(2) == 0;
    for (std::size_t p = 0; p < count; ++p) {
        Vec3 x = random.inCube();
        if (flat) x.z = 0;
        points.position.push_back(x);
        points.normal.push_back(flat ? Vec3(0, 0, 1) : random.direction());
        const bool wall = typed && random.below(3) == 0;
        const auto faces = static_cast<std::uint8_t>(random.below(64));
        points.type.push_back(wall ? withCornerBit(faces) : std::uint8_t{kInterior});
    }
    for (Index p = 0; p < count; ++p) {
        std::vector<Index> list;
        const std::size_t length = random.below(longest);
        while (list.size() < length) {
            const auto q = static_cast<Index>(random.below(count));
            const bool known = std::find(list.begin(), list.end(), q) != list.end();
            if (q == p || known) break;
            list.push_back(q);
        }
        std::sort(list.begin(), list.end(), [&](Index a, Index b) {
            return glm::length(points.position[a] - points.position[p]) <
                   glm::length(points.position[b] - points.position[p]);
        });
        points.neighbors.append(list);
    }
    return points;
}

}  // namespace se::test
