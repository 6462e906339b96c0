/// Navigation in a RepairState: sides, corners, twins.
#pragma once

#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/repair.h"

namespace se {

inline HalfEdge following(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline HalfEdge preceding(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

inline Index cornerOf(const RepairState& m, HalfEdge h) {
    const Triangle& t = m.triangles[h / 3];
    return h % 3 == 0 ? t.a : (h % 3 == 1 ? t.b : t.c);
}

/// Calls visit(side) for every side that leaves the point, around it in both directions from
/// sideOf.
template <typename Visit>
void forEachSideOf(const RepairState& m, Index point, Visit&& visit) {
    const HalfEdge begin = m.sideOf[point];
    if (begin == kNone) return;
    HalfEdge h = begin;
    do {
        visit(h);
        h = m.twin[preceding(h)];  // Counterclockwise.
    } while (h != kNone && h != begin);
    if (h == begin) return;
    for (h = m.twin[begin]; h != kNone; h = m.twin[h]) {
        h = following(h);  // Clockwise, from a border.
        visit(h);
    }
}

inline bool joined(const RepairState& m, Index u, Index v) {
    bool found = false;
    forEachSideOf(m, u, [&](HalfEdge h) {
        found = found || cornerOf(m, following(h)) == v || cornerOf(m, preceding(h)) == v;
    });
    return found;
}

/// Triangles farther than 25 degrees off the normal of a corner may be in conflict with others.
inline constexpr double kRough = 0.9;

inline void pair(RepairState& m, HalfEdge a, HalfEdge b) {
    m.twin[a] = b;
    if (b != kNone) m.twin[b] = a;
}

}  // namespace se
