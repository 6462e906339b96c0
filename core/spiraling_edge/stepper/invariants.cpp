/// The invariants as direct checks over the whole state, independent of the code that maintains
/// them. O(points) each.
#include "spiraling_edge/stepper/invariants.h"

#include <algorithm>
#include <set>
#include <utility>

#include "spiraling_edge/stepper/given_start.h"

namespace se {
namespace {

std::string at(std::string_view what, Index point) {
    return std::string(what) + " (point " + std::to_string(point) + ")";
}

std::vector<Index> liveRings(const EdgeRings& rings) {
    std::vector<Index> all(rings.stack().begin(), rings.stack().end());
    if (rings.active() != kNone) all.push_back(rings.active());
    return all;
}

/// Invariant 2, for one ring.
std::string checkRing(const EdgeRings& rings, Index ring, const Params& params) {
    const Index length = rings.length(ring);
    if (length < 2) return "2: a ring has fewer than two entries";
    std::string problem;
    const bool closes = params.readings.closeTwo && params.readings.openSteps;
    for (const Index e : rings.entriesOf(ring)) {
        if (rings.ringOf(e) != ring) problem = at("2: an entry names another ring", rings.point(e));
        if (rings.prev(rings.next(e)) != e) {
            problem = at("2: next and prev disagree", rings.point(e));
        }
        const Index before = rings.prev(e);
        const bool samePoint = rings.point(before) == rings.point(rings.next(e));
        if (closes && samePoint && !rings.open(before) && !rings.open(e)) {
            problem = at("2: a finished edge was not closed", rings.point(e));
        }
    }
    Index entry = rings.head(ring);
    for (Index i = 0; i < length; ++i) entry = rings.next(entry);
    if (entry != rings.head(ring)) problem = "2: a ring's length is wrong";
    return problem;
}

/// Invariants 1 and 2.
std::string checkRings(const State& s, const Params& params) {
    const std::vector<Index> rings = liveRings(s.rings);
    if (std::set<Index>(rings.begin(), rings.end()).size() != rings.size()) {
        return "2: a ring is in two places";
    }
    std::vector<PointStatus> entries(s.status.size(), 0);
    for (const Index ring : rings) {
        const std::string problem = checkRing(s.rings, ring, params);
        if (!problem.empty()) return problem;
        for (const Index e : s.rings.entriesOf(ring)) ++entries[s.rings.point(e)];
    }
    for (Index p = 0; p < s.status.size(); ++p) {
        if (std::max(s.status[p], 0) != entries[p]) return at("1: status is not the entries", p);
        PointStatus chained = 0;
        for (Index e = s.rings.firstEntryOf(p); e != kNone; e = s.rings[e].nextOfPoint) {
            if (s.rings.point(e) != p || !s.rings.alive(e)) return at("1: a chain is wrong", p);
            ++chained;
        }
        if (chained != entries[p]) return at("1: a chain has other entries than the rings", p);
    }
    return {};
}

/// Invariant 8, unless a rule that it depends on is off.
std::string checkAngles(const State& s, const Params& params) {
    if (params.paper.tie == TieRule::Both || !params.paper.maxAngle) return "";
    double before = s.pivot.startAngle.key;
    for (const Candidate& c : s.pivot.candidates) {
        if (!(c.angle.key > before)) return at("8: angles do not increase", c.point);
        before = c.angle.key;
    }
    const bool ordered = s.pivot.candidates.empty() || s.pivot.endAngle.key > before;
    return ordered ? "" : "8: a candidate is beyond end";
}

/// Invariants 11 and 13.
std::string checkProgress(const State& s, const PointSet& points, const Params& params) {
    const Index active = s.rings.active();
    if (active != kNone && s.circuit >= s.rings.length(active)) {
        return "11: a full circuit without a triangle was not freed";
    }
    Index tried = 0;  // As the first point of a seed, and UNUSED since.
    for (Index i = 0; i < std::min<Index>(s.startPointer, static_cast<Index>(points.size())); ++i) {
        const Index p = points.inOrder(i);
        if (s.phase != Phase::Seed || s.status[p] == kDone) continue;
        // On a shelved ring, or beside one that may take it.
        const auto list = points.neighbors[p];
        const bool waits =
            params.robust.shelve && (s.status[p] != kUnused ||
                                     std::none_of(list.begin(), list.end(),
                                                  [&](Index x) { return s.status[x] == kUnused; }));
        if (!waits && (s.status[p] != kUnused || ++tried > s.counters.failedSeeds))
            return at("11: the start pointer passed a point that is not DONE", p);
    }
    if (!s.finished() || s.capped()) return {};
    for (Index p = 0; p < s.status.size(); ++p) {
        if (s.status[p] != kDone) return at("13: a point is not DONE at the end", p);
    }
    return {};
}

std::uint64_t edgeKey(Index u, Index v) { return (std::uint64_t{u} << 32U) | v; }

}  // namespace

std::string checkInvariants(const State& state, const PointSet& points, const Params& params) {
    for (const std::string& problem : {checkRings(state, params), checkAngles(state, params),
                                       checkProgress(state, points, params)}) {
        if (!problem.empty()) return problem;
    }
    return {};
}

InvariantChecker::InvariantChecker(const PointSet& points, const Params& params, Level level)
    : points_(points),
      params_(params),
      level_(level),
      trianglesOf_(points.size()),
      before_(startState(points, params)) {
    for (Index i = 0; i < before_.triangles.size(); ++i) takeTriangle(before_.triangles[i], i);
}

/// Invariants 6 and 9.
std::string InvariantChecker::checkPivot(const State& s) const {
    const std::size_t before = before_.triangles.size();
    if (s.triangles.size() < before ||
        !std::equal(before_.triangles.begin(), before_.triangles.end(), s.triangles.begin())) {
        return "6: a triangle was taken back";
    }
    if (s.triangles.size() - before != s.pivotTriangles) return "6: triangles are miscounted";
    for (std::size_t i = before; i < s.triangles.size(); ++i) {
        const Triangle& t = s.triangles[i];
        if (t.a == t.b || t.b == t.c || t.c == t.a) return at("6: a corner twice", t.b);
        if (t.a != s.triangles[before].a) return at("6: a fan with two centers", t.a);
        if (i > before && t.b != s.triangles[i - 1].c) return at("6: a fan is torn", t.b);
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
std::string InvariantChecker::checkStatusChanges(const State& s) const {
    for (Index p = 0; p < s.status.size(); ++p) {
        if (before_.status[p] == kDone && s.status[p] != kDone) return at("7: DONE is final", p);
    }
    for (std::size_t i = before_.triangles.size(); i < s.triangles.size(); ++i) {
        for (const Index p : {s.triangles[i].a, s.triangles[i].b, s.triangles[i].c}) {
            if (before_.status[p] == kDone) return at("7: a DONE point is in a new triangle", p);
            if (s.status[p] == kUnused) return at("7: an UNUSED point is in a triangle", p);
        }
    }
    return {};
}

/// Invariant 10: +1 per seed and split, -1 per join, closed and freed ring.
std::string InvariantChecker::checkRingCount(const State& s) const {
    const Counters& now = s.counters;
    const Counters& old = before_.counters;
    const auto change = static_cast<long>(now.seeds - old.seeds) +
                        static_cast<long>(now.splits - old.splits) -
                        static_cast<long>(now.joins - old.joins) -
                        static_cast<long>(now.closedRings - old.closedRings) -
                        static_cast<long>(now.freedRings - old.freedRings) -
                        static_cast<long>(now.failedSeeds - old.failedSeeds);
    const auto rings = static_cast<long>(liveRings(s.rings).size());
    const auto ringsBefore = static_cast<long>(liveRings(before_.rings).size());
    return rings == ringsBefore + change ? "" : "10: a ring came or went";
}

/// Invariant 5, for the next triangle of the mesh.
std::string InvariantChecker::takeTriangle(const Triangle& t, Index number) {
    std::string problem;
    for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
        if (++directedEdges_[edgeKey(u, v)] > 1) problem = at("5: an edge is passed twice", u);
    }
    for (const Index p : {t.a, t.b, t.c}) trianglesOf_[p].push_back(number);
    return problem;
}

/// Invariants 3, 4 and 5.
std::string InvariantChecker::checkEdges(const State& s) {
    std::string problem;
    for (std::size_t i = before_.triangles.size(); i < s.triangles.size(); ++i) {
        problem = takeTriangle(s.triangles[i], static_cast<Index>(i));
        if (!problem.empty()) return problem;
    }
    for (const Index ring : liveRings(s.rings)) {
        for (const Index e : s.rings.entriesOf(ring)) {
            if (s.rings.open(e)) continue;
            const Index u = s.rings.point(e);
            const Index v = s.rings.point(s.rings.next(e));
            if (directedEdges_.count(edgeKey(u, v)) == 0) {
                problem = at("3: a ring step is no edge of the mesh", u);
            }
            if (directedEdges_.count(edgeKey(v, u)) != 0) {
                problem = at("3: both sides of a ring step are triangulated", u);
            }
        }
    }
    return problem;
}

/// Invariant 12: an interior point that became DONE by §6.5 is inside one closed fan.
std::string InvariantChecker::checkSurrounded(const State& s) const {
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
            if (found == following.end()) return at("12: a DONE point is not surrounded", p);
            x = found->second;
        } while (++steps < trianglesOf_[p].size() && x != begin);
        if (x != begin || steps != trianglesOf_[p].size()) {
            return at("12: a DONE point has more than one fan", p);
        }
    }
    return {};
}

std::string InvariantChecker::check(const State& s) {
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

}  // namespace se
