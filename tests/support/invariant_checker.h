/// Invariants of a run that need the state before a pivot.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/stepper/invariants.h"

namespace se::test {

/// Follows a run from its beginning and checks every invariant after every pivot, including those
/// that need the previous state. O(points) per pivot.
class InvariantChecker {
  public:
    /// The set of invariants to expect.
    enum class Level : std::uint8_t {
        AnyInput,     ///< 1, 2, 6 to 11, 13.
        Guarded,      ///< Also 3 and 5, which RobustRules::guard guarantees on any input.
        WellSampled,  ///< Also 12: edges and rings fit together as on a manifold.
    };

    InvariantChecker(const PointSet& points, const Params& params, Level level);

    /// Call after every stepPivot(), first of all for the state at the start. Empty if all hold.
    std::string check(const State& state);

  private:
    std::string checkPivot(const State& state) const;
    std::string checkStatusChanges(const State& state) const;
    std::string checkRingCount(const State& state) const;
    std::string takeTriangle(const Triangle& triangle, Index number);
    std::string checkEdges(const State& state);
    std::string checkSurrounded(const State& state) const;

    const PointSet& points_;
    Params params_;
    Level level_;
    /// Triangles that pass u -> v in this direction, by (u, v).
    std::unordered_map<std::uint64_t, int> directedEdges_;
    std::vector<std::vector<Index>> trianglesOf_;
    State before_;  ///< At the previous check.
};

inline std::string breachAt(std::string_view what, Index point) {
    return std::string(what) + " (point " + std::to_string(point) + ")";
}

inline std::vector<Index> liveRingsOf(const EdgeRings& rings) {
    std::vector<Index> all(rings.stack().begin(), rings.stack().end());
    if (rings.active() != kNone) all.push_back(rings.active());
    return all;
}

inline std::uint64_t edgeKey(Index u, Index v) { return (std::uint64_t{u} << 32U) | v; }

inline InvariantChecker::InvariantChecker(const PointSet& points, const Params& params, Level level)
    : points_(points),
      params_(params),
      level_(level),
      trianglesOf_(points.size()),
      before_(startState(points, params)) {
    for (Index i = 0; i < before_.triangles.size(); ++i) takeTriangle(before_.triangles[i], i);
}

/// Invariants 6 and 9.
inline std::string InvariantChecker::checkPivot(const State& s) const {
    const std::size_t before = before_.triangles.size();
    if (s.triangles.size() < before ||
        !std::equal(before_.triangles.begin(), before_.triangles.end(), s.triangles.begin())) {
        return "6: a triangle was taken back";
    }
    if (s.triangles.size() - before != s.pivotTriangles) return "6: triangles are miscounted";
    for (std::size_t i = before; i < s.triangles.size(); ++i) {
        const Triangle& t = s.triangles[i];
        if (t.a == t.b || t.b == t.c || t.c == t.a) return breachAt("6: a corner twice", t.b);
        if (t.a != s.triangles[before].a) return breachAt("6: a fan with two centers", t.a);
        if (i > before && t.b != s.triangles[i - 1].c) return breachAt("6: a fan is torn", t.b);
    }
    if (s.pivotTriangles == 0 && s.counters.freedRings == before_.counters.freedRings &&
        s.counters.failedSeeds == before_.counters.failedSeeds &&
        s.counters.seeds == before_.counters.seeds &&
        s.counters.stranded == before_.counters.stranded &&
        s.counters.isolated == before_.counters.isolated && s.status != before_.status) {
        return "9: a pivot without triangles changed a status";
    }
    return {};
}

/// Invariant 7.
inline std::string InvariantChecker::checkStatusChanges(const State& s) const {
    for (Index p = 0; p < s.status.size(); ++p) {
        if (before_.status[p] == kDone && s.status[p] != kDone)
            return breachAt("7: DONE is final", p);
    }
    for (std::size_t i = before_.triangles.size(); i < s.triangles.size(); ++i) {
        for (const Index p : {s.triangles[i].a, s.triangles[i].b, s.triangles[i].c}) {
            if (before_.status[p] == kDone)
                return breachAt("7: a DONE point is in a new triangle", p);
            if (s.status[p] == kUnused) return breachAt("7: an UNUSED point is in a triangle", p);
        }
    }
    return {};
}

/// Invariant 10: +1 per seed and split, -1 per join, closed and freed ring.
inline std::string InvariantChecker::checkRingCount(const State& s) const {
    const Counters& now = s.counters;
    const Counters& old = before_.counters;
    const auto change = static_cast<long>(now.seeds - old.seeds) +
                        static_cast<long>(now.splits - old.splits) -
                        static_cast<long>(now.joins - old.joins) -
                        static_cast<long>(now.closedRings - old.closedRings) -
                        static_cast<long>(now.freedRings - old.freedRings) -
                        static_cast<long>(now.failedSeeds - old.failedSeeds);
    const auto rings = static_cast<long>(liveRingsOf(s.rings).size());
    const auto ringsBefore = static_cast<long>(liveRingsOf(before_.rings).size());
    return rings == ringsBefore + change ? "" : "10: a ring came or went";
}

/// Invariant 5, for the next triangle of the mesh.
inline std::string InvariantChecker::takeTriangle(const Triangle& t, Index number) {
    std::string problem;
    for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
        if (++directedEdges_[edgeKey(u, v)] > 1)
            problem = breachAt("5: an edge is passed twice", u);
    }
    for (const Index p : {t.a, t.b, t.c}) trianglesOf_[p].push_back(number);
    return problem;
}

/// Invariants 3, 4 and 5.
inline std::string InvariantChecker::checkEdges(const State& s) {
    std::string problem;
    for (std::size_t i = before_.triangles.size(); i < s.triangles.size(); ++i) {
        problem = takeTriangle(s.triangles[i], static_cast<Index>(i));
        if (!problem.empty()) return problem;
    }
    for (const Index ring : liveRingsOf(s.rings)) {
        for (const Index e : s.rings.entriesOf(ring)) {
            if (s.rings.open(e)) continue;
            const Index u = s.rings.point(e);
            const Index v = s.rings.point(s.rings.next(e));
            if (directedEdges_.count(edgeKey(u, v)) == 0) {
                problem = breachAt("3: a ring step is no edge of the mesh", u);
            }
            if (directedEdges_.count(edgeKey(v, u)) != 0) {
                problem = breachAt("3: both sides of a ring step are triangulated", u);
            }
        }
    }
    return problem;
}

/// Invariant 12: an interior point that became DONE by §6.5 is inside one closed fan.
inline std::string InvariantChecker::checkSurrounded(const State& s) const {
    if (s.counters.freedRings != before_.counters.freedRings) return {};
    for (Index p = 0; p < s.status.size(); ++p) {
        if (s.status[p] != kDone || before_.status[p] == kDone) continue;
        if (isBoundary(points_.type[p]) || trianglesOf_[p].empty()) continue;
        std::unordered_map<Index, Index> following;
        for (const Index i : trianglesOf_[p]) {
            const Triangle& t = s.triangles[i];
            const Index u = t.a == p ? t.b : (t.b == p ? t.c : t.a);
            const Index v = t.a == p ? t.c : (t.b == p ? t.a : t.b);
            following[u] = v;
        }
        const Index begin = following.begin()->first;
        Index x = begin;
        std::size_t steps = 0;
        do {
            const auto found = following.find(x);
            if (found == following.end()) return breachAt("12: a DONE point is not surrounded", p);
            x = found->second;
        } while (++steps < trianglesOf_[p].size() && x != begin);
        if (x != begin || steps != trianglesOf_[p].size()) {
            return breachAt("12: a DONE point has more than one fan", p);
        }
    }
    return {};
}

inline std::string InvariantChecker::check(const State& s) {
    std::string problem = checkInvariants(s, points_, params_);
    if (problem.empty() && s.startPointer < before_.startPointer) {
        problem = "11: the start pointer went back";
    }
    if (problem.empty()) problem = checkPivot(s);
    if (problem.empty()) problem = checkStatusChanges(s);
    if (problem.empty()) problem = checkRingCount(s);
    if (problem.empty() && level_ != Level::AnyInput) problem = checkEdges(s);
    if (problem.empty() && level_ == Level::WellSampled) problem = checkSurrounded(s);
    before_ = s;
    return problem;
}

}  // namespace se::test
