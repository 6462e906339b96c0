/// Small meshes under repair, and checks of their neighbor relation.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/repair.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"
#include "support/clouds.h"

namespace se::test {

/// Points with normals up; every point lists all others.
inline PointSet flatPoints(std::vector<Vec3> position) {
    PointSet points = pointsAt(std::move(position));
    for (Index p = 0; p < points.size(); ++p) {
        Points list;
        for (Index q = 0; q < points.size(); ++q) {
            if (q != p) list.push_back(q);
        }
        std::stable_sort(list.begin(), list.end(), [&](Index a, Index b) {
            return glm::length(points.position[a] - points.position[p]) <
                   glm::length(points.position[b] - points.position[p]);
        });
        points.neighbors.append(list);
    }
    return points;
}

/// The first fault in the neighbor relation of the triangles; empty if there is none.
inline std::string adjacencyFault(const RepairState& m) {
    if (m.twin.size() != 3 * m.triangles.size()) return "sides and triangles do not match";
    std::vector<std::set<HalfEdge>> leaving(m.sideOf.size());
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        const Triangle& t = m.triangles[h / 3];
        if (t.a == t.b || t.b == t.c || t.c == t.a) return "a corner twice";
        leaving[cornerOf(m, h)].insert(h);
        const HalfEdge g = m.twin[h];
        if (g == kNone) continue;
        if (g >= m.twin.size()) return "a twin that is gone";
        if (m.twin[g] != h) return "a twin with another twin";
        if (cornerOf(m, g) != cornerOf(m, following(h)) ||
            cornerOf(m, h) != cornerOf(m, following(g))) {
            return "a twin with other ends";
        }
    }
    for (Index p = 0; p < m.sideOf.size(); ++p) {
        if (leaving[p].empty() != (m.sideOf[p] == kNone)) return "a point lost its side";
        if (m.sideOf[p] == kNone) continue;
        if (m.sideOf[p] >= m.twin.size() || cornerOf(m, m.sideOf[p]) != p) {
            return "a side that leaves another point";
        }
        std::set<HalfEdge> reached;
        forEachSideOf(m, p, [&](HalfEdge h) { reached.insert(h); });
        if (!m.pinched[p] && reached != leaving[p]) return "going round misses a side";
    }
    return {};
}
/// As adjacencyFault(), and that a side without a twin is at a border.
inline std::string manifoldFault(const RepairState& m) {
    std::set<std::pair<Index, Index>> sides;
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        if (!sides.insert({cornerOf(m, h), cornerOf(m, following(h))}).second) {
            return "an edge twice in one direction";
        }
    }
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        const bool other = sides.contains({cornerOf(m, following(h)), cornerOf(m, h)});
        if (other != (m.twin[h] != kNone)) return "a side without its twin";
    }
    return adjacencyFault(m);
}

/// Corners from the least on, sorted: equal for equal meshes.
inline std::set<std::array<Index, 3>> asSet(const Triangles& triangles) {
    std::set<std::array<Index, 3>> set;
    for (const Triangle& t : triangles) {
        std::array<Index, 3> c{t.a, t.b, t.c};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        set.insert(c);
    }
    return set;
}

/// A square of two triangles.
inline std::vector<Vec3> square() { return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}; }
inline const Triangles kSquare{{0, 1, 2}, {0, 2, 3}};

inline constexpr Index kAcross = 7;
inline Index gridPoint(Index column, Index row) { return row * kAcross + column; }

/// A flat grid of 7 x 7 points, one apart.
inline std::vector<Vec3> gridPoints() {
    std::vector<Vec3> position;
    for (Index row = 0; row < kAcross; ++row) {
        for (Index column = 0; column < kAcross; ++column)
            position.emplace_back(static_cast<double>(column), static_cast<double>(row), 0.0);
    }
    return position;
}

/// Its triangles, two a square, without those at the points `gone`.
inline Triangles gridWithout(const Points& gone) {
    Triangles triangles;
    const auto add = [&](const Triangle& t) {
        const bool isGone = std::any_of(gone.begin(), gone.end(),
                                        [&](Index p) { return t.a == p || t.b == p || t.c == p; });
        if (!isGone) triangles.push_back(t);
    };
    for (Index row = 0; row + 1 < kAcross; ++row) {
        for (Index column = 0; column + 1 < kAcross; ++column) {
            const Index p = gridPoint(column, row);
            add({p, p + 1, p + kAcross + 1});
            add({p, p + kAcross + 1, p + kAcross});
        }
    }
    return triangles;
}

/// All points that are inserted, in order; the state is checked after each.
inline Points reinsertAll(const PointSet& points, RepairState& m) {
    Points in;
    while (const auto step = reinsertNext(points, m)) {
        in.push_back(step->point);
        CHECK(manifoldFault(m) == "");
    }
    return in;
}

inline std::size_t flippedIn(const PointSet& points, const Triangles& triangles) {
    return static_cast<std::size_t>(
        std::count_if(triangles.begin(), triangles.end(),
                      [&](const Triangle& t) { return isFlipped(points, t); }));
}

}  // namespace se::test
