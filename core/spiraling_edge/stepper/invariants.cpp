/// The invariants as direct checks over the whole state, independent of the code that maintains
/// them. O(points) each.
#include "spiraling_edge/stepper/invariants.h"

#include <algorithm>
#include <set>

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

}  // namespace

std::string checkInvariants(const State& state, const PointSet& points, const Params& params) {
    for (const std::string& problem : {checkRings(state, params), checkAngles(state, params),
                                       checkProgress(state, points, params)}) {
        if (!problem.empty()) return problem;
    }
    return {};
}

}  // namespace se
