/// The proofs of subjects: what may have prevented them, or made them, is their ledger, and for an
/// absent one the triangles in its place.
#include "spiraling_edge/why/proof.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/why/origin_decisions.h"
#include "spiraling_edge/why/prover.h"

namespace se {
namespace {

/// True if the way from `at` to p leads into the triangle, between its two other points.
bool isInSector(const PointSet& points, const Triangle& t, Index at, Index p) {
    const Index x = at == t.a ? t.b : at == t.b ? t.c : t.a;
    const Index y = at == t.a ? t.c : at == t.b ? t.a : t.b;
    const auto to = [&](Index q) { return points.position[q] - points.position[at]; };
    const Vec3& n = points.normal[at];
    return x != p && y != p && glm::dot(glm::cross(to(x), to(p)), n) > 0.0 &&
           glm::dot(glm::cross(to(p), to(y)), n) > 0.0;
}

/// Triangles in the place of an absent subject, the latest, by their numbers, ascending: made at a
/// corner of it, across the direction to another corner; of one point, across the direction to it
/// from a near neighbor. O(triangles).
std::vector<std::size_t> rivalsOf(const PointSet& points, const Subject& subject,
                                  std::span<const Triangle> made) {
    constexpr std::size_t kNearby = 6;
    constexpr std::size_t kMostRivals = 8;
    std::vector<std::pair<Index, Index>> ways;
    for (const Index p : subject.points()) {
        for (const Index q : subject.points()) {
            if (p != q) ways.emplace_back(p, q);
        }
        const auto list = points.neighbors[p];
        if (subject.size() > 1) continue;
        for (const Index q : list.first(std::min(list.size(), kNearby))) ways.emplace_back(q, p);
    }
    std::vector<std::size_t> rivals;
    for (std::size_t i = made.size(); i-- > 0 && rivals.size() < kMostRivals;) {
        const Triangle& t = made[i];
        const bool inTheWay = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
            return hasCorner(t, way.first) && isInSector(points, t, way.first, way.second);
        });
        if (inTheWay) rivals.push_back(i);
    }
    std::reverse(rivals.begin(), rivals.end());
    return rivals;
}

/// The pivots of a run, and the number of triangles after each.
struct RunExtent {
    RunLength length;
    std::vector<Index> triangles;  ///< By the number of the pivot.

    /// Takes the next pivot of the run.
    void add(const SweptPivot& pivot) {
        length.add(pivot);
        triangles.resize(length.pivots + 1, triangles.empty() ? 0 : triangles.back());
        triangles.back() = static_cast<Index>(pivot.after.triangles.size());
    }
    /// The pivot that made a triangle.
    std::uint32_t pivotOf(std::size_t triangle) const {
        const auto after = std::upper_bound(triangles.begin(), triangles.end(), triangle);
        return static_cast<std::uint32_t>(after - triangles.begin());
    }
};

/// Adds the tests that made these of the triangles `made` by a run. A run up to the last of them,
/// with a log only where they are made. False if cancelled.
bool addRivals(const PointSet& points, const Params& params, const RunExtent& run,
               std::span<const Triangle> made, std::span<const std::size_t> rivals, Ledger& ledger,
               const Progress& progress) {
    if (rivals.empty()) return true;
    std::set<std::uint32_t> pivots;
    std::vector<Triangle> corners;
    for (const std::size_t each : rivals) {
        pivots.insert(run.pivotOf(each));
        corners.push_back(made[each]);
    }
    Stepper stepper(points, params);
    const auto goesOn = [&] {
        return !progress ||
               progress(static_cast<double>(stepper.state().counters.pivots) / run.length.pivots);
    };
    std::uint64_t left = ~std::uint64_t{0};
    for (const std::uint32_t pivot : pivots) {
        if (!advanceTo(stepper, pivot, left, goesOn)) return false;
        EventLog log;
        stepper.setLog(&log);
        stepper.stepPivot();
        stepper.setLog(nullptr);
        addMakings(points, params, {pivotPoint(log.events()), log.events(), stepper.state()},
                   corners, ledger);
    }
    sortLines(ledger);
    return true;
}

/// Of an absent edge whose ends are near and do not list each other: each with the other in its
/// list.
void addLists(const PointSet& points, const Subject& s, std::size_t cause,
              std::vector<Invertible>& all) {
    constexpr double kNear = 4.0;  // Of the distance to the last of the list.
    if (s.size() != 2) return;
    for (const auto& [p, q] : {std::pair(s[0], s[1]), std::pair(s[1], s[0])}) {
        const auto list = points.neighbors[p];
        const auto distance = [&, p = p](Index x) {
            return glm::distance(points.position[p], points.position[x]);
        };
        if (list.empty() || points.neighbors.has(p, q) ||
            distance(q) > kNear * distance(list.back()))
            continue;
        WhatIf longer{WhatIfKind::List, 1, Stage::Pivot, p, Vec3(0.0), {}};
        longer.list.assign(list.begin(), list.end());
        longer.list.push_back(q);
        all.push_back({cause, longer, q});
    }
}

/// The ledger of a subject, with the lines about triangles in the place of an absent one.
struct AskedSubject {
    Ledger ledger;
    std::vector<Invertible> all;  ///< The decisions to invert.
    RunLength length;
};

/// Two runs, or one where the ledger is proved or the subject present. Fails if cancelled, or as
/// why() does.
Result<AskedSubject> askSubject(const PointSet& points, const Params& params,
                                const Subject& subject, const Progress& progress) {
    const Result<Question<Ledger>> question = whyQuestion(points, params, subject);
    if (!question) return question.error();
    RunExtent run;
    const auto visit = [&](const SweptPivot& pivot) {
        run.add(pivot);
        question.value().visit(pivot);
    };
    const auto end =
        sweep(points, params, visit, partOf(progress, 0.0, 0.5), question.value().wants);
    if (!end) return Error{"Cancelled."};
    const Result<Ledger> ledger = question.value().answer(*end);
    if (!ledger) return ledger.error();
    AskedSubject asked{ledger.value(), {}, run.length};
    if (!asked.ledger.present && asked.ledger.provedBy == ProvedBy::Nothing) {
        const auto rivals = rivalsOf(*turnedPoints(points, params), subject, end->triangles);
        if (!addRivals(points, params, run, end->triangles, rivals, asked.ledger,
                       partOf(progress, 0.5, 1.0)))
            return Error{"Cancelled."};
    }
    asked.all = invertibleOf(points, asked.ledger);
    if (!asked.ledger.present) addLists(points, subject, asked.ledger.cause, asked.all);
    return asked;
}

}  // namespace

std::string_view provedByName(ProvedBy by) {
    constexpr std::array<std::string_view, 4> kNames{"nothing", "inversion", "step", "preparation"};
    return kNames[static_cast<std::size_t>(by)];
}

Result<Ledger> provedWhy(const PointSet& points, const Params& params, const Subject& subject,
                         const ProofScope& scope, const Progress& progress) {
    constexpr double kLedgerShare = 0.6;
    Result<AskedSubject> asked =
        askSubject(points, params, subject, partOf(progress, 0.0, kLedgerShare));
    if (!asked) return asked.error();
    Ledger& ledger = asked.value().ledger;
    const bool present = ledger.present;
    ProofAim aim;
    if (!present)
        aim.showsAtOnce = [&](std::span<const Triangle> made) { return isInMesh(made, subject); };
    aim.changedByPivots = [&](const State& end) {
        return isInMesh(end.triangles, subject) != present;
    };
    aim.following = [&](const Params& forked, std::uint64_t& left) {
        const auto goesOn = [&](double /*share*/) { return !progress || progress(kLedgerShare); };
        const Result<AskedSubject> next = askSubject(points, forked, subject, goesOn);
        std::vector<FollowingDecision> found;
        if (!next || next.value().ledger.provedBy != ProvedBy::Nothing) return found;
        left -= std::min(left, 2 * next.value().length.steps);
        for (const Invertible& each : next.value().all) {
            if (each.inverse.kind != WhatIfKind::List)
                found.push_back({next.value().ledger.lines[each.line].event, each.inverse});
        }
        return found;
    };
    aim.effect = [&](const State& state) {
        return isInMesh(state.mesh(), subject) == present ? Effect::None : Effect::Changed;
    };
    aim.findsChange = !present;
    const Status done =
        conclude(points, params, aim, std::move(asked.value().all), asked.value().length, scope,
                 ledger, partOf(progress, kLedgerShare, 1.0));
    if (!done.ok()) return done.error();
    return std::move(ledger);
}

}  // namespace se
