/// RobustRules::reinsert: a stranded point gets the place of a triangle nearby, and of as many of
/// its neighbors as must go with it so that none of the new triangles has a fault; or a side at the
/// border, which it divides or is joined to. Of all places the one with the best angles is taken. A
/// point farther than three local spacings from the mesh stays out.
/// After Bowyer and Watson (1981), with faults instead of circumspheres as the test.
/// At the end, a point that fits nowhere without a fault takes the place where the new triangles
/// have at most one fault more than those they replace, since the point itself, in no triangle, is
/// one. Of several places the one with the fewest faults is taken, then the one with the best
/// angles. A new triangle is never flipped.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/stepper/robust/near_triangles.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

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
    /// Number of triangle `i` in a list of the caller; kNone until the caller sets it.
    Index& number(std::size_t i) { return made_[i].number; }
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
        Index number = kNone;
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

/// Whether a new triangle is folded onto the old one across its side, as last asked: the side of
/// the same triangle differs from place to place.
class FoldAcross {
  public:
    bool isFolded(const PointSet& points, const RepairState& m, const Triangle& made,
                  HalfEdge outer) {
        if (outer == kNone) return false;
        if (std::exchange(outer_, outer) != outer)
            folded_ = folded(points, made, m.triangles[outer / 3]);
        return folded_;
    }

  private:
    HalfEdge outer_ = kNone;
    bool folded_ = false;
};

// ---- without a fault ----------------------------------------------------------------------------

/// Largest number of times that both triangles of a conflict are tried as the one to avoid, for one
/// place.
constexpr std::size_t kMaxChoices = 4;

/// A place for a point, and the quality of its triangles.
struct Insertion {
    std::optional<Change> change;
    double cosine = 2.0;  ///< Of the least angle of the new triangles: the smaller, the better.
};

struct NearTriangle {
    Index index;
    double distanceSq;  ///< From the point to its nearest corner, squared.
    ShapedTriangle shaped;
};

/// The triangles near a point, the nearest first, since most conflicts are with those.
std::vector<NearTriangle> nearestFirst(const PointSet& points, RepairState& m, Index x) {
    std::vector<NearTriangle> near;
    const std::vector<Index> list = trianglesNear(points, m, std::array{x});
    near.reserve(list.size());
    for (const Index t : list) {
        const Triangle& corners = m.triangles[t];
        double least = std::numeric_limits<double>::max();
        for (const Index p : {corners.a, corners.b, corners.c}) {
            const Vec3 d = points.position[p] - points.position[x];
            least = std::min(least, glm::dot(d, d));
        }
        near.push_back({t, least, ShapedTriangle(points, corners)});
    }
    std::stable_sort(near.begin(), near.end(), [](const NearTriangle& a, const NearTriangle& b) {
        return a.distanceSq < b.distanceSq;
    });
    return near;
}

enum class Answer : std::uint8_t { Unknown, No, Yes };

/// A triangle between the point and an old edge, and what was found out about it: it is made for
/// many places.
struct NewTriangle {
    NewTriangle(const PointSet& points, const Triangle& t)
        : shaped(points, t), faults(shapeFaults(points, t)), cosine(leastAngleCosine(points, t)) {}

    ShapedTriangle shaped;
    int faults;
    double cosine;                       ///< Of its least angle.
    std::size_t tested = 0;              ///< Number of near triangles tested, from the first on,
    std::vector<std::size_t> conflicts;  ///< and the positions of those in conflict with it.
    std::vector<Answer> withOthers;      ///< Conflicts with other new triangles, by number,
    std::vector<std::pair<Index, bool>> withOld;  ///< and with old ones across a side.
    FoldAcross across;
};

/// Finds the best place for one point.
class PlaceSearch {
  public:
    PlaceSearch(const PointSet& points, RepairState& m, Index x)
        : points_(points), m_(m), x_(x), near_(nearestFirst(points, m, x)) {}

    std::optional<Change> find() {
        for (const Index t : trianglesListed(points_, m_, x_)) {
            Change inside(m_, x_);
            inside.replace(t);
            choices_ = 0;
            consider(inside);
            for (Index k = 0; k < 3; ++k) {
                if (m_.twin[3 * t + k] != kNone) continue;
                Change outside(m_, x_);
                outside.join(3 * t + k);
                // Its one triangle can be avoided by no other.
                if (made(outside, 0).cosine < best_.cosine) consider(outside);
            }
        }
        return best_.change;
    }

  private:
    /// Widens a place until no new triangle has a fault; keeps it if it is the best so far. The
    /// first `from` triangles have none; `worst` is their least angle's cosine.
    void consider(Change change, std::size_t from = 0, double worst = -1.0) {
        std::array<double, kMaxMade + 1> worstBefore{};
        worstBefore[from] = worst;
        for (std::size_t i = from; i < change.size();) {
            // Without another choice the triangles before this one stay, so that the place is no
            // better than they are.
            if (choices_ == kMaxChoices && worstBefore[i] >= best_.cosine) return;
            const bool faulty = isFaulty(change, i);
            const std::size_t rival = faulty ? i : firstInConflict(change, i);
            // The old triangle that is in the way may go as well,
            const bool mayChoose = faulty && choices_ < kMaxChoices;
            const std::size_t side = mayChoose ? sideInTheWay(change, i) : change.size();
            if (side < change.size() && side != i) {
                ++choices_;
                Change other = change;
                const std::size_t again = std::min(side, i);
                if (other.avoid(side)) consider(other, again, worstBefore[again]);
            }
            // and of two new ones in conflict, either may be the one to avoid.
            if (rival < i && choices_ < kMaxChoices) {
                ++choices_;
                Change other = change;
                if (other.avoid(rival)) consider(other, rival, worstBefore[rival]);
            }
            if (faulty || rival < i) {
                if (!change.avoid(i)) return;
                continue;
            }
            worstBefore[i + 1] = std::max(worstBefore[i], made(change, i).cosine);
            ++i;
        }
        if (worstBefore[change.size()] < best_.cosine) best_ = {change, worstBefore[change.size()]};
    }

    Index numberOf(Change& change, std::size_t i) {
        Index& number = change.number(i);
        if (number != kNone) return number;
        const Triangle& t = change[i];
        const auto [found, isNew] =
            numbers_.try_emplace(std::uint64_t{t.a} << 32U | t.b, static_cast<Index>(made_.size()));
        if (isNew) made_.emplace_back(points_, t);
        return number = found->second;
    }
    /// The reference holds until the next call.
    NewTriangle& made(Change& change, std::size_t i) { return made_[numberOf(change, i)]; }
    /// Tests the next near triangle; true if it is in conflict with new triangle number `i`.
    bool testNext(Index i) {
        const std::size_t place = made_[i].tested++;
        if (!conflict(points_, made_[i].shaped, near_[place].shaped)) return false;
        made_[i].conflicts.push_back(place);
        return true;
    }
    bool inConflict(Index i, Index old) {
        NewTriangle& t = made_[i];
        for (const auto& [triangle, answer] : t.withOld) {
            if (triangle == old) return answer;
        }
        const bool answer = conflict(points_, t.shaped, m_.triangles[old]);
        t.withOld.emplace_back(old, answer);
        return answer;
    }
    /// True if new triangle number `i` is in conflict with number `k`.
    bool inConflictWith(Index i, Index k) {
        NewTriangle& t = made_[i];
        if (t.withOthers.size() <= k) t.withOthers.resize(made_.size(), Answer::Unknown);
        Answer& answer = t.withOthers[k];
        if (answer == Answer::Unknown)
            answer = conflict(points_, t.shaped, made_[k].shaped) ? Answer::Yes : Answer::No;
        return answer == Answer::Yes;
    }

    /// The first triangle before `i` that is in conflict with it; else `i`.
    std::size_t firstInConflict(Change& change, std::size_t i) {
        const Index mine = numberOf(change, i);
        std::size_t k = 0;
        while (k < i && !inConflictWith(mine, numberOf(change, k))) ++k;
        return k;
    }

    /// The first side of the place whose old triangle across is in conflict with new triangle `i`,
    /// if that has a good shape; the number of sides if there is none.
    std::size_t sideInTheWay(Change& change, std::size_t i) {
        const Index mine = numberOf(change, i);
        if (made_[mine].faults > 0 || made_[mine].cosine >= kThin) return change.size();
        const auto isInTheWay = [&](HalfEdge outer) {
            return outer != kNone && inConflict(mine, outer / 3);
        };
        std::size_t k = 0;
        while (k < change.size() && !isInTheWay(change.across(k))) ++k;
        return k;
    }

    bool isFaulty(Change& change, std::size_t i) {
        const Index mine = numberOf(change, i);
        NewTriangle& t = made_[mine];
        // In the last rounds a single corner's normal may be against it, as in the last circuit of
        // a ring (kCornerAllowed).
        if (t.faults > (m_.round < kSettlingRound ? 0 : 1) || t.cosine >= kThin) return true;
        // What is known already comes first.
        const auto stays = [&](std::size_t place) { return !change.removes(near_[place].index); };
        if (std::any_of(t.conflicts.begin(), t.conflicts.end(), stays)) return true;
        if (t.across.isFolded(points_, m_, change[i], change.across(i))) return true;
        while (t.tested < near_.size()) {
            if (testNext(mine) && stays(t.conflicts.back())) return true;
        }
        return false;
    }

    const PointSet& points_;
    RepairState& m_;
    Index x_;
    /// No new triangle may be in conflict with any of these.
    std::vector<NearTriangle> near_;
    std::vector<NewTriangle> made_;
    std::unordered_map<std::uint64_t, Index> numbers_;  ///< Their numbers, by their old edges.
    std::size_t choices_ = 0;
    Insertion best_;
};

// ---- with the fewest faults ---------------------------------------------------------------------

/// Largest number of triangles that make room for a point.
constexpr std::size_t kMaxCheapGone = 3;
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
    FoldAcross across{};
};

/// The triangles near a point, ascending: what is counted depends on their order.
std::vector<Index> nearAscending(const PointSet& points, RepairState& m, Index x) {
    std::vector<Index> list = trianglesNear(points, m, std::array{x});
    std::sort(list.begin(), list.end());
    return list;
}

/// Finds the place for one point that adds the fewest faults.
class CheapestSearch {
  public:
    CheapestSearch(const PointSet& points, RepairState& m, Index x)
        : points_(points), m_(m), x_(x), near_(points, m, nearAscending(points, m, x)) {}

    std::optional<Change> find() {
        std::vector<Index> begins = trianglesListed(points_, m_, x_);
        std::sort(begins.begin(), begins.end());
        for (const Index t : begins) {
            Change inside(m_, x_);
            inside.replace(t);
            consider(inside);
            for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
                if (m_.twin[h] != kNone) continue;
                Change outside(m_, x_);
                outside.join(h);
                consider(outside);
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
    int faultsOfGone(const Change& place) {
        int sum = 0;
        for (const Index t : place.gone()) {
            const Counted& each = old(t);
            sum += each.own;
            for (const auto& [other, faults] : each.pairs) {
                if (other > t || !place.removes(other)) sum += faults;
            }
        }
        return sum;
    }
    /// The faults of a new triangle with those that stay, counted until they are more than `most`.
    int faultsWithOld(const Change& place, std::size_t i, int most) {
        Counted& t = made(place[i]);
        int faults = t.own;
        if (t.across.isFolded(points_, m_, place[i], place.across(i))) ++faults;
        for (const auto& [other, count] : t.pairs) {
            if (!place.removes(other)) faults += count;
        }
        while (faults <= most && countNext(t, kNone)) {
            if (!place.removes(t.pairs.back().first)) faults += t.pairs.back().second;
            // With so many it stays out, whatever goes.
            if (t.inPairs < kTooMany) continue;
            t.own = kTooMany;
            return kTooMany;
        }
        return faults;
    }
    int faultsAmongNew(const Change& place) {
        int sum = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const ShapedTriangle a = shapedOf(made(place[i]));
            for (std::size_t k = i + 1; k < place.size(); ++k) {
                const ShapedTriangle& b = shapedOf(made(place[k]));
                sum += faultsOfPair(points_, a, b);
                const bool share = k == i + 1 || (i == 0 && k + 1 == place.size());
                sum += share && folded(points_, a.triangle, b.triangle) ? 1 : 0;
            }
        }
        return sum;
    }
    double worstAngle(const Change& place) const {
        double worst = -1.0;
        for (std::size_t i = 0; i < place.size(); ++i)
            worst = std::max(worst, leastAngleCosine(points_, place[i]));
        return worst;
    }

    /// Counts a place, and those that are wider by one triangle across a side with a fault.
    void consider(const Change& place) {
        const std::size_t replaced = place.gone().size();
        if (replaced > 0 && !isNew({place.gone().begin(), place.gone().end()})) return;
        const int gone = faultsOfGone(place);
        const int most = std::min(kMaxAdded + gone, kTooMany - 1);
        const bool mayWiden = replaced > 0 && replaced < kMaxCheapGone;
        std::array<bool, kMaxMade> isFaulty{};
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
            Change wider = place;
            if (isFaulty[i] && wider.widen(i)) consider(wider);
        }
    }
    /// True when these triangles, in any order, come up for the first time.
    bool isNew(std::vector<Index> gone) {
        std::sort(gone.begin(), gone.end());
        return considered_.insert(std::move(gone)).second;
    }
    /// Keeps the place if it is the best so far.
    void compare(const Change& place, int added) {
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
    std::optional<Change> best_;
    int leastAdded_ = std::numeric_limits<int>::max();
    double bestAngle_ = 2.0;  ///< The cosine of its least angle.
};

// ---- reinsert -----------------------------------------------------------------------------------

/// The distance of a point to its sixth neighbor, or to its last; 0 for an empty list.
double spacingAt(const PointSet& points, Index p) {
    const auto list = points.neighbors[p];
    if (list.empty()) return 0.0;
    const Index sixth = list[std::min<std::size_t>(5, list.size() - 1)];
    return glm::distance(points.position[sixth], points.position[p]);
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

}  // namespace

std::optional<ReinsertEvidence> reinsertNext(const PointSet& points, RepairState& m) {
    const auto count = static_cast<Index>(points.size());
    // At a price only when every other point has had its turn: one without a fault may use the
    // same place.
    const Index end = m.round < kSettlingRound ? count : 2 * count;
    for (; m.next < end; ++m.next) {
        const Index x = points.inOrder(m.next % count);
        if (m.sideOf[x] != kNone || !isWithinReach(points, m, x)) continue;
        const std::optional<Change> change =
            m.next < count ? PlaceSearch(points, m, x).find() : CheapestSearch(points, m, x).find();
        if (!change) continue;
        const auto replaced = static_cast<Index>(change->gone().size());
        change->apply(m);
        ++m.reinserted;
        ++m.next;
        return ReinsertEvidence{x, replaced};
    }
    return std::nullopt;
}

}  // namespace se
