#include "ring_shape.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace se {

RingShape shapeOfRing(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    const Index head = rings.head(rings.active());
    const Vec3 origin = context.positionAt(head);
    RingShape shape;
    shape.length = rings.length(rings.active());
    Vec3 area(0.0);
    Vec3 normal(0.0);
    Index entry = head;
    do {
        const Vec3 from = context.positionAt(entry) - origin;
        normal += context.normalAt(entry);
        entry = rings.next(entry);
        const Vec3 to = context.positionAt(entry) - origin;
        area += 0.5 * glm::cross(from, to);
        shape.perimeter += std::sqrt(glm::dot(to - from, to - from));
    } while (entry != head);
    shape.area = std::sqrt(glm::dot(area, area));
    shape.turnsRoundPatch = glm::dot(area, normal) > 0.0;
    return shape;
}

}  // namespace se
