/// RobustRules::reinsert, at the end: a point that fits nowhere without a fault takes the place
/// where the new triangles have at most one fault more than those they replace, since the point
/// itself, in no triangle, is one. Of several places the one with the fewest faults is taken, then
/// the one with the best angles. A new triangle is never flipped.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/stepper/robust/hole_filling.h"
#include "spiraling_edge/stepper/robust/near_triangles.h"

namespace se {
namespace {

/// Largest number of triangles that make room for a point.
constexpr std::size_t kMaxCheapGone = 3;
constexpr std::size_t kMaxCheapMade = kMaxCheapGone + 2;
/// The most faults that a place may add: those of a point in no triangle.
constexpr int kMaxAdded = 1;
/// A new triangle with this many faults is not counted to the end.
constexpr int kTooMany = 8;

/// The faults of a pair of triangles, by the classes of mesh/faults.h.
int faultsOfPair(const PointSet& points, const ShapedTriangle& a, const ShapedTriangle& b) {
    if (!conflict(points, a, b)) return 0;
    const bool meet =
        a.box.meets(b.box) && trianglesShareMore(points.position, a.triangle, b.triangle);
    const bool layer = isSecondLayer(points, a.triangle, a.shape, b.triangle, b.shape);
    return (meet ? 1 : 0) + (layer ? 1 : 0);
}

/// A triangle with its faults, as far as they were counted.
struct Counted {
    std::size_t number = 0;  ///< Among those tested in NearTriangles.
    int own = 0;             ///< Of its shape.
    /// With others of the mesh: their indices and the number of faults.
    std::vector<std::pair<Index, int>> pairs{};
    int inPairs = 0;         ///< The sum of those.
    std::size_t tested = 0;  ///< Number of triangles of NearTriangles that were tested.
    HalfEdge outer = kNone;  ///< The side that `foldedAt` is known for.
    bool foldedAt = false;   ///< It is folded onto the triangle of that side.
};

/// The triangles that a point makes with the sides of a ring, or with one side of the border.
struct CheapPlace {
    HoleRing ring;
    bool beside = false;  ///< At the border: one triangle, at the first side of the ring.

    std::size_t size() const { return beside ? 1 : ring.size(); }
    Triangle triangle(std::size_t i, Index x) const {
        return {ring.points[i], ring.points[(i + 1) % ring.size()], x};
    }
};

CheapPlace insideOf(const RepairState& m, Index t) {
    const Triangle& old = m.triangles[t];
    return {{{old.a, old.b, old.c}, {m.twin[3 * t], m.twin[3 * t + 1], m.twin[3 * t + 2]}, {t}}};
}

CheapPlace besideOf(const RepairState& m, HalfEdge border) {
    return {{{cornerOf(m, following(border)), cornerOf(m, border)}, {border, kNone}, {}}, true};
}

/// The triangles near a point, ascending: what is counted depends on their order.
std::vector<Index> nearAscending(const PointSet& points, RepairState& m, Index x) {
    std::vector<Index> list = trianglesNear(points, m, std::array{x});
    std::sort(list.begin(), list.end());
    return list;
}

/// Finds the place for one point that adds the fewest faults.
class CheapestPlace {
  public:
    CheapestPlace(const PointSet& points, RepairState& m, Index x)
        : points_(points), m_(m), x_(x), near_(points, m, nearAscending(points, m, x)) {}

    std::optional<CheapPlace> find() {
        std::vector<Index> begins;
        for (const Index p : points_.neighbors[x_])
            forEachSideOf(m_, p, [&](HalfEdge side) { begins.push_back(side / 3); });
        std::sort(begins.begin(), begins.end());
        begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
        for (const Index t : begins) {
            const Triangle& old = m_.triangles[t];
            if (m_.pinched[old.a] || m_.pinched[old.b] || m_.pinched[old.c]) continue;
            consider(insideOf(m_, t));
            for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
                if (m_.twin[h] == kNone) consider(besideOf(m_, h));
            }
        }
        return best_;
    }

  private:
    /// Counts the faults with the next triangle near that has some; false if there is none.
    bool countNext(Counted& t, Index itself) {
        while (t.tested < near_.size()) {
            const std::size_t i = near_.nextDoubtful(t.number, t.tested);
            t.tested = i + 1;
            if (i == near_.size() || near_.index(i) == itself) continue;
            const int faults = faultsOfPair(points_, near_.tested(t.number), near_.shaped(i));
            if (faults == 0) continue;
            t.pairs.emplace_back(near_.index(i), faults);
            t.inPairs += faults;
            return true;
        }
        return false;
    }
    const ShapedTriangle& shapedOf(const Counted& t) const { return near_.tested(t.number); }
    /// A new triangle; the reference stays valid.
    Counted& made(const Triangle& t) {
        const auto [found, isNew] = made_.try_emplace(std::uint64_t{t.a} << 32U | t.b);
        Counted& counted = found->second;
        if (!isNew) return counted;
        counted.number = near_.addTested(t);
        const bool isBad =
            shapeFaults(points_, t) >= kFlippedFault || leastAngleCosine(points_, t) >= kThin;
        counted.own = isBad ? kTooMany : 0;
        return counted;
    }
    const Counted& old(Index t) {
        const Triangle& corners = m_.triangles[t];
        const auto [found, isNew] = old_.try_emplace(t);
        Counted& counted = found->second;
        if (!isNew) return counted;
        counted.number = near_.addTested(corners);
        counted.own = shapeFaults(points_, corners) >= kFlippedFault ? 1 : 0;
        while (counted.own + counted.inPairs < kTooMany && countNext(counted, t)) continue;
        return counted;
    }

    /// The faults of the triangles that a place replaces.
    int faultsOfGone(const HoleRing& ring) {
        int sum = 0;
        for (const Index t : ring.gone) {
            const Counted& each = old(t);
            sum += each.own;
            for (const auto& [other, faults] : each.pairs) {
                if (other > t || !isGone(ring, other)) sum += faults;
            }
        }
        return sum;
    }
    /// The faults of a new triangle with those that stay, counted until they are more than `most`.
    int faultsWithOld(const CheapPlace& place, std::size_t i, int most) {
        Counted& t = made(place.triangle(i, x_));
        int faults = t.own + (isFolded(t, place.ring.outer[i]) ? 1 : 0);
        for (const auto& [other, count] : t.pairs) {
            if (!isGone(place.ring, other)) faults += count;
        }
        while (faults <= most && countNext(t, kNone)) {
            if (!isGone(place.ring, t.pairs.back().first)) faults += t.pairs.back().second;
            // With so many it stays out, whatever goes.
            if (t.inPairs < kTooMany) continue;
            t.own = kTooMany;
            return kTooMany;
        }
        return faults;
    }
    bool isFolded(Counted& t, HalfEdge outer) {
        if (outer == kNone) return false;
        if (t.outer != outer) {
            t.outer = outer;
            t.foldedAt = folded(points_, shapedOf(t).triangle, m_.triangles[outer / 3]);
        }
        return t.foldedAt;
    }
    int faultsAmongNew(const CheapPlace& place) {
        int sum = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const ShapedTriangle a = shapedOf(made(place.triangle(i, x_)));
            for (std::size_t k = i + 1; k < place.size(); ++k) {
                const ShapedTriangle& b = shapedOf(made(place.triangle(k, x_)));
                sum += faultsOfPair(points_, a, b);
                const bool share = k == i + 1 || (i == 0 && k + 1 == place.size());
                sum += share && folded(points_, a.triangle, b.triangle) ? 1 : 0;
            }
        }
        return sum;
    }
    double worstAngle(const CheapPlace& place) const {
        double worst = -1.0;
        for (std::size_t i = 0; i < place.size(); ++i)
            worst = std::max(worst, leastAngleCosine(points_, place.triangle(i, x_)));
        return worst;
    }

    /// Counts a place, and those that are wider by one triangle across a side with a fault.
    void consider(const CheapPlace& place) {
        if (!place.beside && !isNew(place.ring.gone)) return;
        const int gone = faultsOfGone(place.ring);
        const int most = std::min(kMaxAdded + gone, kTooMany - 1);
        const bool mayWiden = !place.beside && place.ring.gone.size() < kMaxCheapGone;
        std::array<bool, kMaxCheapMade> isFaulty{};
        int sum = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            // Of a place with too many faults it matters only which triangles have some.
            if (sum > most && !mayWiden) return;
            const int faults = faultsWithOld(place, i, std::max(most - sum, 0));
            isFaulty[i] = faults > 0;
            sum += faults;
        }
        if (sum <= most) compare(place, sum + faultsAmongNew(place) - gone);
        if (!mayWiden) return;
        for (std::size_t i = 0; i < place.size(); ++i) {
            CheapPlace wider = place;
            if (isFaulty[i] && widenByTriangle(m_, i, wider.ring)) consider(wider);
        }
    }
    /// True when these triangles, in any order, come up for the first time.
    bool isNew(std::vector<Index> gone) {
        std::sort(gone.begin(), gone.end());
        return considered_.insert(std::move(gone)).second;
    }
    /// Keeps the place if it is the best so far.
    void compare(const CheapPlace& place, int added) {
        if (added > kMaxAdded) return;
        const double angle = worstAngle(place);
        if (added > leastAdded_ || (added == leastAdded_ && angle >= bestAngle_)) return;
        leastAdded_ = added;
        bestAngle_ = angle;
        best_ = place;
    }

    const PointSet& points_;
    RepairState& m_;
    Index x_;
    NearTriangles near_;
    std::unordered_map<std::uint64_t, Counted> made_;  ///< By their old edges.
    std::unordered_map<Index, Counted> old_;
    std::set<std::vector<Index>> considered_;  ///< The triangles that places replace, ascending.
    std::optional<CheapPlace> best_;
    int leastAdded_ = std::numeric_limits<int>::max();
    double bestAngle_ = 2.0;  ///< The cosine of its least angle.
};

/// Stores the new triangles in the places of the old ones and at the end of the list.
void putPlace(RepairState& m, const CheapPlace& place, Index x) {
    const HoleRing& ring = place.ring;
    std::array<HalfEdge, kMaxCheapMade> base{};
    const std::size_t count = place.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool reuse = i < ring.gone.size();
        const auto t = reuse ? ring.gone[i] : static_cast<Index>(m.triangles.size());
        if (!reuse) {
            m.triangles.push_back({});
            m.twin.resize(m.twin.size() + 3, kNone);
        }
        base[i] = 3 * t;
        m.triangles.set(t, place.triangle(i, x));
        for (HalfEdge h = base[i]; h < base[i] + 3; ++h) m.twin.set(h, kNone);
    }
    for (std::size_t i = 0; i < count; ++i) {
        pair(m, base[i], ring.outer[i]);
        if (!place.beside) pair(m, base[i] + 1, base[(i + 1) % count] + 2);
        m.sideOf.set(cornerOf(m, base[i]), base[i]);
        m.sideOf.set(cornerOf(m, base[i] + 1), base[i] + 1);
        m.queue.push_back(base[i]);
        m.queue.push_back(base[i] + 1);
    }
    m.sideOf.set(x, base[0] + 2);
}

}  // namespace

bool putAtLeastCost(const PointSet& points, RepairState& m, Index x) {
    const std::optional<CheapPlace> place = CheapestPlace(points, m, x).find();
    if (place) putPlace(m, *place, x);
    return place.has_value();
}

}  // namespace se
