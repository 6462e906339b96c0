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
            if (cost >= cost_[at(i, k)] || folds(made, i, j, k) || search_.isFaulty({i, j, k}))
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
      known_(ring.size() * ring.size() * ring.size(), Known::Nothing) {
    // All triangles of a filling lie in the box of the ring.
    Box box(points.position[ring.points.front()]);
    for (const Index p : ring.points) box.add(points.position[p]);
    for (const Index t : trianglesNear(points, repair, ring.points)) {
        const Triangle& near = repair.triangles[t];
        const Box nearBox = boxOf(points, near);
        if (mayConflict(box, nearBox) && !isGone(ring, t)) near_.push_back({near, nearBox});
    }
}

Filling FillingSearch::find() {
    if (firstBlocked() < ring_.size()) return {};
    Filling filling = FillingTable<LeastAngle>(*this).filling();
    if (!crossesItself(filling)) return filling;
    filling = FillingTable<Area>(*this).filling();
    return crossesItself(filling) ? Filling{} : filling;
}

std::size_t FillingSearch::firstBlocked() {
    const std::size_t count = ring_.size();
    for (std::size_t side = 0; side < count; ++side) {
        const std::size_t next = (side + 1) % count;
        bool blocked = true;
        for (std::size_t third = 0; third < count && blocked; ++third) {
            if (third == side || third == next) continue;
            RingTriangle t{side, next, third};
            std::sort(t.begin(), t.end());
            blocked = !mayMake(t);
        }
        if (blocked) return side;
    }
    return count;
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

bool FillingSearch::isInConflict(const ShapedTriangle& made, NearRing& near) const {
    if (!near.shaped) {
        if (!mayConflict(made.box, near.box)) return false;
        near.shaped.emplace(points_, near.triangle);
    }
    return conflict(points_, made, *near.shaped);
}

/// True if a triangle has a fault by itself, or is in conflict with one that stays.
bool FillingSearch::findFault(const Triangle& made) {
    if (shapeFaults(points_, made) >= kFlippedFault || leastAngleCosine(points_, made) >= kThin)
        return true;
    const ShapedTriangle shaped(points_, made);
    // What is in the way of one triangle is in the way of most others at the same side.
    if (inTheWay_ < near_.size() && isInConflict(shaped, near_[inTheWay_])) return true;
    const auto found = std::find_if(near_.begin(), near_.end(),
                                    [&](NearRing& other) { return isInConflict(shaped, other); });
    if (found == near_.end()) return false;
    inTheWay_ = static_cast<std::size_t>(found - near_.begin());
    return true;
}

/// findFault(), once for each triangle.
bool FillingSearch::isFaulty(const RingTriangle& t) {
    Known& known = known_[(t[0] * ring_.size() + t[1]) * ring_.size() + t[2]];
    if (known == Known::Nothing) known = findFault(triangle(t)) ? Known::Faulty : Known::Sound;
    return known == Known::Faulty;
}

/// True if a triangle has no fault by itself, nor with those around the ring.
bool FillingSearch::mayMake(const RingTriangle& t) {
    const Triangle made = triangle(t);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = t[k];
        const std::size_t to = t[(k + 1) % 3];
        const bool isSide = (from + 1) % ring_.size() == to;
        if (isSide ? foldsOnto(made, ring_.outer[from])
                   : staysJoined(ring_.points[from], ring_.points[to]))
            return false;
    }
    return !isFaulty(t);
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
        const auto place =
            i < ring.gone.size() ? ring.gone[i] : static_cast<Index>(m.triangles.size());
        if (place == m.triangles.size()) {
            m.triangles.push_back({});
            m.twin.resize(m.twin.size() + 3, kNone);
        }
        const RingTriangle& t = filling[i];
        m.triangles.set(place, {ring.points[t[0]], ring.points[t[1]], ring.points[t[2]]});
        for (Index k = 0; k < 3; ++k) {
            const HalfEdge h = 3 * place + k;
            m.twin.set(h, kNone);
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
