/// Axis-aligned boxes, to skip exact tests of shapes that are apart.
#pragma once

#include <glm/common.hpp>

#include "spiraling_edge/points/point_set.h"

namespace se {

struct Box {
    Vec3 low, high;

    explicit Box(const Vec3& p) : low(p), high(p) {}
    void add(const Vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    bool meets(const Box& o) const {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
               low.z <= o.high.z && o.low.z <= high.z;
    }
};

inline Box boxOf(const PointSet& points, const Triangle& t) {
    Box box(points.position[t.a]);
    box.add(points.position[t.b]);
    box.add(points.position[t.c]);
    return box;
}

}  // namespace se
