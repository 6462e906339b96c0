/// The best filling of each part of the ring, from short parts to long ones: a triangle stands on
/// the edge from one end of a part to the other, and the parts on both sides of its third corner
/// are known (Barequet and Sharir 1995). Tried for the least angle first, then for the area; around
/// a point inside, for the least angle alone.
#include "spiraling_edge/stepper/robust/hole_filling.h"

#include <utility>

namespace se {

namespace {

/// The same triangle, from its first place on.
RingTriangle fromLeastPlace(RingTriangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

}  // namespace

/// The best filling of each part of the ring, from one place to another, counted from `first` on.
template <typename Goal>
class FillingTable {
  public:
    explicit FillingTable(FillingSearch& search, std::size_t first = 0)
        : search_(search),
          count_(search.ring_.size()),
          first_(first),
          cost_(count_ * count_, kNoWay),
          middle_(count_ * count_, 0) {
        for (std::size_t span = 2; span < count_; ++span) {
            for (std::size_t i = 0; i + span < count_; ++i) fillPart(i, i + span);
        }
    }
    Filling filling() const {
        Filling found;
        if (cost_[at(0, count_ - 1)] < kNoWay) collect(0, count_ - 1, found);
        return found;
    }
    /// The best filling around the point inside with a triangle at the last side, and its cost.
    std::pair<double, Filling> fillingAround() const;

  private:
    static constexpr double kNoWay = 1e300;

    std::size_t at(std::size_t i, std::size_t k) const { return i * count_ + k; }

    void fillPart(std::size_t i, std::size_t k) {
        const bool closing = i == 0 && k + 1 == count_;
        if (!closing &&
            search_.staysJoined(search_.ring_.at(placeOf(i)), search_.ring_.at(placeOf(k))))
            return;
        for (std::size_t j = i + 1; j < k; ++j) {
            const double before = costOf(i, j);
            const double after = costOf(j, k);
            if (before == kNoWay || after == kNoWay) continue;
            const Triangle made = triangle(i, j, k);
            const double cost = Goal::sum(Goal::of(search_.points_, made), before, after);
            if (cost >= cost_[at(i, k)] || folds(made, i, j, k) || !mayMake(i, j, k)) continue;
            cost_[at(i, k)] = cost;
            middle_[at(i, k)] = j;
        }
    }
    double costOf(std::size_t i, std::size_t k) const {
        return k > i + 1 ? cost_[at(i, k)] : Goal::kNone;
    }
    /// True if the triangle is folded onto one at its sides.
    bool folds(const Triangle& made, std::size_t i, std::size_t j, std::size_t k) const {
        const bool closing = i == 0 && k + 1 == count_;
        return foldsAt(made, i, j) || foldsAt(made, j, k) || (closing && foldsOutside(made, k));
    }
    bool foldsAt(const Triangle& made, std::size_t i, std::size_t k) const {
        if (k == i + 1) return foldsOutside(made, i);
        return folded(search_.points_, made, triangle(i, middle_[at(i, k)], k));
    }
    bool foldsOutside(const Triangle& made, std::size_t side) const {
        return search_.foldsOnto(made, search_.ring_.outer[placeOf(side)]);
    }
    void collect(std::size_t i, std::size_t k, Filling& found) const {
        if (k == i + 1) return;
        const std::size_t j = middle_[at(i, k)];
        found.push_back(placesOf(i, j, k));
        collect(i, j, found);
        collect(j, k, found);
    }

    /// The place on the ring; count_ is the point inside.
    std::size_t placeOf(std::size_t i) const { return i < count_ ? (first_ + i) % count_ : i; }
    /// From the first of them on the ring.
    RingTriangle placesOf(std::size_t i, std::size_t j, std::size_t k) const {
        return fromLeastPlace({placeOf(i), placeOf(j), placeOf(k)});
    }
    Triangle triangle(std::size_t i, std::size_t j, std::size_t k) const {
        return search_.triangle({placeOf(i), placeOf(j), placeOf(k)});
    }
    bool mayMake(std::size_t i, std::size_t j, std::size_t k) const {
        return search_.mayMake(placesOf(i, j, k));
    }

    FillingSearch& search_;
    std::size_t count_;
    std::size_t first_;
    std::vector<double> cost_;         ///< Of the best filling of a part.
    std::vector<std::size_t> middle_;  ///< Third corner of its triangle from end to end.
};

template <typename Goal>
std::pair<double, Filling> FillingTable<Goal>::fillingAround() const {
    // Per place, of the triangles around the point from the first place to this one, with the parts
    // beyond them.
    std::vector<double> cost(count_, kNoWay);
    std::vector<std::size_t> previous(count_, 0);
    cost[0] = Goal::kNone;
    const auto foldsOntoPrevious = [&](const Triangle& made, std::size_t i) {
        return i > 0 && folded(search_.points_, made, triangle(previous[i], i, count_));
    };
    for (std::size_t k = 1; k < count_; ++k) {
        for (std::size_t i = 0; i < k; ++i) {
            if (cost[i] == kNoWay || costOf(i, k) == kNoWay) continue;
            const Triangle made = triangle(i, k, count_);
            const double sum = Goal::sum(Goal::of(search_.points_, made), cost[i], costOf(i, k));
            if (sum >= cost[k] || foldsAt(made, i, k) || foldsOntoPrevious(made, i) ||
                !mayMake(i, k, count_))
                continue;
            cost[k] = sum;
            previous[k] = i;
        }
    }
    const std::size_t last = count_ - 1;
    const Triangle closing = triangle(last, 0, count_);
    if (cost[last] == kNoWay || foldsOutside(closing, last) || foldsOntoPrevious(closing, last) ||
        !mayMake(last, 0, count_))
        return {kNoWay, {}};
    Filling found{placesOf(last, 0, count_)};
    std::size_t k = last;
    for (; k > 0; k = previous[k]) {
        found.push_back(placesOf(previous[k], k, count_));
        collect(previous[k], k, found);
        if (previous[k] == 0 && folded(search_.points_, closing, triangle(0, k, count_)))
            return {kNoWay, {}};
    }
    return {Goal::sum(Goal::of(search_.points_, closing), cost[last], Goal::kNone), found};
}

namespace {

/// The least angle of a filling is that of its worst triangle.
struct LeastAngle {
    static constexpr double kNone = -1.0;
    static double of(const PointSet& points, const Triangle& t) {
        return leastAngleCosine(points, t);
    }
    static double sum(double a, double b, double c) { return std::max(a, std::max(b, c)); }
};

/// The area of a filling.
struct Area {
    static constexpr double kNone = 0.0;
    static double of(const PointSet& points, const Triangle& t) {
        return glm::length(areaVector(points, t));
    }
    static double sum(double a, double b, double c) { return a + b + c; }
};

}  // namespace

bool widenByTriangle(const RepairState& m, std::size_t side, HoleRing& ring) {
    const HalfEdge other = ring.outer[side];
    if (other == kNone) return false;
    const Index tip = cornerOf(m, preceding(other));
    if (m.pinched[tip] || isOn(ring, tip)) return false;
    const auto after = static_cast<std::ptrdiff_t>(side) + 1;
    ring.points.insert(ring.points.begin() + after, tip);
    ring.outer[side] = m.twin[following(other)];
    ring.outer.insert(ring.outer.begin() + after, m.twin[preceding(other)]);
    ring.gone.push_back(other / 3);
    return true;
}

FillingSearch::FillingSearch(const PointSet& points, RepairState& repair, const HoleRing& ring)
    : points_(points),
      m_(repair),
      ring_(ring),
      known_((ring.size() + 1) * (ring.size() + 1) * (ring.size() + 1), Known::Nothing) {}

Filling FillingSearch::find() {
    if (hasBlockedSide()) return {};
    if (ring_.inside != kNone) return findAround();
    Filling filling = FillingTable<LeastAngle>(*this).filling();
    if (!crossesItself(filling)) return filling;
    filling = FillingTable<Area>(*this).filling();
    return crossesItself(filling) ? Filling{} : filling;
}

/// Of the fillings with a triangle between the point inside and a side of the ring, the best one
/// that the tables find.
Filling FillingSearch::findAround() {
    Filling best;
    double least = 2.0;
    for (std::size_t first = 0; first < ring_.size(); ++first) {
        auto [cost, filling] = FillingTable<LeastAngle>(*this, first).fillingAround();
        if (cost >= least || crossesItself(filling)) continue;
        least = cost;
        best = std::move(filling);
    }
    return best;
}

/// True if visit(triangle) holds for one of the triangles at a side of the ring.
template <typename Visit>
bool FillingSearch::anyThird(std::size_t side, Visit&& visit) {
    const std::size_t next = (side + 1) % ring_.size();
    for (std::size_t third = 0; third < ring_.size(); ++third) {
        if (third == side || third == next) continue;
        if (visit(fromLeastPlace({side, next, third}))) return true;
    }
    return ring_.inside != kNone && visit(fromLeastPlace({side, next, ring_.size()}));
}

/// True if every triangle at a side has a fault.
bool FillingSearch::isBlocked(std::size_t side) {
    return !anyThird(side, [&](const RingTriangle& t) { return mayMake(t); });
}

std::size_t FillingSearch::firstBlocked(std::size_t from) {
    std::size_t side = from;
    while (side < ring_.size() && !isBlocked(side)) ++side;
    return side;
}

/// True if there is a blocked side: each side has a triangle of every filling. Asked of those first
/// at which the fewest triangles fit, so that mostly few are tested for conflicts.
bool FillingSearch::hasBlockedSide() {
    std::vector<std::pair<std::size_t, std::size_t>> sides;  // By the number of triangles that fit.
    for (std::size_t side = 0; side < ring_.size(); ++side) {
        std::size_t fit = 0;
        anyThird(side, [&](const RingTriangle& t) {
            fit += isFit(t) ? 1 : 0;
            return false;
        });
        if (fit == 0) return true;
        sides.emplace_back(fit, side);
    }
    std::sort(sides.begin(), sides.end());
    return std::any_of(sides.begin(), sides.end(),
                       [&](const auto& each) { return isBlocked(each.second); });
}

/// True if a triangle that stays has an edge between the two points.
bool FillingSearch::staysJoined(Index u, Index v) const {
    bool found = false;
    const auto test = [&](HalfEdge h) {
        found = found || (!isGone(ring_, h / 3) &&
                          (cornerOf(m_, following(h)) == v || cornerOf(m_, preceding(h)) == v));
    };
    forEachSideOf(m_, u, test);
    if (m_.pinched[u]) {
        for (const PinchedSide& side : sidesOfPinched(m_, u)) test(side.leaving);
    }
    return found;
}

bool FillingSearch::foldsOnto(const Triangle& made, HalfEdge outer) const {
    return outer != kNone && folded(points_, made, m_.triangles[outer / 3]);
}

/// True if a triangle has no fault by itself, nor with those around the ring.
bool FillingSearch::fits(const RingTriangle& t) const {
    const Triangle made = triangle(t);
    if (shapeFaults(points_, made) >= kFlippedFault || leastAngleCosine(points_, made) >= kThin)
        return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = t[k];
        const std::size_t to = t[(k + 1) % 3];
        const bool isSide = from < ring_.size() && (from + 1) % ring_.size() == to;
        if (isSide ? foldsOnto(made, ring_.outer[from]) : staysJoined(ring_.at(from), ring_.at(to)))
            return false;
    }
    return true;
}

/// fits(), found out once.
bool FillingSearch::isFit(const RingTriangle& t) {
    Known& found = known(t);
    if (found == Known::Nothing) found = fits(t) ? Known::Fit : Known::Faulty;
    return found != Known::Faulty;
}

/// True if a triangle fits and is in conflict with none that stays.
bool FillingSearch::mayMake(const RingTriangle& t) {
    if (!isFit(t)) return false;
    Known& found = known(t);
    if (found == Known::Fit) found = isInConflict(triangle(t)) ? Known::Faulty : Known::Sound;
    return found == Known::Sound;
}

bool FillingSearch::isInConflict(const Triangle& made) {
    // What is in the way of one triangle is in the way of most others at the same side.
    if (inTheWay_ != kNone && conflict(points_, made, m_.triangles[inTheWay_])) return true;
    const Index found = firstConflict(points_, m_, made, ring_.gone);
    if (found != kNone) inTheWay_ = found;
    return found != kNone;
}

/// True if two triangles of the filling are in conflict.
bool FillingSearch::crossesItself(const Filling& filling) const {
    for (std::size_t a = 0; a < filling.size(); ++a) {
        for (std::size_t b = a + 1; b < filling.size(); ++b) {
            if (conflict(points_, triangle(filling[a]), triangle(filling[b]))) return true;
        }
    }
    return false;
}

void putFilling(RepairState& m, const HoleRing& ring, const Filling& filling) {
    const std::size_t count = ring.size() + 1;
    // The new side from one place of the ring to another, to find the twin of each.
    std::vector<HalfEdge> sides(count * count, kNone);
    for (std::size_t i = 0; i < filling.size(); ++i) {
        const RingTriangle& t = filling[i];
        const HalfEdge first =
            putTriangle(m, ring.gone, i, {ring.at(t[0]), ring.at(t[1]), ring.at(t[2])});
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge h = first + k;
            sides[t[k] * count + t[(k + 1) % 3]] = h;
            m.sideOf.set(ring.at(t[k]), h);
            m.queue.push_back(h);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            const HalfEdge h = sides[i * count + k];
            const bool isSide = i < ring.size() && (i + 1) % ring.size() == k;
            if (h != kNone) pair(m, h, isSide ? ring.outer[i] : sides[k * count + i]);
        }
    }
    const auto reused = static_cast<std::ptrdiff_t>(std::min(filling.size(), ring.gone.size()));
    dropTriangles(m, {ring.gone.begin() + reused, ring.gone.end()});
}

HoleRing patchOf(const RepairState& m, Index t) {
    const Triangle& c = m.triangles[t];
    return {{c.a, c.b, c.c}, {m.twin[3 * t], m.twin[3 * t + 1], m.twin[3 * t + 2]}, {t}, kNone};
}

namespace {

/// Grows a patch to this number of triangles, or as far as it goes.
void growTo(const RepairState& m, std::size_t size, HoleRing& patch) {
    for (std::size_t i = 0; i < patch.gone.size(); ++i) {
        for (Index k = 0; k < 3 && patch.gone.size() < size; ++k) {
            const auto side =
                std::find(patch.outer.begin(), patch.outer.end(), m.twin[3 * patch.gone[i] + k]);
            if (side != patch.outer.end())
                widenByTriangle(m, static_cast<std::size_t>(side - patch.outer.begin()), patch);
        }
    }
}

/// The triangles of a patch that its filling does not have.
Index countReplaced(const RepairState& m, const HoleRing& patch, const Filling& filling) {
    const auto isMade = [&](const Triangle& old) {
        return std::any_of(filling.begin(), filling.end(), [&](const RingTriangle& t) {
            const Triangle made{patch.at(t[0]), patch.at(t[1]), patch.at(t[2])};
            return fromLeastCorner(made) == fromLeastCorner(old);
        });
    };
    return static_cast<Index>(std::count_if(patch.gone.begin(), patch.gone.end(),
                                            [&](Index t) { return !isMade(m.triangles[t]); }));
}

}  // namespace

Index replacePatch(const PointSet& points, RepairState& m, HoleRing& patch,
                   std::span<const std::size_t> sizes) {
    std::size_t tried = 0;
    for (const std::size_t size : sizes) {
        growTo(m, size, patch);
        if (std::exchange(tried, patch.gone.size()) == patch.gone.size()) return 0;
        const Filling filling = FillingSearch(points, m, patch).find();
        if (filling.empty()) continue;
        const Index replaced = countReplaced(m, patch, filling);
        if (replaced == 0) continue;
        putFilling(m, patch, filling);
        return replaced;
    }
    return 0;
}

}  // namespace se
