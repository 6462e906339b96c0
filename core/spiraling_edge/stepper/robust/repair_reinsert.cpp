/// RobustRules::reinsert: a stranded point gets the place of a triangle nearby, and of as many of
/// its neighbors as must go with it so that none of the new triangles has a fault; or a side at the
/// border, which it divides or is joined to. Of all places the one with the best angles is taken. A
/// point farther than three local spacings from the mesh stays out.
/// After Bowyer and Watson (1981), with faults instead of circumspheres as the test.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {
namespace {

/// Farthest that a point may be from the mesh, in local spacings.
constexpr double kReach = 3.0;
/// Largest number of triangles that make room for a point.
constexpr std::size_t kMaxGone = 8;
constexpr std::size_t kMaxMade = kMaxGone + 2;
/// Largest number of times that both triangles of a conflict are tried as the one to avoid, for one
/// place.
constexpr std::size_t kMaxChoices = 4;

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
        made_[0] = {cornerOf(*m_, following(border)), cornerOf(*m_, border), x_};
        outer_[0] = border;
        number_[0] = kNone;
        count_ = 1;
    }
    /// Avoids the new triangle `i`: the old one across its side goes as well; at a border, the
    /// point divides the side. False if neither is possible.
    bool avoid(std::size_t i) {
        if (goneCount_ == 0) return false;
        return outer_[i] == kNone ? divideBorder(i) : widen(i);
    }

    std::size_t size() const { return count_; }
    const Triangle& operator[](std::size_t i) const { return made_[i]; }
    /// Number of triangle `i` in a list of the caller; kNone until the caller sets it.
    Index& number(std::size_t i) { return number_[i]; }
    /// The side across the old edge of triangle `i`, kNone at a border.
    HalfEdge across(std::size_t i) const { return outer_[i]; }
    bool removes(Index t) const {
        const auto end = gone_.begin() + static_cast<std::ptrdiff_t>(goneCount_);
        return std::find(gone_.begin(), end, t) != end;
    }
    void apply(RepairState& m) const;

  private:
    /// Makes triangle `i` that of an old side.
    void put(std::size_t i, HalfEdge side) {
        made_[i] = {cornerOf(*m_, side), cornerOf(*m_, following(side)), x_};
        outer_[i] = m_->twin[side];
        number_[i] = kNone;
    }
    bool hasCorner(Index p) const {
        const auto end = made_.begin() + static_cast<std::ptrdiff_t>(count_);
        return std::any_of(made_.begin(), end,
                           [&](const Triangle& t) { return t.a == p || t.b == p; });
    }
    bool widen(std::size_t i) {
        const HalfEdge other = outer_[i];
        const Index tip = cornerOf(*m_, preceding(other));
        if (goneCount_ == kMaxGone || m_->pinched[tip] || hasCorner(tip)) return false;
        gone_[goneCount_++] = other / 3;
        for (std::size_t k = count_++; k > i + 1; --k) {
            made_[k] = made_[k - 1];
            outer_[k] = outer_[k - 1];
            number_[k] = number_[k - 1];
        }
        put(i, following(other));
        put(i + 1, preceding(other));
        return true;
    }
    bool divideBorder(std::size_t i) {
        if (dividesBorder_ || count_ < 3) return false;
        dividesBorder_ = true;
        --count_;
        for (std::size_t k = i; k < count_; ++k) {
            made_[k] = made_[k + 1];
            outer_[k] = outer_[k + 1];
            number_[k] = number_[k + 1];
        }
        return true;
    }

    const RepairState* m_;
    Index x_;
    std::array<Triangle, kMaxMade> made_{};
    std::array<HalfEdge, kMaxMade> outer_{};
    std::array<Index, kMaxMade> number_{};
    std::size_t count_ = 0;
    std::array<Index, kMaxGone> gone_{};
    std::size_t goneCount_ = 0;
    bool dividesBorder_ = false;
};

/// Stores the new triangles in the places of the old ones and at the end of the list.
void Change::apply(RepairState& m) const {
    std::array<HalfEdge, kMaxMade> base{};
    for (std::size_t i = 0; i < count_; ++i) {
        const bool reuse = i < goneCount_;
        const auto t = reuse ? gone_[i] : static_cast<Index>(m.triangles.size());
        if (!reuse) {
            m.triangles.push_back({});
            m.twin.resize(m.twin.size() + 3, kNone);
        }
        base[i] = 3 * t;
        m.triangles.set(t, made_[i]);
    }
    for (std::size_t i = 0; i < count_; ++i) {
        for (const HalfEdge side : {base[i], base[i] + 1, base[i] + 2}) m.twin.set(side, kNone);
    }
    for (std::size_t i = 0; i < count_; ++i) {
        pair(m, base[i], outer_[i]);
        m.sideOf.set(made_[i].a, base[i]);
        m.sideOf.set(made_[i].b, base[i] + 1);
        for (std::size_t j = 0; j < count_; ++j) {
            // The side b -> x of one lies on the side x -> a of the next.
            if (made_[j].a == made_[i].b) pair(m, base[i] + 1, base[j] + 2);
        }
        m.queue.push_back(base[i]);
        m.queue.push_back(base[i] + 1);
    }
    m.sideOf.set(x_, base[0] + 2);
}

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
    std::vector<std::pair<Index, bool>> withFar;  ///< and with old ones that are not near.
    HalfEdge outer = kNone;                       ///< The side that `foldedAt` is known for.
    bool foldedAt = false;                        ///< It is folded onto the triangle of that side.
};

/// Finds the best place for one point.
class PlaceSearch {
  public:
    PlaceSearch(const PointSet& points, RepairState& m, Index x) : points_(points), m_(m), x_(x) {}

    std::optional<Change> find() {
        near_ = nearestFirst(points_, m_, x_);
        for (const NearTriangle& each : near_)
            nearIndex_.emplace_back(each.index, static_cast<Index>(nearIndex_.size()));
        std::sort(nearIndex_.begin(), nearIndex_.end());
        std::vector<Index> begins;
        for (const Index p : points_.neighbors[x_])
            forEachSideOf(m_, p, [&](HalfEdge side) {
                if (std::find(begins.begin(), begins.end(), side / 3) == begins.end())
                    begins.push_back(side / 3);
            });
        for (const Index t : begins) {
            const Triangle& old = m_.triangles[t];
            if (m_.pinched[old.a] || m_.pinched[old.b] || m_.pinched[old.c]) continue;
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
        if (isNew) {
            made_.emplace_back(points_, t);
            withNear_.resize(made_.size() * near_.size(), Answer::Unknown);
        }
        return number = found->second;
    }
    /// The reference holds until the next call.
    NewTriangle& made(Change& change, std::size_t i) { return made_[numberOf(change, i)]; }
    /// True if new triangle number `i` is in conflict with the near one at this position.
    bool inConflictWithNear(Index i, std::size_t place) {
        Answer& answer = withNear_[i * near_.size() + place];
        if (answer == Answer::Unknown)
            answer =
                conflict(points_, made_[i].shaped, near_[place].shaped) ? Answer::Yes : Answer::No;
        return answer == Answer::Yes;
    }
    /// Tests the next near triangle; true if it is in conflict with new triangle number `i`.
    bool testNext(Index i) {
        const std::size_t place = made_[i].tested++;
        if (!inConflictWithNear(i, place)) return false;
        made_[i].conflicts.push_back(place);
        return true;
    }
    bool inConflict(Index i, Index old) {
        const auto found = std::lower_bound(
            nearIndex_.begin(), nearIndex_.end(), old,
            [](const std::pair<Index, Index>& each, Index t) { return each.first < t; });
        if (found != nearIndex_.end() && found->first == old)
            return inConflictWithNear(i, found->second);
        NewTriangle& t = made_[i];
        for (const auto& [triangle, answer] : t.withFar) {
            if (triangle == old) return answer;
        }
        const bool answer = conflict(points_, t.shaped, m_.triangles[old]);
        t.withFar.emplace_back(old, answer);
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
        const NewTriangle& t = made_[mine];
        // In the last rounds a single corner's normal may be against it, as in the last circuit of
        // a ring (kCornerAllowed).
        if (t.faults > (m_.round < kSettlingRound ? 0 : 1) || t.cosine >= kThin) return true;
        // What is known already comes first.
        const auto stays = [&](std::size_t place) { return !change.removes(near_[place].index); };
        if (std::any_of(t.conflicts.begin(), t.conflicts.end(), stays)) return true;
        if (isFolded(mine, change.across(i))) return true;
        while (t.tested < near_.size()) {
            if (testNext(mine) && stays(t.conflicts.back())) return true;
        }
        return false;
    }

    bool isFolded(Index i, HalfEdge outer) {
        if (outer == kNone) return false;
        NewTriangle& t = made_[i];
        if (t.outer != outer) {
            t.outer = outer;
            t.foldedAt = folded(points_, t.shaped.triangle, m_.triangles[outer / 3]);
        }
        return t.foldedAt;
    }

    const PointSet& points_;
    RepairState& m_;
    Index x_;
    /// No new triangle may be in conflict with any of these.
    std::vector<NearTriangle> near_;
    /// Their indices, ascending, each with its position in `near_`.
    std::vector<std::pair<Index, Index>> nearIndex_;
    std::vector<NewTriangle> made_;
    /// Conflicts of each new triangle, by number, with each near one.
    std::vector<Answer> withNear_;
    std::unordered_map<std::uint64_t, Index> numbers_;  ///< Their numbers, by their old edges.
    std::size_t choices_ = 0;
    Insertion best_;
};

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

bool putWithoutFault(const PointSet& points, RepairState& m, Index x) {
    const std::optional<Change> change = PlaceSearch(points, m, x).find();
    if (change) change->apply(m);
    return change.has_value();
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
        const bool found =
            m.next < count ? putWithoutFault(points, m, x) : putAtLeastCost(points, m, x);
        if (!found) continue;
        ++m.reinserted;
        ++m.next;
        return ReinsertEvidence{x};
    }
    return std::nullopt;
}

}  // namespace se
