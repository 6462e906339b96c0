/// Small hand-made inputs with explicit neighbor lists and a State with given rings, so that a test
/// can begin right before the rule that it is about.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::test {

inline Params paper() { return *paramsByName("paper"); }
inline Params robust() { return *paramsByName("robust"); }
inline Params printed() { return *paramsByName("printed"); }
/// `paper` with one rule inverted.
inline Params paperBut(bool Readings::*reading) {
    Params params = paper();
    params.readings.*reading = !(params.readings.*reading);
    return params;
}
inline Params paperBut(bool RobustRules::*rule) {
    Params params = paper();
    params.robust.*rule = !(params.robust.*rule);
    return params;
}

/// Names in tests: short lists of points and triangles.
using Points = std::vector<Index>;
using Triangles = std::vector<Triangle>;

/// Interior points with the same normal, and with these lists.
inline PointSet pointsAt(std::vector<Vec3> position, const std::vector<Points>& lists = {},
                         const Vec3& normal = {0, 0, 1}) {
    PointSet points;
    points.position = std::move(position);
    points.normal.assign(points.size(), normal);
    points.type.assign(points.size(), kInterior);
    for (const Points& list : lists) points.neighbors.append(list);
    return points;
}

inline std::vector<Index> ringFrom(const State& s, Index entry) {
    std::vector<Index> points;
    const Index length = s.rings.length(s.rings.ringOf(entry));
    for (Index i = 0; i < length; ++i, entry = s.rings.next(entry)) {
        points.push_back(s.rings.point(entry));
    }
    return points;
}

/// Points with normals up unless set. The finished patch lies left of a ring's direction, so at a
/// pivot the free sector runs counterclockwise from the point before it on the ring to the point
/// after it.
class Rig {
  public:
    explicit Rig(std::vector<Vec3> position, Params params = paper()) : params_(params) {
        points_.position = std::move(position);
        points_.normal.assign(points_.size(), Vec3(0, 0, 1));
        points_.type.assign(points_.size(), kInterior);
        lists_.resize(points_.size());
        state_ = State(points_.size());
        if (params.robust.needsEdges()) state_.edges = EdgeTable(points_.size());
    }
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    /// The list of p, put in order of distance.
    Rig& list(Index p, std::vector<Index> others) {
        const auto distanceSq = [&](Index x) {
            const Vec3 d = points_.position[x] - points_.position[p];
            return glm::dot(d, d);
        };
        std::stable_sort(others.begin(), others.end(),
                         [&](Index a, Index b) { return distanceSq(a) < distanceSq(b); });
        return rawList(p, std::move(others));
    }
    /// The list of p, in the order given.
    Rig& rawList(Index p, std::vector<Index> others) {
        lists_[p] = std::move(others);
        return *this;
    }
    /// Every point lists all others.
    Rig& listAll() {
        for (Index p = 0; p < points_.size(); ++p) {
            std::vector<Index> others;
            for (Index q = 0; q < points_.size(); ++q) {
                if (q != p) others.push_back(q);
            }
            list(p, std::move(others));
        }
        return *this;
    }
    Rig& type(Index p, unsigned faces) {
        points_.type[p] = withCornerBit(static_cast<std::uint8_t>(faces));
        return *this;
    }
    /// A rim point with its gap, counterclockwise between two of its neighbors.
    Rig& rim(Index p, const RimGap& gap) {
        points_.type[p] = kRimPoint;
        points_.rim.resize(points_.size());
        points_.rim[p] = gap;
        return *this;
    }
    Rig& normal(Index p, const Vec3& n) {
        points_.normal[p] = n / std::sqrt(glm::dot(n, n));
        return *this;
    }
    /// Puts a ring on top of the stack; its steps are mesh edges. Its entries are newer than those
    /// of the rings made before, the active one included.
    Rig& stacked(const std::vector<Index>& points) {
        EdgeRings& rings = state_.rings;
        const Index active = rings.active();
        const Index head = addRing(state_, points);
        rings.push(rings.ringOf(head), head);
        if (active != kNone) rings.activate(active);
        return *this;
    }
    /// The active ring, the pivot first; its steps are mesh edges.
    Rig& ring(const std::vector<Index>& points) {
        state_.pivot.pivot = addRing(state_, points);
        state_.phase = Phase::Pivot;
        return *this;
    }
    /// Existing triangles. They do not change status or rings.
    Rig& mesh(const std::vector<Triangle>& triangles) {
        addTriangles(state_, triangles);
        given_ = triangles.size();
        return *this;
    }
    /// Begins with another phase than that of a pivot.
    Rig& startAt(Phase phase) {
        state_.phase = phase;
        return *this;
    }
    /// As if some circuits, and this many pivots of the next one, had brought no triangle.
    Rig& retryLevel(std::uint32_t circuits, Index pivots) {
        state_.retryLevel = circuits;
        state_.circuit = pivots;
        return *this;
    }
    Rig& done(const std::vector<Index>& points) {
        for (const Index p : points) state_.status[p] = kDone;
        return *this;
    }
    /// The steps that leave the entries of `point`, or only those to `next`, are no mesh edges.
    Rig& open(Index point, Index next = kNone) {
        openSteps(state_, {point, next});
        return *this;
    }

    /// Runs phases until `phase` is next. False if it never is in this pivot.
    bool runTo(Phase phase) {
        for (int i = 0; i < 20; ++i) {
            if (state().phase == phase) return true;
            stepper().advance();
        }
        return false;
    }
    Rig& pivot() {
        stepper().stepPivot();
        return *this;
    }
    Rig& run() {
        stepper().run();
        return *this;
    }

    const State& state() { return stepper().state(); }
    const PointSet& points() { return stepper().points(); }
    const std::vector<Triangle>& triangles() { return state().triangles; }
    /// The triangles that were not given.
    std::vector<Triangle> newTriangles() {
        const auto& all = triangles();
        return {all.begin() + static_cast<std::ptrdiff_t>(given_), all.end()};
    }
    PointStatus status(Index p) { return state().status[p]; }
    /// Points of the active ring from the pivot on.
    std::vector<Index> activeRing() { return ringFrom(state(), state().pivot.pivot); }
    /// Points of a stacked ring from its head on; 0 is the top.
    std::vector<Index> stackedRing(std::size_t depth = 0) {
        const auto& stack = state().rings.stack();
        return ringFrom(state(), state().rings.head(stack[stack.size() - 1 - depth]));
    }
    std::vector<Index> candidates() {
        std::vector<Index> result;
        for (const Candidate& c : state().pivot.candidates) result.push_back(c.point);
        return result;
    }
    Index startPoint() { return state().rings.point(state().pivot.start); }
    Index endPoint() { return state().rings.point(state().pivot.end); }

    const EventLog& log() const { return log_; }
    /// All evidence of one kind so far.
    template <typename E>
    std::vector<E> all() const {
        std::vector<E> found;
        for (const Event& event : log_.events()) {
            if (const E* e = std::get_if<E>(&event.evidence)) found.push_back(*e);
        }
        return found;
    }
    /// The last verdict on `point` in evidence of one kind.
    template <typename E>
    std::optional<Verdict> verdictOn(Index point) const {
        std::optional<Verdict> verdict;
        for (const E& e : all<E>()) {
            if (pointOf(e) == point) verdict = e.verdict;
        }
        return verdict;
    }

  private:
    template <typename E>
    static Index pointOf(const E& e) {
        if constexpr (requires { e.q; }) {
            return e.q;
        } else if constexpr (requires { e.to; }) {
            return e.to;
        } else {
            return e.point;
        }
    }

    Stepper& stepper() {
        if (!stepper_) {
            for (const auto& one : lists_) points_.neighbors.append(one);
            stepper_.emplace(points_, params_, &log_);
            stepper_->setState(state_);
        }
        return *stepper_;
    }

    PointSet points_;
    std::vector<std::vector<Index>> lists_;
    Params params_;
    State state_;
    std::size_t given_ = 0;
    EventLog log_;
    std::optional<Stepper> stepper_;
};

}  // namespace se::test

// The output of failed checks.
namespace doctest {
template <>
struct StringMaker<se::Triangle> {
    static String convert(const se::Triangle& t) {
        const std::string text =
            "(" + std::to_string(t.a) + " " + std::to_string(t.b) + " " + std::to_string(t.c) + ")";
        return text.c_str();
    }
};
template <typename T>
struct StringMaker<std::vector<T>> {
    static String convert(const std::vector<T>& values) {
        String text = "[";
        for (const T& value : values) text += (text.size() > 1 ? " " : "") + toString(value);
        return text + "]";
    }
};
}  // namespace doctest
