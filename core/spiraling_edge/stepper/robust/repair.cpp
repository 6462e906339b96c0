/// The half-edge structure of the repair: twins are found in a table of directed edges, sides of
/// edges with more than two triangles get none, and points with more than one fan are marked. O(t)
/// for t triangles.
#include "spiraling_edge/stepper/repair.h"

#include <array>

#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

void markPinched(RepairState& m) {
    std::vector<Index> sides(m.sideOf.size(), 0);
    for (const Triangle& t : m.triangles) {
        ++sides[t.a];
        ++sides[t.b];
        ++sides[t.c];
    }
    for (Index p = 0; p < m.sideOf.size(); ++p) {
        Index reached = 0;
        forEachSideOf(m, p, [&](HalfEdge) { ++reached; });
        m.pinched[p] = reached != sides[p];
    }
}

}  // namespace

RepairState beginRepair(std::size_t pointCount, const std::vector<Triangle>& triangles) {
    RepairState m;
    m.triangles = triangles;
    m.twin.assign(3 * triangles.size(), kNone);
    m.sideOf.assign(pointCount, kNone);
    m.pinched.assign(pointCount, false);
    EdgeTable table(pointCount);
    std::vector<bool> crowded(3 * triangles.size(), false);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::array<Index, 3> c{triangles[i].a, triangles[i].b, triangles[i].c};
        for (Index k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * i + k);
            const HalfEdge same = table.find(c[k], c[(k + 1) % 3]);
            const HalfEdge other = table.find(c[(k + 1) % 3], c[k]);
            m.sideOf[c[k]] = h;
            if (same != kNone) crowded[same] = crowded[h] = true;
            if (other != kNone && m.twin[other] == kNone) pair(m, h, other);
        }
        table.add(triangles[i]);
    }
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        if (crowded[h] && m.twin[h] != kNone) {
            m.twin[m.twin[h]] = kNone;
            m.twin[h] = kNone;
        }
        if (m.twin[h] != kNone && h < m.twin[h]) m.queue.push_back(h);
    }
    markPinched(m);
    return m;
}

}  // namespace se
