/// Each function quotes the sentences that it is made of. "Not in the paper" marks the few places
/// where no sentence says what to do; docs/choices.md lists them.
#include "support/literal_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace se::test {
namespace literal {
namespace {

// "the status flag also acts as an instance counter so that any value of the flag greater than 0
// signals the USED state"
constexpr int kIsUnused = 0;
constexpr int kIsDone = -1;
// Not in the paper: an end where its rules have none.
constexpr std::size_t kMostTrianglesPerPoint = 8;
// Not in the paper: equal up to rounding, of cosines and of squared lengths.
constexpr double kRounding = 1e-12;

/// "a doubly linked ring of elements containing pointers to the points"
struct Element {
    Index point = kNone;
    Element* previous = nullptr;
    Element* next = nullptr;
};

/// "If n . v >= 0, then theta is set to the arccosine of z . v, otherwise theta is set to 2 pi
/// minus the arccosine of z . v." The arccosine is left out, since it costs half of the digits.
struct Angle {
    double cosine = 1.0;
    bool beyondHalf = false;

    /// Grows as theta does: 1 - cos theta up to 180 degrees, 3 + cos theta beyond; from 0 to 4.
    double turn() const { return beyondHalf ? 3.0 + cosine : 1.0 - cosine; }
    double sine() const {
        const double size = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        return beyondHalf ? -size : size;
    }
};
constexpr double kHalf = 2.0;  // The turn of 180 degrees.
constexpr Angle kZero{1.0, false};
constexpr Angle kFull{1.0, true};

bool isSame(const Angle& a, const Angle& b) { return std::abs(a.turn() - b.turn()) <= kRounding; }
bool isBetween(const Angle& x, const Angle& from, const Angle& to) {
    return x.turn() > from.turn() && x.turn() < to.turn() && !isSame(x, from) && !isSame(x, to);
}
/// "an angle difference between s and t of more than 120 degrees": its cosine is below -1/2.
bool isOver120(const Angle& t, const Angle& s) {
    if (s.turn() - t.turn() > kHalf) return true;
    return t.cosine * s.cosine + t.sine() * s.sine() < -0.5;
}

/// A neighbor in the neighbor ring.
struct Neighbor {
    Index point = kNone;
    Angle angle;
};

class LiteralRun {
  public:
    LiteralRun(const PointSet& points, const GivenStart& start)
        : points_(points), status_(points.size(), kIsUnused) {
        begin(start);
    }
    std::vector<PivotTriangles> all() {
        // "Repeat until All Points are USED: Initialize Edge Ring, While Edge Ring Not Empty ..."
        while (pivot_ != nullptr || takeRingFromStack() || initializeEdgeRing()) {
            triangulateAtPivot();
            if (made_ > kMostTrianglesPerPoint * points_.size()) break;
        }
        return std::move(pivots_);
    }

  private:
    const Vec3& at(Index p) const { return points_.position[p]; }
    const Vec3& at(const Element* e) const { return at(e->point); }
    const Vec3& normal(Index p) const { return points_.normal[p]; }

    // ---- rings ----------------------------------------------------------------------------------

    Element* insertAfter(Element* place, Index point) {
        elements_.push_back(std::make_unique<Element>());
        Element* made = elements_.back().get();
        made->point = point;
        made->previous = place == nullptr ? made : place;
        made->next = place == nullptr ? made : place->next;
        made->previous->next = made;
        made->next->previous = made;
        return made;
    }
    static void takeOut(Element* e) {
        e->previous->next = e->next;
        e->next->previous = e->previous;
    }
    static std::size_t length(const Element* ring) {
        std::size_t count = 1;
        for (const Element* e = ring->next; e != ring; e = e->next) ++count;
        return count;
    }
    /// "When a point is removed from the edge ring, its status flag is decremented. If the status
    /// flag is equal to 1 prior to a decrement ..., the status flag is set to DONE instead."
    void remove(Element* e) {
        takeOut(e);
        int& status = status_[e->point];
        status = status == 1 ? kIsDone : status - 1;
    }

    // ---- section 4 ------------------------------------------------------------------------------

    void begin(const GivenStart& start) {
        made_ = start.triangles.size();
        for (const Index p : start.done) status_[p] = kIsDone;
        for (const auto& ring : start.rings) {
            Element* head = nullptr;
            for (const Index p : ring) {
                Element* e = insertAfter(head == nullptr ? nullptr : head->previous, p);
                if (head == nullptr) head = e;
                ++status_[p];
            }
            if (pivot_ != nullptr) stack_.push_back(pivot_);
            pivot_ = head;
        }
    }

    /// "the algorithm inserts the first point that it finds that is not set to DONE, and the
    /// point's nearest neighbor that is not DONE"; points that "either do not have any neighbors or
    /// whose neighbors are all DONE" it "marks ... as DONE and it continues the search".
    bool initializeEdgeRing() {
        for (; startPointer_ < points_.size(); ++startPointer_) {
            const Index p = points_.inOrder(startPointer_);
            if (status_[p] == kIsDone) continue;
            for (const Index q : points_.neighbors[p]) {
                if (status_[q] == kIsDone) continue;
                pivot_ = insertAfter(nullptr, p);
                insertAfter(pivot_, q);
                status_[p] = status_[q] = 1;
                circuit_ = 0;
                return true;
            }
            status_[p] = kIsDone;
        }
        return false;
    }

    // ---- sections 5 and 7 -----------------------------------------------------------------------

    void triangulateAtPivot() {
        pivots_.push_back({pivot_->point, {}});
        Element* third = nullptr;
        const bool isPivot = !isBoundary(points_.type[pivot_->point]) || isBoundaryPivot(third);
        if (isPivot && triangulateVertexRing()) {
            circuit_ = 0;
            return;
        }
        // Not in the paper: a third point without a triangle is UNUSED again.
        if (third != nullptr) {
            takeOut(third);
            status_[third->point] = kIsUnused;
        }
        // "the algorithm leaves all the boundary points in the edge ring until it makes a complete
        // circuit of the edge ring without any new triangles being added. Then the algorithm marks
        // the boundary points as DONE and frees the edge ring". Not in the paper: interior points
        // too.
        if (++circuit_ < length(pivot_)) {
            pivot_ = pivot_->next;
            return;
        }
        while (pivot_->next != pivot_) remove(pivot_->next);
        remove(pivot_);
        pivot_ = nullptr;
    }

    /// "First, we avoid using boundary points as pivot points with only a few exceptions."
    bool isBoundaryPivot(Element*& third) {
        const std::uint8_t p = points_.type[pivot_->point];
        const std::uint8_t next = points_.type[pivot_->next->point];
        const std::uint8_t previous = points_.type[pivot_->previous->point];
        // 7.1: "Edge Ring Consists of Two Boundary Points"
        if (length(pivot_) == 2) {
            if (!isOnWall(next)) return false;
            third = insertThird(isThirdBefore());
            return third != nullptr;
        }
        // 7.2: "the edge ring has adjacent points whose types indicate a transition from one
        // surface boundary to another"; Figure 18: r before p on the way into a corner, Figure 19:
        // after it.
        const auto isChange = [](std::uint8_t a, std::uint8_t b) {
            return isOnWall(a) && isOnWall(b) && (a & b & kFaceBits) == 0;
        };
        if (isChange(p, next)) third = insertThird(true);
        if (third == nullptr && isChange(previous, p)) third = insertThird(false);
        return third != nullptr;
    }

    /// "The algorithm takes the cross product of the normal at p and a vector between p and the
    /// second point in the edge ring. ... The third point is inserted before p if ... p lies on a
    /// minimum surface boundary and the corresponding component of the cross product vector is
    /// negative, or p lies on a maximum surface boundary and the corresponding component of the
    /// cross product vector is positive. Otherwise, the third point is inserted after p."
    bool isThirdBefore() const {
        const Index p = pivot_->point;
        const Vec3 cross = glm::cross(normal(p), at(pivot_->next) - at(p));
        const std::uint8_t type = points_.type[p];
        return ((type & kPositiveX) != 0 && cross.x > 0.0) ||
               ((type & kPositiveY) != 0 && cross.y > 0.0) ||
               ((type & kPositiveZ) != 0 && cross.z > 0.0) ||
               ((type & kNegativeX) != 0 && cross.x < 0.0) ||
               ((type & kNegativeY) != 0 && cross.y < 0.0) ||
               ((type & kNegativeZ) != 0 && cross.z < 0.0);
    }

    /// "the algorithm searches p's neighbors for a third point that is UNUSED and has a boundary
    /// edge in common with p"
    Element* insertThird(bool before) {
        const Index p = pivot_->point;
        for (const Index x : points_.neighbors[p]) {
            const bool common = (points_.type[p] & points_.type[x] & kFaceBits) != 0;
            if (status_[x] != kIsUnused || !common) continue;
            status_[x] = 1;
            return insertAfter(before ? pivot_->previous : pivot_, x);
        }
        return nullptr;
    }

    // ---- section 6 ------------------------------------------------------------------------------

    /// True if the pivot has triangles, and the ring has been updated.
    bool triangulateVertexRing() {
        first_ = start_ = pivot_->previous;
        last_ = end_ = pivot_->next;
        startAngle_ = kZero;
        // "When the first and last points are the same, the ending angle is 2 pi."
        endAngle_ = lastAngle_ = first_->point == last_->point
                                     ? kFull
                                     : angleAt(pivot_->point, first_->point, last_->point);
        sortNeighbors();
        moveStartAndEnd();
        testConvexity();
        testUsedPoints();
        fillHole();
        removeNeighbors();
        if (overlaps()) return false;
        triangulate();
        updateEdgeRing();
        return true;
    }

    /// 6.1: the angle at p from the vector to `first` to the vector to x: "n", the "cross product
    /// of z and p's normals", so that angles grow counterclockwise as in 6.4.
    Angle angleAt(Index p, Index first, Index x) const {
        const Vec3 z = (at(first) - at(p)) / glm::distance(at(first), at(p));
        const Vec3 v = at(x) - at(p);  // Not normalized: no rounding changes the sign of n . v.
        const Vec3 n = glm::cross(normal(p), z);
        const double cosine = std::clamp(glm::dot(z, v) / glm::length(v), -1.0, 1.0);
        return {cosine, glm::dot(n, v) < 0.0};
    }

    /// "Using z, the algorithm sorts all of the neighboring points by angle into a ring around the
    /// pivot point. If two neighboring points are found to have the same angle, the point closest
    /// to p is included in the ring and the other point is eliminated from consideration."
    void sortNeighbors() {
        ring_.clear();
        for (const Index x : points_.neighbors[pivot_->point]) {
            // "even if a DONE point has neighbor links to points that are not DONE, it cannot be a
            // candidate in their triangulations"
            if (status_[x] == kIsDone || x == first_->point || x == last_->point) continue;
            const Angle angle = angleAt(pivot_->point, first_->point, x);
            // "The ending angle prevents including neighboring points in the ring ..."
            if (isBetween(angle, kZero, endAngle_)) ring_.push_back({x, angle});
        }
        std::stable_sort(ring_.begin(), ring_.end(), [](const Neighbor& a, const Neighbor& b) {
            return a.angle.turn() < b.angle.turn();
        });
        for (std::size_t i = 0; i + 1 < ring_.size();) {
            if (!isSame(ring_[i].angle, ring_[i + 1].angle)) {
                ++i;
                continue;
            }
            const bool nextIsCloser = glm::distance(at(ring_[i + 1].point), at(pivot_)) <
                                      glm::distance(at(ring_[i].point), at(pivot_));
            ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(nextIsCloser ? i : i + 1));
        }
    }

    /// The edge ring is concave at the middle one of three of its points.
    bool isConcave(const Element* before, const Element* middle, const Element* after) const {
        const Vec3 cross = glm::cross(at(before) - at(middle), at(after) - at(middle));
        return glm::dot(cross, normal(middle->point)) > 0.0;
    }
    bool isConcaveAtStart() const { return isConcave(start_->previous, start_, pivot_); }
    bool isConcaveAtEnd() const { return isConcave(pivot_, end_, end_->next); }

    /// "If as the algorithm adds in q, it finds that q is already on the edge ring, q is adjacent
    /// to the point pointed to by start, and the edge ring is concave at this point. The algorithm
    /// then advances the start pointer to point to q. ... Similarly, the algorithm moves the end
    /// pointer when it adds t to the neighbor ring." Points outside of "the angle limits formed by
    /// the new start and end points" are excluded, or removed if they were included.
    void moveStartAndEnd() {
        for (const Index q : points_.neighbors[pivot_->point]) {
            const auto added = std::find_if(ring_.begin(), ring_.end(),
                                            [&](const Neighbor& x) { return x.point == q; });
            if (added == ring_.end() || !isBetween(added->angle, startAngle_, endAngle_)) continue;
            if (q == start_->previous->point && start_->previous != end_ && isConcaveAtStart()) {
                start_ = start_->previous;
                startAngle_ = added->angle;
            } else if (q == end_->next->point && end_->next != start_ && isConcaveAtEnd()) {
                end_ = end_->next;
                endAngle_ = added->angle;
            }
        }
        std::erase_if(ring_, [&](const Neighbor& x) {
            return x.point == start_->point || x.point == end_->point ||
                   !isBetween(x.angle, startAngle_, endAngle_);
        });
    }

    /// "The convexity test eliminates point 2 from the neighbor ring because point 2 is the next
    /// point on the edge list after the point pointed to by start (point 1) and 1 is convex." It
    /// "only applies to points in the edge ring that are adjacent to the points pointed to by start
    /// or end".
    void testConvexity() {
        std::erase_if(ring_, [&](const Neighbor& x) {
            return (x.point == start_->previous->point && !isConcaveAtStart()) ||
                   (x.point == end_->next->point && !isConcaveAtEnd());
        });
    }

    /// "the edge point e is treated as the pivot point and the angles formed by the preceding and
    /// succeeding points on the edge list (elast and efirst) are calculated. ... If p could be
    /// included in e's hypothetical neighbor ring, then e is included in p's neighbor ring." Not in
    /// the paper: of several elements of e, any will do.
    void testUsedPoints() {
        std::erase_if(ring_, [&](const Neighbor& x) {
            if (status_[x.point] == kIsUnused) return false;
            return !isAnyElement(x.point, [&](const Element* e) {
                const Index efirst = e->next->point;
                const Index elast = e->previous->point;
                const Angle limit = efirst == elast ? kFull : angleAt(e->point, efirst, elast);
                return isBetween(angleAt(e->point, efirst, pivot_->point), kZero, limit);
            });
        });
    }

    /// True if `holds` of an element of the point on any ring.
    template <typename Holds>
    bool isAnyElement(Index point, Holds&& holds) const {
        std::vector<Element*> rings = stack_;
        rings.push_back(pivot_);
        for (Element* ring : rings) {
            Element* e = ring;
            do {
                if (e->point == point && holds(e)) return true;
                e = e->next;
            } while (e != ring);
        }
        return false;
    }

    /// "The algorithm constructs a plane by taking the cross product of the vector between first
    /// and last and the average normal of p, first and last. Only those points that are on the same
    /// side of the plane as p are kept in the neighbor ring."
    void fillHole() {
        // "a hole formed by p, first, and last"
        if (length(pivot_) != 3 || first_->point == last_->point) return;
        const Vec3 average = normal(pivot_->point) + normal(first_->point) + normal(last_->point);
        const Vec3 plane = glm::cross(at(last_) - at(first_), average);
        const auto side = [&](const Vec3& x) { return glm::dot(plane, x - at(first_)); };
        const double sideOfP = side(at(pivot_));
        std::erase_if(ring_, [&](const Neighbor& x) {
            const double sideOfX = side(at(x.point));
            return !((sideOfP > 0.0 && sideOfX > 0.0) || (sideOfP < 0.0 && sideOfX < 0.0));
        });
    }

    /// "A circumcircle is formed using points p, s, and t. ... The algorithm finds the distance d
    /// in three-dimensions between the center and q, and compares this to the radius of the
    /// circumcircle r. If q falls inside the circumsphere or its removal would create an angle
    /// difference between s and t of more than 120 degrees, q must be kept. Otherwise, q is removed
    /// ... and the evaluation moves on to point s." Start and end stay: the fan is between them.
    void removeNeighbors() {
        Neighbor t{start_->point, startAngle_};
        for (std::size_t i = 0; i < ring_.size();) {
            const Neighbor s =
                i + 1 < ring_.size() ? ring_[i + 1] : Neighbor{end_->point, endAngle_};
            if (isInsideSphere(t.point, ring_[i].point, s.point) || isOver120(t.angle, s.angle)) {
                t = ring_[i++];
            } else {
                ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }
    /// The circumcenter after Hill: of u and v from p, (v^2 u - u^2 v) x (u x v) / 2 |u x v|^2 with
    /// the sign that makes it equidistant. Not in the paper: in line, there is no circle, and q is
    /// kept.
    bool isInsideSphere(Index t, Index q, Index s) const {
        const Vec3 u = at(t) - at(pivot_);
        const Vec3 v = at(s) - at(pivot_);
        const Vec3 x = at(q) - at(pivot_);
        const Vec3 across = glm::cross(u, v);
        const double sineSq = glm::dot(across, across);
        if (!(sineSq > 1e-20 * glm::dot(u, u) * glm::dot(v, v))) return true;
        const Vec3 center =
            glm::cross(glm::dot(u, u) * v - glm::dot(v, v) * u, across) / (2.0 * sineSq);
        const double dSq = glm::dot(x - center, x - center);
        const double rSq = glm::dot(center, center);
        return dSq - rSq < -kRounding * glm::dot(x, x);
    }

    /// "if the neighbor ring consists of only two points and the angle they form around the pivot
    /// point is greater than 180 degrees ... the neighbor ring will be discarded"
    bool overlaps() const {
        const bool onlyTwo = ring_.empty() && start_ == first_ && end_ == last_;
        return onlyTwo && lastAngle_.turn() > kHalf;
    }

    /// "Triangulation consists of traversing the neighbor ring from first to last using two
    /// adjacent points on the neighbor ring at a time."
    void triangulate() {
        std::vector<Index> all;
        for (const Element* e = first_; e != start_; e = e->previous) all.push_back(e->point);
        all.push_back(start_->point);
        for (const Neighbor& x : ring_) all.push_back(x.point);
        const std::size_t fromEnd = all.size();
        for (const Element* e = last_; e != end_; e = e->next) all.push_back(e->point);
        all.push_back(end_->point);
        std::reverse(all.begin() + static_cast<std::ptrdiff_t>(fromEnd), all.end());
        for (std::size_t i = 0; i + 1 < all.size(); ++i)
            pivots_.back().triangles.push_back({pivot_->point, all[i], all[i + 1]});
        made_ += all.size() - 1;
    }

    // ---- section 6.5 ----------------------------------------------------------------------------

    /// "the pivot point is removed from this section of the edge ring ... all of the points before
    /// start and after end in the neighbor ring that are duplicated in the edge ring need to be
    /// removed from this section of the edge ring ... the remainder of the points in the neighbor
    /// ring, excluding the points pointed to by start and end, are inserted in counterclockwise
    /// order into the edge ring ... the new point is the point that had been the end particle".
    void updateEdgeRing() {
        remove(pivot_);
        while (first_ != start_) remove(std::exchange(first_, first_->previous));
        while (last_ != end_) remove(std::exchange(last_, last_->next));
        pivot_ = end_;
        std::vector<Element*> found;
        Element* place = start_;
        for (const Neighbor& x : ring_) {
            place = insertAfter(place, x.point);
            if (++status_[x.point] > 1) found.push_back(place);
        }
        for (Element* x : found) meetAgain(x);
    }

    /// "If a point is encountered that is already USED, the first other instance of the point in
    /// the edge ring is located. ... If the other instance is in the active edge ring, the edge
    /// ring is split into two rings and one of the rings is pushed onto a stack. ... If the other
    /// instance is not found in the active edge ring, the stack of edge rings is searched in top
    /// down order ... the two edge rings are joined into a single edge ring with the shared edge
    /// ring point appearing twice in the same ring." Not in the paper: both by an exchange of
    /// successors, and a pushed ring goes on at the point where it was split off. The ring of end
    /// stays: it has the next pivot.
    void meetAgain(Element* x) {
        for (Element* y = x->next; y != x; y = y->next) {
            if (y->point != x->point) continue;
            exchangeSuccessors(x, y);
            stack_.push_back(x);
            return;
        }
        for (std::size_t i = stack_.size(); i-- > 0;) {
            Element* y = stack_[i];
            do {
                if (y->point == x->point) {
                    exchangeSuccessors(x, y);
                    stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(i));
                    return;
                }
                y = y->next;
            } while (y != stack_[i]);
        }
    }
    static void exchangeSuccessors(Element* x, Element* y) {
        std::swap(x->next, y->next);
        x->next->previous = x;
        y->next->previous = y;
    }

    bool takeRingFromStack() {
        if (stack_.empty()) return false;
        pivot_ = stack_.back();
        stack_.pop_back();
        circuit_ = 0;
        return true;
    }

    const PointSet& points_;
    std::vector<int> status_;
    std::vector<std::unique_ptr<Element>> elements_;
    std::vector<Element*> stack_;
    Element* pivot_ = nullptr;
    std::size_t startPointer_ = 0;
    std::size_t circuit_ = 0;
    std::size_t made_ = 0;
    std::vector<PivotTriangles> pivots_;

    Element* first_ = nullptr;
    Element* last_ = nullptr;
    Element* start_ = nullptr;
    Element* end_ = nullptr;
    Angle startAngle_;
    Angle endAngle_;
    Angle lastAngle_;
    std::vector<Neighbor> ring_;  ///< Between start and end.
};

}  // namespace
}  // namespace literal

std::vector<PivotTriangles> literalRun(const PointSet& points, const GivenStart& start) {
    return literal::LiteralRun(points, start).all();
}

}  // namespace se::test
