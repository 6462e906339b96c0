/// RobustRules::removeFolded: a point at a faulty triangle is taken out and the hole of its
/// triangles closed without a fault; RobustRules::reinsert may put it back where it fits. The hole
/// is filled by dynamic programming over its ring, O(n^3) for the at most 14 points of it.
#include <algorithm>
#include <array>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

/// Largest number of triangles about a point that is taken out.
constexpr std::size_t kMaxSides = 14;

/// The triangles about a point, and the sides opposite to it in counterclockwise order.
struct Star {
    std::vector<HalfEdge> rim;  ///< Sides opposite to the point; triangles are rim[i] / 3.
    std::vector<Index> ring;    ///< Points: where rim[i] begins.
};

/// Empty unless the triangles form one closed fan of 4 to kMaxSides, with no pinched point.
Star starOf(const RepairState& m, Index x) {
    Star star;
    HalfEdge h = m.sideOf[x];
    if (h == kNone || m.pinched[x]) return {};
    const HalfEdge begin = h;
    do {
        star.rim.push_back(following(h));
        star.ring.push_back(cornerOf(m, following(h)));
        h = m.twin[preceding(h)];
    } while (h != kNone && h != begin && star.rim.size() <= kMaxSides);
    if (h != begin || star.rim.size() < 4 || star.rim.size() > kMaxSides) return {};
    // joined() sees only one fan of a pinched point.
    if (std::any_of(star.ring.begin(), star.ring.end(), [&](Index p) { return m.pinched[p]; }))
        return {};
    return star;
}

/// One triangle of a filling: positions on the ring, ascending.
using RingTriangle = std::array<std::size_t, 3>;
using Filling = std::vector<RingTriangle>;

/// Best triangulation of the ring of a star: no triangle is flipped, no new edge exists
/// already, and the least angle is as large as possible. Dynamic programming over sub-polygons.
class RingFill {
  public:
    RingFill(const PointSet& points, const RepairState& m, const Star& star)
        : points_(points), m_(m), ring_(star.ring), count_(star.ring.size()) {}

    /// The best filling; empty if there is none.
    Filling find() {
        for (std::size_t span = 2; span < count_; ++span) {
            for (std::size_t i = 0; i + span < count_; ++i) fillSpan(i, i + span);
        }
        Filling found;
        if (cost_[0][count_ - 1] < kNoWay) collect(0, count_ - 1, found);
        return found;
    }

  private:
    static constexpr double kNoWay = 2.0;

    void fillSpan(std::size_t i, std::size_t k) {
        cost_[i][k] = kNoWay;
        const bool closing = i == 0 && k + 1 == count_;
        if (!closing && joined(m_, ring_[i], ring_[k])) return;
        for (std::size_t j = i + 1; j < k; ++j) {
            const Triangle t{ring_[i], ring_[j], ring_[k]};
            if (shapeFaults(points_, t) >= kFlippedFault) continue;
            const double cost =
                std::max(leastAngleCosine(points_, t), std::max(costOf(i, j), costOf(j, k)));
            if (cost >= cost_[i][k]) continue;
            cost_[i][k] = cost;
            middle_[i][k] = j;
        }
    }
    double costOf(std::size_t i, std::size_t k) const { return k == i + 1 ? -1.0 : cost_[i][k]; }
    void collect(std::size_t i, std::size_t k, Filling& found) const {
        if (k == i + 1) return;
        const std::size_t j = middle_[i][k];
        found.push_back({i, j, k});
        collect(i, j, found);
        collect(j, k, found);
    }

    const PointSet& points_;
    const RepairState& m_;
    const std::vector<Index>& ring_;
    std::size_t count_;
    std::array<std::array<double, kMaxSides>, kMaxSides> cost_{};
    std::array<std::array<std::size_t, kMaxSides>, kMaxSides> middle_{};
};

Triangle triangleOf(const Star& star, const RingTriangle& t) {
    return {star.ring[t[0]], star.ring[t[1]], star.ring[t[2]]};
}

/// True if two triangles of the filling at a common edge are folded onto one another.
bool foldsInside(const PointSet& points, const Star& star, const Filling& filling) {
    for (const RingTriangle& t : filling) {
        for (const RingTriangle& other : filling) {
            const auto common = std::count_if(t.begin(), t.end(), [&](std::size_t p) {
                return std::find(other.begin(), other.end(), p) != other.end();
            });
            if (common == 2 && folded(points, triangleOf(star, t), triangleOf(star, other))) {
                return true;
            }
        }
    }
    return false;
}

/// True if a triangle of the filling is folded onto a neighbor of the star.
bool foldsOutside(const PointSet& points, const RepairState& m, const Star& star,
                  const Filling& filling) {
    for (const RingTriangle& t : filling) {
        for (std::size_t k = 0; k < 3; ++k) {
            if ((t[k] + 1) % star.ring.size() != t[(k + 1) % 3]) continue;
            const HalfEdge outer = m.twin[star.rim[t[k]]];
            if (outer != kNone && folded(points, triangleOf(star, t), m.triangles[outer / 3])) {
                return true;
            }
        }
    }
    return false;
}

/// True if a triangle of the filling is in conflict with one near the ring that is not of the star.
bool isInConflict(const PointSet& points, const RepairState& m, const Star& star,
                  const Filling& filling) {
    bool meets = false;
    for (const Index p : star.ring) {
        forEachSideOf(m, p, [&](HalfEdge side) {
            const bool own = std::any_of(star.rim.begin(), star.rim.end(),
                                         [&](HalfEdge r) { return r / 3 == side / 3; });
            if (own || meets) return;
            meets = std::any_of(filling.begin(), filling.end(), [&](const RingTriangle& t) {
                return conflict(points, triangleOf(star, t), m.triangles[side / 3]);
            });
        });
    }
    return meets;
}

/// Moves the last triangle into the place of `t`, so that the list has no gaps.
void dropTriangle(RepairState& m, Index t) {
    const auto last = static_cast<Index>(m.triangles.size() - 1);
    m.conflictFlips.resize(m.triangles.size(), 0);
    m.conflictFlips[t] = m.conflictFlips[last];
    m.conflictFlips.pop_back();
    for (Index k = 0; k < 3; ++k) m.twin[3 * t + k] = kNone;
    if (t != last) {
        m.triangles[t] = m.triangles[last];
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge from = 3 * last + k;
            const HalfEdge to = 3 * t + k;
            pair(m, to, m.twin[from]);
            if (m.sideOf[cornerOf(m, to)] == from) m.sideOf[cornerOf(m, to)] = to;
            m.queue.push_back(to);
        }
    }
    m.triangles.pop_back();
    m.twin.resize(3 * std::size_t{last});
}

void replaceStar(RepairState& m, const Star& star, const Filling& filling, Index x) {
    const std::size_t count = star.ring.size();
    std::vector<HalfEdge> outer(count);
    for (std::size_t i = 0; i < count; ++i) outer[i] = m.twin[star.rim[i]];
    // Sides from ring place to ring place, to find each one's twin among the new triangles.
    std::array<std::array<HalfEdge, kMaxSides>, kMaxSides> side{};
    for (auto& row : side) row.fill(kNone);
    for (std::size_t i = 0; i < filling.size(); ++i) {
        const Index place = star.rim[i] / 3;
        m.triangles[place] = triangleOf(star, filling[i]);
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge h = 3 * place + k;
            m.twin[h] = kNone;
            side[filling[i][k]][filling[i][(k + 1) % 3]] = h;
            m.sideOf[star.ring[filling[i][k]]] = h;
            m.queue.push_back(h);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            if (side[i][k] == kNone) continue;
            pair(m, side[i][k], (i + 1) % count == k ? outer[i] : side[k][i]);
        }
    }
    m.sideOf[x] = kNone;
    // Two triangles fewer; the higher place first, so that neither moves the other.
    const Index a = star.rim[count - 1] / 3;
    const Index b = star.rim[count - 2] / 3;
    dropTriangle(m, std::max(a, b));
    dropTriangle(m, std::min(a, b));
}

/// True if the triangle is flipped, or far off its normals and in conflict with one nearby.
bool isFaulty(const PointSet& points, const RepairState& m, Index t) {
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

bool takeOut(const PointSet& points, RepairState& m, Index x) {
    const Star star = starOf(m, x);
    if (star.ring.empty()) return false;
    const Filling filling = RingFill(points, m, star).find();
    if (filling.empty() || foldsInside(points, star, filling) ||
        foldsOutside(points, m, star, filling) || isInConflict(points, m, star, filling)) {
        return false;
    }
    replaceStar(m, star, filling, x);
    return true;
}

}  // namespace

std::optional<RemoveFoldedEvidence> removeFoldedPoint(const PointSet& points, RepairState& m) {
    for (; m.nextTriangle < m.triangles.size(); ++m.nextTriangle) {
        const Index t = m.nextTriangle;
        if (!isFaulty(points, m, t)) continue;
        std::vector<Index> near{m.triangles[t].a, m.triangles[t].b, m.triangles[t].c};
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge other = m.twin[3 * t + k];
            if (other != kNone) near.push_back(cornerOf(m, preceding(other)));
        }
        for (const Index x : near) {
            if (!takeOut(points, m, x)) continue;
            ++m.takenOut;
            return RemoveFoldedEvidence{x};
        }
    }
    return std::nullopt;
}

}  // namespace se
