#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/prover.h"
#include "spiraling_edge/why/trial.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

RunFailureSearch failuresIn(const PointSet& points, const Params& params) {
    auto all = searchFailures(points, params);
    REQUIRE(all.ok());
    return all.value();
}

/// At most `limit` failures of each class, spread over it.
std::vector<RunFailure> sampleOf(const RunFailureSearch& found, std::size_t limit) {
    std::map<const FailureClass*, std::vector<RunFailure>> of;
    for (const RunFailure& each : found.failures) of[each.failure.kind].push_back(each);
    std::vector<RunFailure> sample;
    for (const auto& [kind, all] : of) {
        const std::size_t step = (all.size() + limit - 1) / limit;
        for (std::size_t i = 0; i < all.size(); i += step) sample.push_back(all[i]);
    }
    return sample;
}

bool has(const std::vector<MeshFailure>& all, const MeshFailure& failure) {
    return std::any_of(all.begin(), all.end(), [&](const MeshFailure& each) {
        return each.kind == failure.kind && each.points == failure.points;
    });
}

/// The first failure of a class. Requires one.
const RunFailure& firstOf(const RunFailureSearch& found, std::string_view name) {
    const auto first =
        std::find_if(found.failures.begin(), found.failures.end(),
                     [&](const RunFailure& each) { return each.failure.kind->name == name; });
    REQUIRE(first != found.failures.end());
    return *first;
}

/// The scope of a search with these preparations, judged as the run is.
ProofScope scopeOf(const std::vector<OtherPreparation>& preparations) {
    ProofScope scope;
    scope.alternatives = [=](const Progress&) -> Result<Alternatives> {
        return Alternatives{nullptr, preparations};
    };
    return scope;
}

/// The answer about a failure. If an inversion proves it, the failure is not in the run with it,
/// and a new one in its place only if the answer says so.
Ledger proved(const PointSet& points, const Params& params, const RunFailureSearch& found,
              const RunFailure& failure) {
    const Result<Ledger> answer = provedWhy(points, params, failure, found.all);
    REQUIRE(answer.ok());
    const Ledger& ledger = answer.value();
    CAPTURE(ledger.answer);
    REQUIRE(ledger.cause < ledger.lines.size());
    CHECK(!ledger.inversions.empty() == (ledger.provedBy == ProvedBy::Inversion));
    if (ledger.preventedBy) {
        const RunSpec with = changed(specOf(params), {*ledger.preventedBy});
        const RunFailureSearch after = failuresIn(points, paramsOf(with).value());
        CHECK_FALSE(has(after.all, failure.failure));
        const MeshVerdict& verdict = after.verdict;
        CHECK(ledger.answer.ends_with(verdict.isSound()
                                          ? "and leaves a sound mesh."
                                          : "faults at " + counted(verdict.places, "place") + "."));
    }
    if (ledger.inversions.empty() || isLostPoint(failure.failure)) return ledger;
    Params inverted = params;
    inverted.whatIf.push_back(ledger.inversions.front());
    const RunFailureSearch after = failuresIn(points, inverted);
    CHECK_FALSE(has(after.all, failure.failure));
    const bool replaced =
        std::any_of(after.all.begin(), after.all.end(), [&](const MeshFailure& each) {
            return isStillThere(failure.failure, {&each, 1}) && !has(found.all, each);
        });
    const bool said = ledger.answer.find("another would be in its place") != std::string::npos;
    CHECK(replaced == said);
    return ledger;
}

}  // namespace

TEST_CASE("failure proof: nine of ten faults are gone with their decision inverted" *
          doctest::test_suite("long")) {
    std::size_t all = 0;
    std::size_t gone = 0;
    std::size_t replaced = 0;
    std::size_t prevented = 0;
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const RunFailureSearch found = failuresIn(points, paper());
        for (const RunFailure& failure : sampleOf(found, kSanitized ? 1 : 3)) {
            const Ledger ledger = proved(points, paper(), found, failure);
            if (!failure.failure.kind->fault) continue;
            ++all;
            prevented += ledger.preventedBy ? 1 : 0;
            if (ledger.provedBy == ProvedBy::Nothing) continue;
            const bool another = ledger.answer.find("another would") != std::string::npos;
            ++(another ? replaced : gone);
        }
    }
    MESSAGE(gone, " gone, ", replaced, " replaced by another, ", prevented,
            " prevented by a rule, of ", all, " faults");
    CHECK(10 * (gone + replaced) >= 9 * all);
    CHECK(10 * prevented >= 9 * all);
}

TEST_CASE("failure proof: a fault that a step after the last pivot made is proved by the step" *
          doctest::test_suite("long")) {
    std::size_t steps = 0;
    for (const FailureScene& each : failureScenes()) {
        const PointSet points = prepared(each.scene.build());
        const RunFailureSearch found = failuresIn(points, robust());
        for (const RunFailure& failure : sampleOf(found, 2)) {
            const ProofScope few{2, 0.5};
            const Ledger ledger = provedWhy(points, robust(), failure, found.all, few).value();
            // A lost point may have been made, and removed by such a step.
            if (failure.failure.triangles.empty()) continue;
            const bool made = editsMesh(failure.moments.decided.event);
            CHECK((ledger.provedBy == ProvedBy::Step) == made);
            steps += made ? 1 : 0;
        }
    }
    MESSAGE("made by steps: ", steps);
}

TEST_CASE("failure proof: a lost point has the answer of the point") {
    const PointSet points = prepared(findScene("stranded-point")->build());
    const RunFailureSearch found = failuresIn(points, paper());
    const RunFailure& lost = firstOf(found, "lost_points");
    const Ledger answer = proved(points, paper(), found, lost);
    const Index p = lost.failure.points.front();
    CHECK(answer.answer == provedWhy(points, paper(), Subject::point(p)).value().answer);
}

TEST_CASE("inverse: the hole of four takes the point beyond it at every test") {
    const PointSet points = prepared(findScene("four-edge-hole")->build());
    for (const RunFailure& each : failuresIn(points, paper()).failures) {
        if (each.failure.kind->name != "intersecting_triangles") continue;
        CHECK(toString(each.moments.decided.event.address) == "54.sphere.1");
        const auto inverse = inverseOf(points, each.moments.decided);
        REQUIRE(inverse.has_value());
        CHECK(lineOf(*inverse) == "54.sphere drop 63");
    }
}

TEST_CASE("inverse: a third point of a wall is taken off the list of the pivot") {
    // Figure 14: 2 joins the ring of 0 and 1 as the nearest point of the same wall.
    PointSet points =
        pointsAt({{0, 0, 0}, {0.8, 0.2, 0}, {-1, 0.2, 0}, {-1, 1, 0}}, {{1, 2, 3}, {}, {}, {}});
    points.type = {kNegativeY, kNegativeY, kNegativeY, kInterior};
    const std::vector<Event> events = eventsOf(points, paper());
    const auto inserted = std::find_if(events.begin(), events.end(), [](const auto& e) {
        return std::holds_alternative<InsertEvidence>(e.evidence);
    });
    REQUIRE(inserted != events.end());
    REQUIRE(std::get<InsertEvidence>(inserted->evidence).third == 2);
    const auto inverse = inverseOf(points, lineOf(*inserted, {points, paper(), 0}));
    REQUIRE(inverse.has_value());
    CHECK(inverse->kind == WhatIfKind::List);
    CHECK(inverse->pivot == 1);
    CHECK(inverse->point == 0);
    CHECK(inverse->list == Points{1, 3});
}

TEST_CASE("failure proof: where no rule prevents a fault, lists of another length do" *
          doctest::test_suite("long")) {
    const PointFile file = findScene("wrong-lists")->build();
    const RunSpec spec = changed({}, specChange({{"rules", "robust"}}));
    PointSet points = prepared(file);
    points.judge = judgeFor(file).value();
    const RunFailureSearch found = failuresIn(points, robust());
    const RunFailure& hole = firstOf(found, "holes");
    CHECK_FALSE(provedWhy(points, robust(), hole, found.all).value().preventedBy);
    const auto others = otherPreparations(file, spec, *points.judge);
    const ProofScope scope = scopeOf(others);
    const Ledger answer = provedWhy(points, robust(), hole, found.all, scope).value();
    REQUIRE(answer.preventedBy);
    CHECK(answer.preventedBy->field->key == "neighbors");
    CAPTURE(answer.answer);
    // The mesh of such lists, judged by the points as given.
    const Trial with = trialOfRun(file, changed(spec, {*answer.preventedBy})).value();
    CHECK(answer.answer.ends_with(
        "The option --neighbors " + answer.preventedBy->text + " prevents it, and leaves " +
        (with.verdict.isSound() ? "a sound mesh."
                                : "faults at " + counted(with.verdict.places, "place") + ".")));
    // A preparation takes steps, and can be cancelled.
    ProofScope few = scope;
    few.runs = 0.0;
    few.inversions = 0;
    CHECK(provedWhy(points, robust(), hole, found.all, few).value().preventedBy);
    std::size_t prepared = 0;
    few.alternatives = scopeOf({{others.front().change,
                                 [&](const Progress& progress) {
                                     ++prepared;
                                     CHECK(progress(0.0));
                                     return std::optional<PointSet>();
                                 }}})
                           .alternatives;
    const Ledger none = provedWhy(points, robust(), hole, found.all, few).value();
    CHECK(prepared == 1);
    CHECK(none.answer.find("preparation") == std::string::npos);
    // Of those that prevent it, none leaves fewer faults.
    for (const OtherPreparation& each : others) {
        const ProofScope alone = scopeOf({each});
        const Ledger one = provedWhy(points, robust(), hole, found.all, alone).value();
        if (!one.preventedBy) {
            CHECK(one.answer.ends_with("None of 1 other preparation prevents it."));
            continue;
        }
        const Trial other = trialOfRun(file, changed(spec, {each.change})).value();
        CHECK_FALSE(isBetter(other.verdict, with.verdict));
    }
}

TEST_CASE("failure proof: an opening in the place of a hole is no fault") {
    PointFile file;
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            file.position.emplace_back(x + 0.1 * std::sin(3.0 * y), y + 0.1 * std::sin(5.0 * x),
                                       0.0);
            file.normal.emplace_back(0.0, 0.0, 1.0);
        }
    }
    PointSet points = prepared(file);
    points.judge = judgeFor(file).value();
    const RunFailureSearch found = failuresIn(points, robust());
    const RunFailure& opening = firstOf(found, "openings");
    // Taken for a hole, it is gone in a mesh that has the opening alone.
    RunFailure hole = opening;
    hole.failure.kind = findFailureClass("holes");
    const std::vector<MeshFailure> known{hole.failure};
    const SpecChange rim = specChange({{"rim", "on"}});
    const ProofScope scope =
        scopeOf({{rim.front(), [&](const Progress&) { return std::optional(prepared(file)); }}});
    const Ledger answer = provedWhy(points, robust(), hole, known, scope).value();
    CHECK(answer.answer.ends_with("The option --derive-rim prevents it, and leaves a sound mesh."));
    // As an opening it is still there.
    CHECK_FALSE(provedWhy(points, robust(), opening, found.all, scope).value().preventedBy);
}

TEST_CASE("failure proof: cancelled") {
    const PointSet points = prepared(findScene("four-edge-hole")->build());
    const RunFailureSearch found = failuresIn(points, paper());
    for (const double limit : {0.0, 0.4, 0.7}) {
        const auto goesOn = [&](double share) { return share < limit; };
        CHECK_FALSE(provedWhy(points, paper(), found.failures.front(), found.all, {}, goesOn).ok());
    }
}
