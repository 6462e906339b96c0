/// RobustRules::reinsert: a stranded point gets the place of a triangle nearby, and of as many of
/// its neighbors as must go with it so that none of the new triangles has a fault; or a side at the
/// border, which it divides or is joined to. Of all places the one with the best angles is taken. A
/// point farther than three local spacings from the mesh stays out. After Bowyer and Watson (1981),
/// with faults instead of circumspheres as the test.
///
/// From kSettlingRound on, a point without such a place is put inside a patch, which is filled
/// around it. When every point has had its turn, one that fits nowhere without a fault takes a
/// place whose new triangles have at most one fault more than those that they replace, since the
/// point itself, in no triangle, is one. Of several such places the one that adds the fewest faults
/// is taken, then the one with the best angles. A new triangle is never flipped.
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>

#include "spiraling_edge/stepper/robust/hole_filling.h"

namespace se {
namespace {

/// Farthest that a point may be from the mesh, in local spacings.
constexpr double kReach = 3.0;
/// Largest number of triangles that make room for a point.
constexpr std::size_t kMaxGone = 8;
constexpr std::size_t kMaxMade = kMaxGone + 2;

// ---- places -------------------------------------------------------------------------------------

/// The new triangles of a place, around the point, and the old ones that they replace.
class Change {
  public:
    Change(const RepairState& m, Index x) : m_(&m), x_(x) {}

    /// Takes the place of a triangle.
    void replace(Index t) {
        gone_[goneCount_++] = t;
        for (Index k = 0; k < 3; ++k) put(count_++, 3 * t + k);
    }
    /// Adds a triangle on the outer side of a border.
    void join(HalfEdge border) {
        made_[0] = {{cornerOf(*m_, following(border)), cornerOf(*m_, border), x_}, border};
        count_ = 1;
    }
    /// Avoids the new triangle `i`: the old one across its side goes as well; at a border, the
    /// point divides the side. False if neither is possible.
    bool avoid(std::size_t i) {
        if (goneCount_ == 0) return false;
        return across(i) == kNone ? divideBorder(i) : widen(i);
    }
    /// Replaces the old triangle across the side of new triangle `i` as well. False at a border,
    /// and where its third point is pinched or in the place already.
    bool widen(std::size_t i) {
        const HalfEdge other = across(i);
        if (other == kNone || goneCount_ == kMaxGone) return false;
        const Index tip = cornerOf(*m_, preceding(other));
        if (m_->pinched[tip] || hasCorner(tip)) return false;
        gone_[goneCount_++] = other / 3;
        for (std::size_t k = count_++; k > i + 1; --k) made_[k] = made_[k - 1];
        put(i, following(other));
        put(i + 1, preceding(other));
        return true;
    }

    std::size_t size() const { return count_; }
    const Triangle& operator[](std::size_t i) const { return made_[i].triangle; }
    /// The side across the old edge of triangle `i`, kNone at a border.
    HalfEdge across(std::size_t i) const { return made_[i].outer; }
    /// The old triangles that go.
    std::span<const Index> gone() const { return std::span(gone_).first(goneCount_); }
    bool removes(Index t) const {
        return std::find(gone().begin(), gone().end(), t) != gone().end();
    }
    void apply(RepairState& m) const;

  private:
    struct Made {
        Triangle triangle;
        HalfEdge outer = kNone;
    };

    /// Makes triangle `i` that of an old side.
    void put(std::size_t i, HalfEdge side) {
        made_[i] = {{cornerOf(*m_, side), cornerOf(*m_, following(side)), x_}, m_->twin[side]};
    }
    bool hasCorner(Index p) const {
        const auto end = made_.begin() + static_cast<std::ptrdiff_t>(count_);
        return std::any_of(made_.begin(), end, [&](const Made& made) {
            return made.triangle.a == p || made.triangle.b == p;
        });
    }
    bool divideBorder(std::size_t i) {
        if (dividesBorder_ || count_ < 3) return false;
        dividesBorder_ = true;
        --count_;
        for (std::size_t k = i; k < count_; ++k) made_[k] = made_[k + 1];
        return true;
    }

    const RepairState* m_;
    Index x_;
    std::array<Made, kMaxMade> made_{};
    std::size_t count_ = 0;
    std::array<Index, kMaxGone> gone_{};
    std::size_t goneCount_ = 0;
    bool dividesBorder_ = false;
};

/// Stores the new triangles in the places of the old ones and at the end of the list.
void Change::apply(RepairState& m) const {
    std::array<HalfEdge, kMaxMade> base{};
    for (std::size_t i = 0; i < count_; ++i) base[i] = putTriangle(m, gone(), i, (*this)[i]);
    for (std::size_t i = 0; i < count_; ++i) {
        const Triangle& t = (*this)[i];
        pair(m, base[i], across(i));
        m.sideOf.set(t.a, base[i]);
        m.sideOf.set(t.b, base[i] + 1);
        for (std::size_t j = 0; j < count_; ++j) {
            // The side b -> x of one lies on the side x -> a of the next.
            if ((*this)[j].a == t.b) pair(m, base[i] + 1, base[j] + 2);
        }
        m.queue.push_back(base[i]);
        m.queue.push_back(base[i] + 1);
    }
    m.sideOf.set(x_, base[0] + 2);
}

/// The triangles at the points that x lists, each once, in the order in which they are found, but
/// those with a pinched point.
std::vector<Index> trianglesListed(const PointSet& points, const RepairState& m, Index x) {
    std::vector<Index> found;
    for (const Index p : points.neighbors[x]) {
        forEachSideOf(m, p, [&](HalfEdge side) {
            const Triangle& t = m.triangles[side / 3];
            const bool pinched = m.pinched[t.a] || m.pinched[t.b] || m.pinched[t.c];
            if (!pinched && std::find(found.begin(), found.end(), side / 3) == found.end())
                found.push_back(side / 3);
        });
    }
    return found;
}

/// Those of them that are nearest to x, in this order, at most `most`.
std::vector<Index> nearestListed(const PointSet& points, const RepairState& m, Index x,
                                 std::size_t most) {
    const Vec3& place = points.position[x];
    std::vector<std::pair<double, Index>> byDistance;
    for (const Index t : trianglesListed(points, m, x)) {
        const Triangle& c = m.triangles[t];
        const Vec3 d = place - nearestPoint(place, points.position[c.a], points.position[c.b],
                                            points.position[c.c]);
        byDistance.emplace_back(glm::dot(d, d), t);
    }
    std::sort(byDistance.begin(), byDistance.end());
    byDistance.resize(std::min(byDistance.size(), most));
    std::vector<Index> list;
    list.reserve(byDistance.size());
    for (const auto& [distanceSq, t] : byDistance) list.push_back(t);
    return list;
}

/// A triangle between the point and an old edge, and what was found out about it: it is made for
/// many places.
struct NewTriangle {
    NewTriangle(const PointSet& points, const Triangle& t)
        : shaped(points, t), faults(shapeFaults(points, t)), cosine(leastAngleCosine(points, t)) {}

    ShapedTriangle shaped;
    int faults;                                   ///< shapeFaults()
    double cosine;                                ///< Of its least angle.
    std::optional<std::vector<Index>> conflicts;  ///< conflictsOf() it, if asked.
    /// The old triangle across its side differs from place to place: the side of the last one that
    /// was asked about, and whether they are folded.
    HalfEdge outer = kNone;
    bool foldedAcross = false;
};

/// Number of the nearest triangles that are tried: before kSettlingRound as the place, from then on
/// as the first of a patch.
constexpr std::size_t kNearest = 4;

/// Largest number of triangles that make room for a point at a price.
constexpr std::size_t kMaxCheapGone = 3;
/// The most faults that a place may add: those of a point in no triangle.
constexpr int kMaxAdded = 1;
/// Number of new triangles that are looked at for a place at a price.
constexpr std::size_t kMaxCheapMade = 120;

/// Finds the best place for one point.
class PlaceSearch {
  public:
    /// `near`: the triangles to begin at, in this order. They must outlive the search.
    PlaceSearch(const PointSet& points, RepairState& m, Index x, std::span<const Index> near)
        : points_(points), m_(m), x_(x), near_(near) {}

    /// The place without a fault that has the best angles.
    std::optional<Change> find() {
        // By their angles, as far as shape alone decides: the best ones first.
        std::vector<std::pair<double, Change>> places;
        forEachPlace([&](Change place) {
            if (const auto angle = widenUntilShaped(place)) places.emplace_back(*angle, place);
        });
        std::stable_sort(places.begin(), places.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [angle, place] : places) {
            if (angle < bestAngle_) widenUntilSound(place);
        }
        return best_;
    }
    /// The place that adds the fewest faults; of equal ones, the one with the best angles.
    std::optional<Change> findCheapest() {
        forEachPlace([&](const Change& place) { countFaults(place); });
        return best_;
    }

  private:
    /// Calls visit(place) for the triangles at the points that x lists, and the sides of the border
    /// there; the nearest first.
    template <typename Visit>
    void forEachPlace(Visit&& visit) {
        for (const Index t : near_) {
            Change inside(m_, x_);
            inside.replace(t);
            visit(inside);
            for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
                if (m_.twin[h] != kNone) continue;
                Change outside(m_, x_);
                outside.join(h);
                visit(outside);
            }
        }
    }

    // What is known of new triangles:

    /// The reference stays valid.
    NewTriangle& made(const Triangle& t) {
        return made_.try_emplace(std::uint64_t{t.a} << 32U | t.b, points_, t).first->second;
    }
    const std::vector<Index>& conflicts(NewTriangle& t) {
        if (!t.conflicts) t.conflicts = conflictsOf(points_, m_, t.shaped.triangle);
        return *t.conflicts;
    }
    /// True if a new triangle is folded onto the old one across its side, that of `outer`.
    bool isFoldedAcross(NewTriangle& t, HalfEdge outer) {
        if (outer == kNone) return false;
        if (std::exchange(t.outer, outer) != outer)
            t.foldedAcross = folded(points_, t.shaped.triangle, m_.triangles[outer / 3]);
        return t.foldedAcross;
    }

    // Without a fault:

    /// Widens a place until no new triangle has a fault of shape; returns its least angle's cosine.
    std::optional<double> widenUntilShaped(Change& place) {
        double worst = -1.0;
        for (std::size_t i = 0; i < place.size();) {
            if (!hasBadShape(place, i)) {
                worst = std::max(worst, made(place[i]).cosine);
                ++i;
            } else if (!place.avoid(i)) {
                return std::nullopt;
            }
        }
        return worst;
    }
    bool hasBadShape(const Change& change, std::size_t i) {
        NewTriangle& t = made(change[i]);
        // After the first round a single corner's normal may be against it, as in the last circuit
        // of a ring (kCornerAllowed).
        return t.faults > (m_.round == 0 ? 0 : 1) || t.cosine >= kThin ||
               isFoldedAcross(t, change.across(i));
    }

    /// Widens a place until no new triangle has a fault; keeps it if it is the best so far.
    void widenUntilSound(Change place) {
        double worst = -1.0;
        for (std::size_t i = 0; i < place.size();) {
            if (isFaulty(place, i)) {
                if (!place.avoid(i)) return;
                continue;
            }
            worst = std::max(worst, made(place[i]).cosine);
            if (worst >= bestAngle_) return;
            ++i;
        }
        bestAngle_ = worst;
        best_ = place;
    }
    /// True if a new triangle is in conflict with an old one that stays.
    bool meetsOneThatStays(const Change& place, NewTriangle& mine) {
        const auto stays = [&](Index t) { return !place.removes(t); };
        // What is in the way of one is in the way of most others.
        if (!mine.conflicts && inTheWay_ != kNone && stays(inTheWay_) &&
            conflict(points_, mine.shaped, m_.triangles[inTheWay_]))
            return true;
        const std::vector<Index>& list = conflicts(mine);
        const auto found = std::find_if(list.begin(), list.end(), stays);
        if (found == list.end()) return false;
        inTheWay_ = *found;
        return true;
    }
    /// True if new triangle `i` has a bad shape, or is in conflict with an old one that stays or a
    /// new one before it.
    bool isFaulty(const Change& place, std::size_t i) {
        if (hasBadShape(place, i)) return true;
        NewTriangle& mine = made(place[i]);
        if (meetsOneThatStays(place, mine)) return true;
        std::size_t k = 0;
        while (k < i && !conflict(points_, mine.shaped, made(place[k]).shaped)) ++k;
        return k < i;
    }

    // With the fewest faults:

    /// The faults of the triangles that a place replaces.
    int faultsOfGone(const Change& place) {
        int sum = 0;
        for (const Index t : place.gone()) {
            sum += shapeFaults(points_, m_.triangles[t]) >= kFlippedFault ? 1 : 0;
            for (const Index other : conflictsOfOld(t)) {
                if (other > t || !place.removes(other)) ++sum;
            }
        }
        return sum;
    }
    const std::vector<Index>& conflictsOfOld(Index t) {
        const auto [found, isFirst] = old_.try_emplace(t);
        if (isFirst && !isSound(points_, m_, t))
            found->second = conflictsOf(points_, m_, m_.triangles[t]);
        return found->second;
    }
    /// The faults of a new triangle with those that stay.
    int faultsWithOld(const Change& place, std::size_t i) {
        NewTriangle& t = made(place[i]);
        const std::vector<Index>& list = conflicts(t);
        const auto stay = std::count_if(list.begin(), list.end(),
                                        [&](Index each) { return !place.removes(each); });
        return static_cast<int>(stay) + (isFoldedAcross(t, place.across(i)) ? 1 : 0);
    }
    int faultsAmongNew(const Change& place) {
        int sum = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            for (std::size_t k = i + 1; k < place.size(); ++k) {
                const ShapedTriangle& a = made(place[i]).shaped;
                const ShapedTriangle& b = made(place[k]).shaped;
                sum += conflict(points_, a, b) ? 1 : 0;
                const bool share = k == i + 1 || (i == 0 && k + 1 == place.size());
                sum += share && folded(points_, a.triangle, b.triangle) ? 1 : 0;
            }
        }
        return sum;
    }

    /// Counts the faults of a place, and of those that are wider by one triangle across a side with
    /// a fault.
    void countFaults(const Change& place) {
        const std::size_t replaced = place.gone().size();
        if (made_.size() >= kMaxCheapMade) return;
        if (replaced > 0 && !isNew({place.gone().begin(), place.gone().end()})) return;
        std::array<bool, kMaxMade> isFaulty{};
        bool isBad = false;
        double angle = -1.0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const NewTriangle& t = made(place[i]);
            isFaulty[i] = t.faults >= kFlippedFault || t.cosine >= kThin;
            isBad = isBad || isFaulty[i];
            angle = std::max(angle, t.cosine);
        }
        const bool mayWiden = replaced > 0 && replaced < kMaxCheapGone;
        if (isBad && !mayWiden) return;
        int added = -faultsOfGone(place);
        for (std::size_t i = 0; i < place.size(); ++i) {
            if (isFaulty[i]) continue;
            const int faults = faultsWithOld(place, i);
            isFaulty[i] = faults > 0;
            added += faults;
            if (added > leastAdded_ && !mayWiden) return;
        }
        if (!isBad && added <= leastAdded_) keepIfBest(place, added + faultsAmongNew(place), angle);
        for (std::size_t i = 0; mayWiden && i < place.size(); ++i) {
            Change wider = place;
            if (isFaulty[i] && wider.widen(i)) countFaults(wider);
        }
    }
    /// True when these triangles, in any order, come up for the first time.
    bool isNew(std::vector<Index> gone) {
        std::sort(gone.begin(), gone.end());
        return considered_.insert(std::move(gone)).second;
    }
    void keepIfBest(const Change& place, int added, double angle) {
        if (added > leastAdded_ || (added == leastAdded_ && angle >= bestAngle_)) return;
        leastAdded_ = added;
        bestAngle_ = angle;
        best_ = place;
    }

    const PointSet& points_;
    RepairState& m_;
    Index x_;
    std::span<const Index> near_;
    std::unordered_map<std::uint64_t, NewTriangle> made_;  ///< By their old edges.
    std::unordered_map<Index, std::vector<Index>> old_;    ///< Conflicts of old triangles.
    std::set<std::vector<Index>> considered_;  ///< The triangles that places replace, ascending.
    Index inTheWay_ = kNone;  ///< An old triangle that the last conflict found was with.
    std::optional<Change> best_;
    int leastAdded_ = kMaxAdded;
    double bestAngle_ = 2.0;  ///< The cosine of its least angle: the smaller, the better.
};

// ---- reinsert -----------------------------------------------------------------------------------

/// The distance of a point to its sixth neighbor, or to its last; 0 for an empty list.
double spacingAt(const PointSet& points, Index p) {
    const auto list = points.neighbors[p];
    return list.empty() ? 0.0 : glm::distance(points.position[sixthOf(list)], points.position[p]);
}

/// True if a point lists one of the mesh that is near, by the spacing there. Its own is wide if it
/// is far from all others.
bool isWithinReach(const PointSet& points, const RepairState& m, Index x) {
    const auto list = points.neighbors[x];
    return std::any_of(list.begin(), list.end(), [&](Index q) {
        return m.sideOf[q] != kNone && glm::distance(points.position[q], points.position[x]) <=
                                           kReach * spacingAt(points, q);
    });
}

/// Number of triangles that are replaced at once by others around a point.
constexpr std::size_t kAroundPoint[] = {6};

/// Replaces the triangles about one that is near the point by others between their points and this
/// one, of which none has a fault. The number of those replaced, 0 if there is no such place.
Index putInPatch(const PointSet& points, RepairState& m, Index x, std::span<const Index> near) {
    for (const Index t : near.first(std::min(near.size(), kNearest))) {
        HoleRing patch = patchOf(m, t);
        patch.inside = x;
        const Index replaced = replacePatch(points, m, patch, kAroundPoint);
        if (replaced > 0) return replaced;
    }
    return 0;
}

/// Puts a point in, without a fault or at the price of one. The number of triangles that it takes
/// the place of; nothing if there is no place.
std::optional<Index> putIn(const PointSet& points, RepairState& m, Index x, bool atPrice) {
    const bool isEarly = m.round < kSettlingRound;
    const std::vector<Index> near =
        nearestListed(points, m, x, isEarly ? kNearest : m.triangles.size());
    PlaceSearch search(points, m, x, near);
    const std::optional<Change> change = atPrice ? search.findCheapest() : search.find();
    if (change) {
        change->apply(m);
        return static_cast<Index>(change->gone().size());
    }
    if (atPrice || isEarly) return std::nullopt;
    const Index replaced = putInPatch(points, m, x, near);
    return replaced > 0 ? std::optional(replaced) : std::nullopt;
}

}  // namespace

std::optional<ReinsertEvidence> reinsertNext(const PointSet& points, RepairState& m) {
    const auto count = static_cast<Index>(points.size());
    // At a price only when every other point has had its turn: one without a fault may use the
    // same place.
    const Index end = m.round < kSettlingRound ? count : 2 * count;
    for (; m.next < end; ++m.next) {
        const Index x = points.inOrder(m.next % count);
        if (m.sideOf[x] != kNone || !isWithinReach(points, m, x)) continue;
        const std::optional<Index> replaced = putIn(points, m, x, m.next >= count);
        if (!replaced) continue;
        ++m.reinserted;
        ++m.next;
        return ReinsertEvidence{x, *replaced};
    }
    return std::nullopt;
}

}  // namespace se
