/// Triangles stay without gaps in their list, each side with its twin: code that changes a triangle
/// must pair its sides.
#include "spiraling_edge/stepper/robust/repair_sides.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace se {

Index reachedSides(const RepairState& m, Index p) {
    Index reached = 0;
    forEachSideOf(m, p, [&](HalfEdge) { ++reached; });
    return reached;
}

HalfEdge putTriangle(RepairState& m, std::span<const Index> gone, std::size_t i,
                     const Triangle& t) {
    const auto place = i < gone.size() ? gone[i] : static_cast<Index>(m.triangles.size());
    if (place == m.triangles.size()) m.twin.resize(m.twin.size() + 3, kNone);
    m.setTriangle(place, t);
    for (HalfEdge h = 3 * place; h < 3 * place + 3; ++h) m.twin.set(h, kNone);
    return 3 * place;
}

void dropTriangle(RepairState& m, Index t) {
    const auto last = static_cast<Index>(m.triangles.size() - 1);
    m.conflictFlips.resize(m.triangles.size(), 0);
    m.conflictFlips.set(t, m.conflictFlips[last]);
    m.conflictFlips.pop_back();
    for (Index k = 0; k < 3; ++k) m.twin.set(3 * t + k, kNone);
    if (t != last) {
        m.setTriangle(t, m.triangles[last]);
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge from = 3 * last + k;
            const HalfEdge to = 3 * t + k;
            pair(m, to, m.twin[from]);
            const Index corner = cornerOf(m, to);
            if (m.sideOf[corner] == from) m.sideOf.set(corner, to);
            for (const PinchedSide& side : sidesOfPinched(m, corner)) {
                if (side.leaving != from) continue;
                m.pinchedSides.set(static_cast<std::size_t>(&side - &m.pinchedSides[0]),
                                   {corner, to});
            }
            m.queue.push_back(to);
        }
    }
    m.popTriangle();
    m.twin.resize(3 * std::size_t{last});
}

void dropTriangles(RepairState& m, std::vector<Index> list) {
    // The highest place first, so that no other one of the list moves.
    std::sort(list.begin(), list.end());
    for (auto t = list.rbegin(); t != list.rend(); ++t) dropTriangle(m, *t);
}

void listPinched(RepairState& m) {
    // Most meshes have no pinched point.
    if (std::find(m.pinched.begin(), m.pinched.end(), 1) == m.pinched.end())
        return m.pinchedSides.assign({});
    std::vector<PinchedSide> sides;
    for (Index t = 0; t < m.triangles.size(); ++t) {
        const Triangle& c = m.triangles[t];
        if ((m.pinched[c.a] | m.pinched[c.b] | m.pinched[c.c]) == 0) continue;
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
            const Index p = cornerOf(m, h);
            if (m.pinched[p] != 0) sides.push_back({p, h});
        }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const PinchedSide& a, const PinchedSide& b) { return a.point < b.point; });
    m.pinchedSides.assign(sides);
    for (Index p = 0; p < m.sideOf.size(); ++p) {
        if (m.pinched[p]) m.pinched.set(p, reachedSides(m, p) != sidesOfPinched(m, p).size());
    }
    std::erase_if(sides, [&](const PinchedSide& side) { return m.pinched[side.point] == 0; });
    m.pinchedSides.assign(sides);
}

std::vector<Index> cornersOf(const RepairState& m, std::span<const Index> list) {
    std::vector<Index> corners;
    for (const Index t : list) {
        const Triangle& each = m.triangles[t];
        corners.insert(corners.end(), {each.a, each.b, each.c});
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::vector<Index> patchAt(const RepairState& m, Index t, std::size_t limit) {
    std::vector<Index> patch{t};
    std::unordered_set<Index> seen{t};
    for (std::size_t i = 0; i < patch.size() && patch.size() < limit; ++i) {
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge other = m.twin[3 * patch[i] + k];
            if (other != kNone && seen.insert(other / 3).second) patch.push_back(other / 3);
        }
    }
    return patch;
}

}  // namespace se
