/// Navigation in a RepairState: sides, corners, twins.
#pragma once

#include <algorithm>
#include <array>
#include <span>
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

/// The corners of the triangle of a side, from the one that the side leaves on.
inline Triangle cornersFrom(const RepairState& m, HalfEdge h) {
    const Triangle& t = m.triangles[h / 3];
    const HalfEdge k = h % 3;
    if (k == 0) return t;
    return k == 1 ? Triangle{t.b, t.c, t.a} : Triangle{t.c, t.a, t.b};
}

/// Calls visit(side) for the sides of one fan that leave its point, in both directions from
/// `begin`.
template <typename Visit>
void forEachSideFrom(const RepairState& m, HalfEdge begin, Visit&& visit) {
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

/// Calls visit(side) for every side that leaves the point, in the fan of sideOf.
template <typename Visit>
void forEachSideOf(const RepairState& m, Index point, Visit&& visit) {
    forEachSideFrom(m, m.sideOf[point], visit);
}

inline bool joined(const RepairState& m, Index u, Index v) {
    bool found = false;
    forEachSideOf(m, u, [&](HalfEdge h) {
        found = found || cornerOf(m, following(h)) == v || cornerOf(m, preceding(h)) == v;
    });
    return found;
}

/// The number of sides that leave a point, in the fan of RepairState::sideOf.
Index reachedSides(const RepairState& m, Index p);

/// Sets RepairState::pinchedSides, and unmarks points that are no longer pinched. O(t).
void listPinched(RepairState& m);

/// The sides that leave a pinched point, after listPinched().
inline std::span<const PinchedSide> sidesOfPinched(const RepairState& m, Index point) {
    const std::vector<PinchedSide>& all = m.pinchedSides;
    const auto first =
        std::lower_bound(all.begin(), all.end(), point,
                         [](const PinchedSide& side, Index p) { return side.point < p; });
    auto end = first;
    while (end != all.end() && end->point == point) ++end;
    return {all.data() + (first - all.begin()), static_cast<std::size_t>(end - first)};
}

inline bool isAnyPinched(const RepairState& m, std::span<const Index> points) {
    return std::any_of(points.begin(), points.end(), [&](Index p) { return m.pinched[p] != 0; });
}

/// The corners of these triangles, ascending.
std::vector<Index> cornersOf(const RepairState& m, std::span<const Index> list);

/// The triangles that are connected to this one by edges, in the order they are reached; the search
/// ends once `limit` are found, or up to two more. O(limit).
std::vector<Index> patchAt(const RepairState& m, Index t, std::size_t limit);

/// Stores a triangle in the place of `gone[i]`, or at the end of the list if there are fewer;
/// returns its first side. It has no twins yet.
HalfEdge putTriangle(RepairState& m, std::span<const Index> gone, std::size_t i, const Triangle& t);

/// Removes a triangle; the last one moves to its place, so that the list has no gaps.
void dropTriangle(RepairState& m, Index t);
void dropTriangles(RepairState& m, std::vector<Index> list);

/// A triangle of the mesh, other than those `gone`, that one is in conflict with; kNone if there is
/// none. Which of several is not specified.
Index firstConflict(const PointSet& points, RepairState& m, const Triangle& t,
                    std::span<const Index> gone);

/// All triangles of the mesh that one is in conflict with, ascending.
std::vector<Index> conflictsOf(const PointSet& points, RepairState& m, const Triangle& t);

/// The conflicts of triangles that take the place of two others; counted until they are more than
/// `most`.
int countConflicts(const PointSet& points, RepairState& m, std::span<const Triangle> made,
                   std::array<Index, 2> gone, int most);

/// True if the triangle is so far off the normal of a corner that it may be in conflict.
bool isRough(const PointSet& points, const RepairState& m, Index t);

/// The direction and shape of a triangle as it is now.
FacingTriangle facingTriangle(const PointSet& points, const Triangle& t);

/// True if RepairState::sound tells that isSound(), which takes no search then.
inline bool isKnownAsSound(const RepairState& m, Index t) {
    return t < m.sound.size() && m.sound[t] != 0;
}

/// True if the triangle is neither flipped nor in conflict, or was found so once since it got these
/// corners (RepairState::sound).
bool isSound(const PointSet& points, RepairState& m, Index t);

/// True if the triangle is rough and not sound; found out once for a triangle that is not.
bool isFaulty(const PointSet& points, RepairState& m, Index t);

/// Asks isSound() of all triangles that are rough or beside a rough one, on all cores; the others
/// count as sound.
void findSound(const PointSet& points, RepairState& m);

/// The cosine of 1.1 degrees. Triangles with a smaller angle, almost without width, are worse than
/// a hole or a point that is left out.
inline constexpr double kThin = 0.9998;

/// Triangles farther than 25 degrees off the normal of a corner may be in conflict with others.
inline constexpr double kRough = 0.9;

inline void pair(RepairState& m, HalfEdge a, HalfEdge b) {
    m.twin.set(a, b);
    if (b != kNone) m.twin.set(b, a);
}

}  // namespace se
