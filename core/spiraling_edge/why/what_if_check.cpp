/// A what-if is checked at its pivot: the run is copied just before it, made with the what-if and a
/// log, and, only if an invariant is broken afterwards, made again without it. O(run up to the last
/// what-if + points for each pivot with one).
#include "spiraling_edge/why/what_if_check.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/invariants.h"

namespace se {
namespace {

std::string namedPoint(Index p) { return "Point " + std::to_string(p); }

/// The checks that need no run.
Status checkPlain(const PointSet& points, const WhatIf& what) {
    if (what.point >= points.size()) return Error{namedPoint(what.point) + " does not exist."};
    if (what.kind == WhatIfKind::Move) {
        const auto same = std::find(points.position.begin(), points.position.end(), what.to);
        const auto at = static_cast<Index>(same - points.position.begin());
        if (same != points.position.end() && at != what.point) {
            return Error{namedPoint(at) +
                         " is at that place: there is only one point at any "
                         "particular location (section 3)."};
        }
        if (points.position[what.point] == what.to)
            return Error{namedPoint(what.point) + " is at that place already."};
    }
    if (what.kind != WhatIfKind::List) return success();
    std::set<Index> seen;
    for (const Index q : what.list) {
        if (q >= points.size()) return Error{namedPoint(q) + " does not exist."};
        if (q == what.point) return Error{"A point is not in its own list."};
        if (!seen.insert(q).second) return Error{namedPoint(q) + " is in the list twice."};
    }
    const auto now = points.neighbors[what.point];
    if (std::set<Index>(now.begin(), now.end()) == seen)
        return Error{namedPoint(what.point) + " has that list already."};
    return success();
}

bool isAbout(const Event& event, const WhatIf& what) {
    if (event.address.stage != what.stage) return false;
    return what.stage == Stage::TwoPoint || testedPoint(event) == what.point;
}

/// The checks of Keep and Drop against the log of the pivot.
Status checkTest(const std::vector<Event>& events, const WhatIf& what) {
    std::optional<Verdict> verdict;
    bool stageSeen = false;
    for (const Event& event : events) {
        stageSeen = stageSeen || event.address.stage == what.stage;
        if (!isAbout(event, what)) continue;
        verdict = verdictOf(event);
        if (verdict == Verdict::WhatIfKept || verdict == Verdict::WhatIfDropped) return success();
    }
    const std::string place = toString(placeOf(what));
    if (!stageSeen) return Error{"Nothing is tested at " + place + "."};
    if (!verdict) return Error{namedPoint(what.point) + " is not tested at " + place + "."};
    if (what.kind == WhatIfKind::Drop) return Error{"No effect: the decision is already that way."};
    const std::string reason = reasonAgainst(*verdict, what.point);
    return Error{reason.empty() ? "No effect: the decision is already that way." : reason};
}

Status checkPivot(const std::vector<Event>& events, const WhatIf& what) {
    for (const Event& event : events) {
        const auto* advance = as<AdvanceEvidence>(event);
        if (advance != nullptr && advance->whatIf && advance->to == what.point) return success();
    }
    return Error{namedPoint(what.point) + " is on no edge ring after pivot " +
                 std::to_string(what.pivot) + "."};
}

/// Directed edges of the triangles from number `from` on that are used twice (invariants 3, 5).
std::size_t repeatedEdges(const std::vector<Triangle>& triangles, std::size_t from) {
    std::set<std::pair<Index, Index>> made;
    std::size_t count = 0;
    const auto sides = [](const Triangle& t) {
        return std::array{std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)};
    };
    Index end = 0;  // Beyond the points of these triangles.
    for (std::size_t i = from; i < triangles.size(); ++i) {
        for (const auto& side : sides(triangles[i])) {
            count += made.insert(side).second ? 0 : 1;
            end = std::max(end, side.first + 1);
        }
    }
    if (made.empty()) return count;
    std::vector<bool> begins(end, false);
    for (const auto& side : made) begins[side.first] = true;
    for (std::size_t i = 0; i < from; ++i) {
        for (const auto& side : sides(triangles[i]))
            count += side.first < end && begins[side.first] && made.contains(side) ? 1 : 0;
    }
    return count;
}

/// Runs to the pivots of what-ifs and compares each with and without them.
class Check {
  public:
    Check(const PointSet& points, const Params& params)
        : points_(points),
          params_(params),
          stepper_(points, params),
          answers_(params.whatIf.size(), success()) {}

    std::optional<std::vector<Status>> run(const Progress& progress) {
        std::set<std::uint32_t> places;
        for (const WhatIf& each : params_.whatIf) places.insert(each.pivot);
        for (const std::uint32_t pivot : places) {
            while (stepper_.state().counters.pivots + 1 < pivot && stepper_.stepPivot()) {
                const std::uint32_t at = stepper_.state().counters.pivots;
                if (progress && at % kPivotsPerReport == 0 && !progress(double(at) / pivot))
                    return {};
            }
            look(pivot, State(stepper_.state()));
        }
        return std::move(answers_);
    }

    Result<std::vector<Triangle>> last(const State& before) {
        stepper_.setState(before);
        look(params_.whatIf.back().pivot, before);
        if (!answers_.back()) return answers_.back().error();
        const std::vector<Triangle>& all = stepper_.state().triangles;
        return std::vector<Triangle>(
            all.begin() + static_cast<std::ptrdiff_t>(before.triangles.size()), all.end());
    }

  private:
    /// Makes the pivot after `before`, the present state, and answers its what-ifs.
    void look(std::uint32_t pivot, const State& before) {
        EventLog log;
        stepper_.setLog(&log);
        const PointSet& points = stepper_.points();
        const bool there = stepper_.stepPivot() && stepper_.state().counters.pivots == pivot;
        stepper_.setLog(nullptr);
        std::vector<std::size_t> done;
        for (std::size_t i = 0; i < answers_.size(); ++i) {
            if (params_.whatIf[i].pivot != pivot) continue;
            answers_[i] = answer(params_.whatIf[i], log.events(), there);
            if (answers_[i]) done.push_back(i);
        }
        const std::string broken = done.empty() ? "" : brokenBy(before, pivot, points);
        for (const std::size_t i : done) {
            if (!broken.empty()) answers_[i] = Error{broken};
        }
    }

    /// The checks of a what-if that look at its own tests.
    Status answer(const WhatIf& what, const std::vector<Event>& events, bool there) const {
        if (Status plain = checkPlain(points_, what); !plain) return plain;
        if (!there) return Error{"The run has no pivot " + std::to_string(what.pivot) + "."};
        if (what.kind == WhatIfKind::Keep || what.kind == WhatIfKind::Drop)
            return checkTest(events, what);
        return what.kind == WhatIfKind::Pivot ? checkPivot(events, what) : success();
    }

    /// The invariant that is broken by the what-ifs of a pivot and holds without them.
    std::string brokenBy(const State& before, std::uint32_t pivot, const PointSet& points) const {
        const State& after = stepper_.state();
        const std::string broken = checkInvariants(after, points, params_);
        const std::size_t repeated = repeatedEdges(after.triangles, before.triangles.size());
        if (broken.empty() && repeated == 0) return {};
        Params without = params_;
        std::erase_if(without.whatIf, [&](const WhatIf& each) { return each.pivot == pivot; });
        Stepper plain(points_, without);
        plain.setState(before);
        plain.stepPivot();
        if (!broken.empty() && checkInvariants(plain.state(), plain.points(), without).empty()) {
            return "Then an invariant would not hold: " + broken + ".";
        }
        const std::size_t usual = repeatedEdges(plain.state().triangles, before.triangles.size());
        if (repeated <= usual) return {};
        return "Then an edge would have two triangles on one side (invariant 5).";
    }

    const PointSet& points_;
    const Params& params_;
    Stepper stepper_;
    std::vector<Status> answers_;
};

}  // namespace

std::string reasonAgainst(Verdict verdict, Index point) {
    struct Reason {
        Verdict verdict;
        std::string_view text;  ///< {} is the point.
    };
    constexpr std::string_view kOutside =
        "{} lies outside of the free sector: its triangle would cover finished ones (invariant 8).";
    static constexpr Reason kReasons[] = {
        {Verdict::AlreadyDone, "{} is DONE: triangles surround it (invariant 7)."},
        {Verdict::OnRingEnd, "{} is first or last, and always in the neighbor ring."},
        {Verdict::NotAfterStart, kOutside},
        {Verdict::NotBeforeEnd, kOutside},
        {Verdict::Outside, kOutside},
        {Verdict::SameAngle,
         "{} has the same angle as a nearer one (invariant 8): drop that one instead."},
        {Verdict::NotListed,
         "{} is not among the pivot's neighbors (section 6.1): give the pivot another list first."},
        {Verdict::NotAnEdge,
         "No edge leads to {} along the ring: start and end advance over finished triangles only."},
        {Verdict::OtherLimit, "{} is the other limit: start and end would meet."},
        {Verdict::Discarded, "The full turn of a fresh ring has no triangle."},
    };
    const auto* const found =
        std::find_if(std::begin(kReasons), std::end(kReasons),
                     [&](const Reason& each) { return each.verdict == verdict; });
    if (found == std::end(kReasons)) return {};
    std::string text(found->text);
    if (const auto gap = text.find("{}"); gap != text.npos) text.replace(gap, 2, namedPoint(point));
    return text;
}

std::optional<std::vector<Status>> checkWhatIfs(const PointSet& points, const Params& params,
                                                const Progress& progress) {
    return Check(points, params).run(progress);
}

Result<std::vector<Triangle>> madeWithLastWhatIf(const PointSet& points, const Params& params,
                                                 const State& before) {
    assert(!params.whatIf.empty());
    return Check(points, params).last(before);
}

std::uint64_t runHash(const State& state, const Params& params) {
    std::uint64_t hash = stateHash(state);
    for (const WhatIf& each : params.whatIf) {
        for (const char sign : lineOf(each) + '\n') {
            hash = (hash ^ static_cast<unsigned char>(sign)) * 0x100000001B3ULL;
        }
    }
    return hash;
}

Status requireWhatIfs(const PointSet& points, const Params& params) {
    if (params.whatIf.empty()) return success();
    const auto answers = checkWhatIfs(points, params);
    for (std::size_t i = 0; i < answers->size(); ++i) {
        if (!(*answers)[i])
            return Error{lineOf(params.whatIf[i]) + ": " + (*answers)[i].error().message};
    }
    return success();
}

}  // namespace se
