/// The best filling of each part of the ring, found once, when it is asked for: a triangle stands
/// on the edge from one end of the part to the other, with the best fillings of the parts on both
/// sides of its third corner (Barequet and Sharir 1995). Tried for the least angle first, then for
/// the area; around a point inside, for the least angle alone.
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

/// The best filling of each part of the ring, from a place on to another. With a point inside, the
/// parts go on beyond the last place.
template <typename Goal>
class FillingTable {
  public:
    explicit FillingTable(FillingSearch& search)
        : search_(search),
          count_(search.ring_.size()),
          cost_(count_ * count_, kUnknown),
          middle_(count_ * count_, 0) {}
    /// The best filling without the point inside.
    Filling filling() {
        Filling found;
        if (costOf(0, count_ - 1) < kNoWay) collect(0, count_ - 1, found);
        return found;
    }
    /// The best filling around the point inside with a triangle at the side before a place, and its
    /// cost; none if that is not below `most`.
    std::pair<double, Filling> fillingAround(std::size_t first, double most);

  private:
    static constexpr double kNoWay = 1e300;
    static constexpr double kUnknown = -1e300;

    std::size_t at(std::size_t i, std::size_t k) const { return i % count_ * count_ + k - i; }

    /// The cost of the best filling of a part, found when it is asked for; kNoWay if there is none.
    double costOf(std::size_t i, std::size_t k) {
        if (k == i + 1) return Goal::kNone;
        if (cost_[at(i, k)] == kUnknown) {
            cost_[at(i, k)] = kNoWay;
            fillPart(i, k);
        }
        return cost_[at(i, k)];
    }
    void fillPart(std::size_t i, std::size_t k) {
        if (!isClosing(i, k) && search_.staysJoined(i % count_, k % count_)) return;
        double least = kNoWay;
        for (std::size_t j = i + 1; j < k; ++j) {
            const Triangle made = triangle(i, j, k);
            const double own = Goal::of(search_.points_, made);
            if (!(own < least) || !search_.isFit(placesOf(i, j, k))) continue;
            const double cost = Goal::sum(own, costOf(i, j), costOf(j, k));
            if (!(cost < least) || folds(made, i, j, k) || !mayMake(i, j, k)) continue;
            least = cost_[at(i, k)] = cost;
            middle_[at(i, k)] = j - i;
        }
    }
    /// True if the edge from end to end is a side of the ring.
    bool isClosing(std::size_t i, std::size_t k) const { return k - i + 1 == count_; }
    std::size_t middleOf(std::size_t i, std::size_t k) const { return i + middle_[at(i, k)]; }
    /// True if the triangle is folded onto one at its sides.
    bool folds(const Triangle& made, std::size_t i, std::size_t j, std::size_t k) const {
        return foldsAt(made, i, j) || foldsAt(made, j, k) ||
               (isClosing(i, k) && foldsOutside(made, k));
    }
    bool foldsAt(const Triangle& made, std::size_t i, std::size_t k) const {
        if (k == i + 1) return foldsOutside(made, i);
        return folded(search_.points_, made, triangle(i, middleOf(i, k), k));
    }
    bool foldsOutside(const Triangle& made, std::size_t side) const {
        return search_.foldsOnto(made, search_.ring_.outer[side % count_]);
    }
    void collect(std::size_t i, std::size_t k, Filling& found) const {
        if (k == i + 1) return;
        const std::size_t j = middleOf(i, k);
        found.push_back(placesOf(i, j, k));
        collect(i, j, found);
        collect(j, k, found);
    }

    /// The triangle of three places, from the least one on.
    RingTriangle placesOf(std::size_t i, std::size_t j, std::size_t k) const {
        return fromLeastPlace({i % count_, j % count_, k % count_});
    }
    Triangle triangle(std::size_t i, std::size_t j, std::size_t k) const {
        return search_.triangle({i % count_, j % count_, k % count_});
    }
    bool mayMake(std::size_t i, std::size_t j, std::size_t k) const {
        return search_.mayMake(placesOf(i, j, k));
    }
    /// The triangle between two places and the point inside.
    RingTriangle placesInside(std::size_t i, std::size_t k) const {
        return fromLeastPlace({i % count_, k % count_, count_});
    }
    Triangle inside(std::size_t i, std::size_t k) const {
        return search_.triangle({i % count_, k % count_, count_});
    }

    FillingSearch& search_;
    std::size_t count_;
    // Per start of a part and number of its sides, of the best filling:
    std::vector<double> cost_;
    std::vector<std::size_t> middle_;  ///< Sides up to the third corner of the triangle at the end.
};

template <typename Goal>
std::pair<double, Filling> FillingTable<Goal>::fillingAround(std::size_t first, double most) {
    const std::size_t last = first + count_ - 1;
    const Triangle closing = inside(last, first);
    const double closingCost = Goal::of(search_.points_, closing);
    const std::pair<double, Filling> none{kNoWay, {}};
    if (!(closingCost < most) || !search_.mayMake(placesInside(last, first)) ||
        foldsOutside(closing, last))
        return none;
    // Per place from the first on, of the triangles around the point up to there, with the parts
    // beyond them.
    std::vector<double> cost(count_, most);
    std::vector<std::size_t> previous(count_, first);
    cost[0] = Goal::kNone;
    const auto foldsOntoPrevious = [&](const Triangle& made, std::size_t i) {
        return i > first && folded(search_.points_, made, inside(previous[i - first], i));
    };
    for (std::size_t k = first + 1; k <= last; ++k) {
        double& least = cost[k - first];
        for (std::size_t i = first; i < k; ++i) {
            // Around the point are three triangles or more, so that no part is the whole ring.
            if (isClosing(i, k) || cost[i - first] >= most) continue;
            const Triangle made = inside(i, k);
            const double own =
                Goal::sum(Goal::of(search_.points_, made), cost[i - first], Goal::kNone);
            if (!(own < least) || !search_.isFit(placesInside(i, k))) continue;
            const double sum = Goal::sum(own, costOf(i, k), Goal::kNone);
            if (!(sum < least) || foldsAt(made, i, k) || foldsOntoPrevious(made, i) ||
                !search_.mayMake(placesInside(i, k)))
                continue;
            least = sum;
            previous[k - first] = i;
        }
    }
    if (cost.back() >= most || foldsOntoPrevious(closing, last)) return none;
    Filling found{placesInside(last, first)};
    for (std::size_t k = last; k > first; k = previous[k - first]) {
        const std::size_t i = previous[k - first];
        found.push_back(placesInside(i, k));
        collect(i, k, found);
        if (i == first && folded(search_.points_, closing, inside(i, k))) return none;
    }
    return {Goal::sum(closingCost, cost.back(), Goal::kNone), found};
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
      known_((ring.size() + 1) * (ring.size() + 1) * (ring.size() + 1), Known::Nothing),
      joined_((ring.size() + 1) * (ring.size() + 1)) {}

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
    FillingTable<LeastAngle> table(*this);
    for (std::size_t first = 0; first < ring_.size(); ++first) {
        auto [cost, filling] = table.fillingAround(first, least);
        if (filling.empty() || crossesItself(filling)) continue;
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

/// True if a triangle that stays has an edge between the points at two places.
bool FillingSearch::staysJoined(std::size_t u, std::size_t v) {
    std::optional<bool>& known = joined_[std::min(u, v) * (ring_.size() + 1) + std::max(u, v)];
    if (!known) known = findStaying(ring_.at(std::min(u, v)), ring_.at(std::max(u, v)));
    return *known;
}
bool FillingSearch::findStaying(Index u, Index v) const {
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
bool FillingSearch::fits(const RingTriangle& t) {
    const Triangle made = triangle(t);
    if (shapeFaults(points_, made) >= kFlippedFault || leastAngleCosine(points_, made) >= kThin)
        return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = t[k];
        const std::size_t to = t[(k + 1) % 3];
        const bool isSide = from < ring_.size() && (from + 1) % ring_.size() == to;
        if (isSide ? foldsOnto(made, ring_.outer[from]) : staysJoined(from, to)) return false;
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
