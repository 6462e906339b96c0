/// The proofs of subjects: what may have prevented them, or made them, is their ledger, and for an
/// absent one the triangles in its place.
#include "spiraling_edge/why/proof.h"

#include <algorithm>
#include <array>
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

/// Triangles in the place of an absent subject, the latest: made at a corner of it, across the
/// direction to another corner; of one point, across the direction to it from a near neighbor.
/// O(triangles).
std::vector<Triangle> rivalsOf(const PointSet& points, const Subject& subject,
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
    std::vector<Triangle> rivals;
    for (std::size_t i = made.size(); i-- > 0 && rivals.size() < kMostRivals;) {
        const Triangle& t = made[i];
        const bool inTheWay = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
            return hasCorner(t, way.first) && isInSector(points, t, way.first, way.second);
        });
        if (inTheWay) rivals.push_back(t);
    }
    return rivals;
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

/// Two runs, or one where the ledger is proved. Fails if cancelled, or as why() does.
Result<AskedSubject> askSubject(const PointSet& points, const Params& params,
                                const Subject& subject, const Progress& progress) {
    const Result<Question<Ledger>> question = whyQuestion(points, params, subject);
    if (!question) return question.error();
    AskedSubject asked;
    const auto visit = [&](const SweptPivot& pivot) {
        asked.length.add(pivot);
        question.value().visit(pivot);
    };
    const auto end = sweep(points, params, visit, partOf(progress, 0.0, 0.5));
    if (!end) return Error{"Cancelled."};
    Result<Ledger> ledger = question.value().answer(*end);
    if (!ledger) return ledger.error();
    asked.ledger = std::move(ledger.value());
    const bool isOpen = !asked.ledger.present && asked.ledger.provedBy == ProvedBy::Nothing;
    std::vector<Triangle> rivals;
    if (isOpen) rivals = rivalsOf(*turnedPoints(points, params), subject, end->triangles);
    if (!addMakings(points, params, rivals, {}, asked.ledger, partOf(progress, 0.5, 1.0)))
        return Error{"Cancelled."};
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
