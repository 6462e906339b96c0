#include "spiraling_edge/geometry/loop_shape.h"

#include <cassert>

namespace se {

LoopShape shapeOfLoop(std::span<const Vec3> position, std::span<const Vec3> normal,
                      std::span<const Index> loop) {
    assert(!loop.empty());
    const Vec3 origin = position[loop.front()];
    ShapeSum sum;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index following = loop[i + 1 < loop.size() ? i + 1 : 0];
        sum.add(position[loop[i]] - origin, normal[loop[i]], position[following] - origin);
    }
    return sum.shape();
}

}  // namespace se
