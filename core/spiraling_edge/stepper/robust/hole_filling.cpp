/// The best filling of each part of the ring, from short parts to long ones: a triangle stands on
/// the edge from one end of a part to the other, and the parts on both sides of its third corner
/// are known (Barequet and Sharir 1995). Tried for the least angle first, then for the area.
#include "spiraling_edge/stepper/robust/hole_filling.h"

namespace se {

/// The best filling of each part of the ring, from one place to another.
template <typename Goal>
class FillingTable {
  public:
    explicit FillingTable(FillingSearch& search)
        : search_(search),
          count_(search.ring_.size()),
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

  private:
    static constexpr double kNoWay = 1e300;

    std::size_t at(std::size_t i, std::size_t k) const { return i * count_ + k; }

    void fillPart(std::size_t i, std::size_t k) {
        const std::vector<Index>& p = search_.ring_.points;
        const bool closing = i == 0 && k + 1 == count_;
        if (!closing && search_.staysJoined(p[i], p[k])) return;
        for (std::size_t j = i + 1; j < k; ++j) {
            const double before = costOf(i, j);
            const double after = costOf(j, k);
            if (before == kNoWay || after == kNoWay) continue;
            const Triangle made = search_.triangle({i, j, k});
            const double cost = Goal::sum(Goal::of(search_.points_, made), before, after);
            if (cost >= cost_[at(i, k)] || folds(made, i, j, k) || !search_.mayMake({i, j, k}))
                continue;
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
        return foldsAt(made, i, j) || foldsAt(made, j, k) ||
               (closing && search_.foldsOnto(made, search_.ring_.outer[k]));
    }
    bool foldsAt(const Triangle& made, std::size_t i, std::size_t k) const {
        if (k == i + 1) return search_.foldsOnto(made, search_.ring_.outer[i]);
        return folded(search_.points_, made, search_.triangle({i, middle_[at(i, k)], k}));
    }
    void collect(std::size_t i, std::size_t k, Filling& found) const {
        if (k == i + 1) return;
        const std::size_t j = middle_[at(i, k)];
        found.push_back({i, j, k});
        collect(i, j, found);
        collect(j, k, found);
    }

    FillingSearch& search_;
    std::size_t count_;
    std::vector<double> cost_;         ///< Of the best filling of a part.
    std::vector<std::size_t> middle_;  ///< Third corner of its triangle from end to end.
};

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
      known_(ring.size() * ring.size() * ring.size(), Known::Nothing) {}

Filling FillingSearch::find() {
    if (hasBlockedSide()) return {};
    Filling filling = FillingTable<LeastAngle>(*this).filling();
    if (!crossesItself(filling)) return filling;
    filling = FillingTable<Area>(*this).filling();
    return crossesItself(filling) ? Filling{} : filling;
}

/// True if visit(triangle) holds for one of the triangles at a side of the ring.
template <typename Visit>
bool FillingSearch::anyThird(std::size_t side, Visit&& visit) {
    const std::size_t next = (side + 1) % ring_.size();
    for (std::size_t third = 0; third < ring_.size(); ++third) {
        if (third == side || third == next) continue;
        RingTriangle t{side, next, third};
        std::sort(t.begin(), t.end());
        if (visit(t)) return true;
    }
    return false;
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
        const bool isSide = (from + 1) % ring_.size() == to;
        if (isSide ? foldsOnto(made, ring_.outer[from])
                   : staysJoined(ring_.points[from], ring_.points[to]))
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
    const std::size_t count = ring.size();
    // The new side from one place of the ring to another, to find the twin of each.
    std::vector<HalfEdge> sides(count * count, kNone);
    for (std::size_t i = 0; i < filling.size(); ++i) {
        const RingTriangle& t = filling[i];
        const HalfEdge first =
            putTriangle(m, ring.gone, i, {ring.points[t[0]], ring.points[t[1]], ring.points[t[2]]});
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge h = first + k;
            sides[t[k] * count + t[(k + 1) % 3]] = h;
            m.sideOf.set(ring.points[t[k]], h);
            m.queue.push_back(h);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            const HalfEdge h = sides[i * count + k];
            if (h != kNone) pair(m, h, (i + 1) % count == k ? ring.outer[i] : sides[k * count + i]);
        }
    }
    const auto reused = static_cast<std::ptrdiff_t>(std::min(filling.size(), ring.gone.size()));
    dropTriangles(m, {ring.gone.begin() + reused, ring.gone.end()});
}

}  // namespace se
