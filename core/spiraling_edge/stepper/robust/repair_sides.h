/// Navigation in a RepairState: sides, corners, twins; and its faults of pairs.
#pragma once

#include <algorithm>
#include <vector>

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

/// True if the triangle is flipped, or far off its normals and in conflict with one nearby.
inline bool isFaulty(const PointSet& points, const RepairState& m, Index t) {
    const Triangle& mine = m.triangles[t];
    if (isFlipped(points, mine)) return true;
    if (!isSteep(points, mine, kRough)) return false;
    std::vector<Index> near;
    for (const Index corner : {mine.a, mine.b, mine.c}) {
        for (const Index p : points.neighbors[corner])
            forEachSideOf(m, p, [&](HalfEdge side) { near.push_back(side / 3); });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return std::any_of(near.begin(), near.end(), [&](Index other) {
        return other != t && conflict(points, mine, m.triangles[other]);
    });
}

inline void pair(RepairState& m, HalfEdge a, HalfEdge b) {
    m.twin[a] = b;
    if (b != kNone) m.twin[b] = a;
}

}  // namespace se
