#include "ring_shape.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace se {
namespace {

/// Adds up a loop point by point.
class ShapeSum {
  public:
    /// From a point with its normal to the one behind it, both relative to a point of the loop.
    void add(const Vec3& from, const Vec3& normal, const Vec3& to) {
        ++shape_.length;
        normal_ += normal;
        area_ += 0.5 * glm::cross(from, to);
        shape_.perimeter += std::sqrt(glm::dot(to - from, to - from));
    }
    RingShape shape() const {
        RingShape shape = shape_;
        shape.area = std::sqrt(glm::dot(area_, area_));
        shape.turnsRoundPatch = glm::dot(area_, normal_) > 0.0;
        return shape;
    }

  private:
    RingShape shape_;
    Vec3 area_{0.0}, normal_{0.0};
};

}  // namespace

RingShape shapeOfRing(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const Index head = rings.head(rings.active());
    const Vec3 origin = context.positionAt(head);
    ShapeSum sum;
    Index entry = head;
    do {
        const Index following = rings.next(entry);
        sum.add(context.positionAt(entry) - origin, context.normalAt(entry),
                context.positionAt(following) - origin);
        entry = following;
    } while (entry != head);
    return sum.shape();
}

RingShape shapeOfLoop(std::span<const Vec3> position, std::span<const Vec3> normal,
                      std::span<const Index> loop) {
    const Vec3 origin = position[loop.front()];
    ShapeSum sum;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index following = loop[i + 1 < loop.size() ? i + 1 : 0];
        sum.add(position[loop[i]] - origin, normal[loop[i]], position[following] - origin);
    }
    return sum.shape();
}

}  // namespace se
