/// Triangles stay without gaps in their list, each side with its twin: whoever changes one, pairs
/// it. Conflicts are searched among triangles near by place, not by neighbor lists.
#include "spiraling_edge/stepper/robust/repair_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace se {

Index reachedSides(const RepairState& m, Index p) {
    Index reached = 0;
    forEachSideOf(m, p, [&](HalfEdge) { ++reached; });
    return reached;
}

void dropTriangle(RepairState& m, Index t) {
    const auto last = static_cast<Index>(m.triangles.size() - 1);
    m.conflictFlips.resize(m.triangles.size(), 0);
    m.conflictFlips.set(t, m.conflictFlips[last]);
    m.conflictFlips.pop_back();
    for (Index k = 0; k < 3; ++k) m.twin.set(3 * t + k, kNone);
    if (t != last) {
        m.triangles.set(t, m.triangles[last]);
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
    m.triangles.pop_back();
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
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        const Index p = cornerOf(m, h);
        if (m.pinched[p] != 0) sides.push_back({p, h});
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

namespace {

/// A ball about a place, as far as the farthest point in its list.
struct Ball {
    Vec3 center;
    double radius;
    bool holds(const Vec3& x) const {
        const Vec3 d = x - center;
        return glm::dot(d, d) <= radius * radius;
    }
};

Ball ballAt(const PointSet& points, Index p) {
    const Vec3& center = points.position[p];
    double farthestSq = 0.0;
    for (const Index q : points.neighbors[p]) {
        const Vec3 d = points.position[q] - center;
        farthestSq = std::max(farthestSq, glm::dot(d, d));
    }
    return {center, std::sqrt(farthestSq)};
}

/// A ball that holds all of these, with room for rounding.
Ball around(const std::vector<Ball>& balls) {
    Ball all{Vec3(0.0), 0.0};
    for (const Ball& ball : balls) all.center += ball.center / static_cast<double>(balls.size());
    for (const Ball& ball : balls)
        all.radius = std::max(all.radius, glm::distance(all.center, ball.center) + ball.radius);
    all.radius *= 1.0 + 1e-9;
    return all;
}

/// Begins a round in which NearMarks::isNew() holds once for each triangle.
void begin(NearMarks& marks, std::size_t triangles) {
    marks.round.resize(triangles, 0);
    if (++marks.current != 0) return;
    std::fill(marks.round.begin(), marks.round.end(), 0);
    marks.current = 1;
}

/// Calls visit(t) for each triangle near the places.
template <typename Visit>
void visitNear(const PointSet& points, RepairState& m, std::span<const Index> places,
               Visit&& visit) {
    if (m.treePoints != &points) {
        m.tree = std::make_shared<const PointTree>(points.position);
        m.treePoints = &points;
    }
    std::vector<Ball> balls;
    balls.reserve(places.size());
    for (const Index p : places) balls.push_back(ballAt(points, p));
    // One search for all, since the balls share most of their points.
    const Ball all = around(balls);
    begin(m.nearMarks, m.triangles.size());
    m.tree->within(all.center, all.radius, [&](Index q) {
        if (m.sideOf[q] == kNone) return;
        const bool isNear = std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
            return ball.holds(points.position[q]);
        });
        if (!isNear) return;
        forEachSideOf(m, q, [&](HalfEdge h) {
            if (std::exchange(m.nearMarks.round[h / 3], m.nearMarks.current) != m.nearMarks.current)
                visit(h / 3);
        });
    });
}

}  // namespace

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

std::vector<Index> trianglesNear(const PointSet& points, RepairState& m,
                                 std::span<const Index> places) {
    std::vector<Index> near;
    visitNear(points, m, places, [&](Index t) { near.push_back(t); });
    return near;
}

bool isFaulty(const PointSet& points, RepairState& m, Index t) {
    const Triangle& mine = m.triangles[t];
    if (shapeFaults(points, mine) >= kFlippedFault) return true;
    if (!isSteep(points, mine, kRough)) return false;
    const ShapedTriangle shaped(points, mine);
    bool found = false;
    visitNear(points, m, std::array{mine.a, mine.b, mine.c}, [&](Index other) {
        found = found || (other != t && conflict(points, shaped, m.triangles[other]));
    });
    return found;
}

}  // namespace se
