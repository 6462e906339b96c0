/// Conflicts are searched among triangles near by place, not by neighbor lists. Most pairs are told
/// apart by the sides of their corners in the planes of one triangle (edge_planes.h), found once
/// per point.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "spiraling_edge/geometry/edge_planes.h"
#include "spiraling_edge/stepper/robust/near_points.h"
#include "spiraling_edge/stepper/robust/near_triangles.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

/// The points near points, made when first needed.
const NearPoints& nearPointsOf(const PointSet& points, RepairState& m) {
    if (m.nearOf != &points) {
        m.near = std::make_shared<const NearPoints>(points);
        m.nearOf = &points;
    }
    return *m.near;
}

/// Begins a search: no mark holds.
void begin(NearMarks& marks, const RepairState& m) {
    marks.point.resize(m.sideOf.size());
    marks.triangle.resize(m.triangles.size(), 0);
    if (++marks.current != 0) return;
    std::fill(marks.point.begin(), marks.point.end(), NearMarks::PointMark{});
    std::fill(marks.triangle.begin(), marks.triangle.end(), 0);
    marks.current = 1;
}

/// Calls visit(t) for each triangle at a point, unless it came up before.
template <typename Visit>
void visitStar(RepairState& m, Index q, Visit&& visit) {
    NearMarks& marks = m.nearMarks;
    if (m.sideOf[q] == kNone || marks.point[q].round == marks.current) return;
    marks.point[q].round = marks.current;
    forEachSideOf(m, q, [&](HalfEdge h) {
        const Index t = h / 3;
        if (std::exchange(marks.triangle[t], marks.current) != marks.current) visit(t);
    });
}

/// One or two triangles, against all others at points.
class ConflictSearch {
  public:
    /// Leaves out the triangles `gone`.
    ConflictSearch(const PointSet& points, RepairState& m, std::span<const Triangle> mine,
                   std::array<Index, 2> gone)
        : points_(points), m_(m), gone_(gone) {
        begin(m.nearMarks, m);
        for (const Triangle& t : mine) {
            const ShapedTriangle& shaped = shaped_[count_].emplace(points, t);
            planes_[count_++].emplace(points, shaped);
        }
    }
    /// The number of conflicts with triangles at `q` that did not come up before; stops above
    /// `most`.
    int conflictsAt(Index q, int most) {
        const HalfEdge begin = m_.sideOf[q];
        if (begin == kNone) return 0;
        PointMark& mark = markOf(q);
        if (mark.visited != 0) return 0;
        mark.visited = 1;
        // As forEachSideOf(), where triangles that follow each other have a corner in common.
        int count = 0;
        HalfEdge h = begin;
        const PointMark* corner = &markOf(cornerOf(m_, following(h)));
        do {
            const HalfEdge last = preceding(h);
            const PointMark* next = &markOf(cornerOf(m_, last));
            count += conflictsWith(h, mark, *corner, *next);
            corner = next;
            h = m_.twin[last];
        } while (h != kNone && h != begin && count <= most);
        if (h != kNone) return count;
        corner = &markOf(cornerOf(m_, following(begin)));
        for (h = m_.twin[begin]; h != kNone && count <= most; h = m_.twin[h]) {
            h = following(h);
            const PointMark* next = &markOf(cornerOf(m_, following(h)));
            count += conflictsWith(h, mark, *corner, *next);
            corner = next;
        }
        return count;
    }

  private:
    using PointMark = NearMarks::PointMark;
    static constexpr unsigned kBits = 5;  ///< Of EdgePlanes::Side.

    PointMark& markOf(Index p) {
        PointMark& mark = m_.nearMarks.point[p];
        if (mark.round != m_.nearMarks.current) {
            unsigned sides = planes_[0]->sidesOf(p);
            if (count_ > 1) sides |= static_cast<unsigned>(planes_[1]->sidesOf(p)) << kBits;
            mark.begin(m_.nearMarks.current, sides);
        }
        return mark;
    }
    /// The conflicts with the triangle of side `h`, by the marks of its corners.
    int conflictsWith(HalfEdge h, const PointMark& q, const PointMark& r, const PointMark& s) {
        const unsigned common = q.value & r.value & s.value;
        const bool first = (common & EdgePlanes::kBeyondEdge) == 0;
        const bool second = count_ > 1 && ((common >> kBits) & EdgePlanes::kBeyondEdge) == 0;
        return first || second ? conflictsWith(h, first, second, r, s) : 0;
    }
    int conflictsWith(HalfEdge h, bool first, bool second, const PointMark& r,
                      const PointMark& s) const {
        const Index t = h / 3;
        // It came up at another corner, unless that has another fan.
        const auto hadTurn = [&](const PointMark& mark) {
            return mark.visited != 0 &&
                   !m_.pinched[static_cast<Index>(&mark - &m_.nearMarks.point[0])];
        };
        if (t == gone_[0] || t == gone_[1] || hadTurn(r) || hadTurn(s)) return 0;
        return (first && conflict(points_, *shaped_[0], m_.triangles[t]) ? 1 : 0) +
               (second && conflict(points_, *shaped_[1], m_.triangles[t]) ? 1 : 0);
    }

    const PointSet& points_;
    RepairState& m_;
    std::array<Index, 2> gone_;
    std::size_t count_ = 0;
    std::array<std::optional<ShapedTriangle>, 2> shaped_;
    std::array<std::optional<EdgePlanes>, 2> planes_;
};

/// True if one is in conflict with a triangle near the places.
bool isInConflictNear(const NearPoints& near, ConflictSearch& search,
                      std::span<const Index> places) {
    bool found = false;
    for (const Index p : places) {
        near.visitBall(p, [&](Index q) { found = found || search.conflictsAt(q, 0) > 0; });
        if (found) return true;
    }
    return false;
}

}  // namespace

std::vector<Index> trianglesNear(const PointSet& points, RepairState& m,
                                 std::span<const Index> places) {
    std::vector<Index> list;
    const NearPoints& near = nearPointsOf(points, m);
    begin(m.nearMarks, m);
    for (const Index p : places) {
        near.visitBall(p, [&](Index q) { visitStar(m, q, [&](Index t) { list.push_back(t); }); });
    }
    return list;
}

NearTriangles::NearTriangles(const PointSet& points, RepairState& m, std::span<const Index> list)
    : points_(points), m_(m), index_(list.begin(), list.end()), shaped_(list.size()) {
    begin(m.nearMarks, m);
    const auto placeOf = [&](Index p) {
        NearMarks::PointMark& mark = m.nearMarks.point[p];
        if (mark.round != m.nearMarks.current) {
            mark.begin(m.nearMarks.current, static_cast<std::uint32_t>(corner_.size()));
            corner_.push_back(p);
        }
        return Index{mark.value};
    };
    wide_.reserve(list.size());
    corners_.reserve(list.size());
    for (const Index t : list) {
        const Triangle& corners = m.triangles[t];
        const Box box = boxOf(points, corners);
        wide_.push_back(box.grown(mostReachIn(box)));
        corners_.push_back({placeOf(corners.a), placeOf(corners.b), placeOf(corners.c)});
    }
}

std::size_t NearTriangles::addTested(const Triangle& t) {
    const ShapedTriangle shaped(points_, t);
    tested_.push_back({shaped, shaped.box.grown(shaped.shape.reach), EdgePlanes(points_, shaped)});
    sides_.resize(tested_.size() * corner_.size(), kUnknown);
    return tested_.size() - 1;
}

bool isFaulty(const PointSet& points, RepairState& m, Index t) {
    const Triangle mine = m.triangles[t];
    if (clearlyFaces(points, mine, kRough)) return false;
    if (shapeFaults(points, mine) >= kFlippedFault) return true;
    if (!isSteep(points, mine, kRough)) return false;
    ConflictSearch search(points, m, {&mine, 1}, {t, t});
    return isInConflictNear(nearPointsOf(points, m), search, std::array{mine.a, mine.b, mine.c});
}

bool conflictNearby(const PointSet& points, RepairState& m, const std::array<Triangle, 2>& made,
                    std::array<Index, 2> gone, std::span<const Index> places) {
    ConflictSearch search(points, m, made, gone);
    return isInConflictNear(nearPointsOf(points, m), search, places);
}

int conflictsAt(const PointSet& points, RepairState& m, const std::array<Triangle, 2>& made,
                std::array<Index, 2> gone, std::span<const Index> places, int most) {
    ConflictSearch search(points, m, made, gone);
    int count = 0;
    for (const Index p : places) {
        if (count <= most) count += search.conflictsAt(p, most - count);
    }
    return count;
}

}  // namespace se
