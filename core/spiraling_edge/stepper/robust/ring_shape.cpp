#include "spiraling_edge/stepper/robust/ring_shape.h"

#include <cassert>

namespace se {

RingShape shapeOfRing(const StepContext& context) {
    const EdgeRings& rings = context.state.rings;
    assert(rings.active() != kNone);
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

}  // namespace se
