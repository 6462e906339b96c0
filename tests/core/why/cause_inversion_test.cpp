#include "spiraling_edge/why/cause_inversion.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/remedy.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

std::vector<RunFailure> failuresIn(const PointSet& points) {
    auto all = failuresOfRun(points, paper());
    REQUIRE(all.ok());
    return all.value();
}

/// 100 points of a torus, each moved by up to 0.15 along each axis, a third of their spacing.
PointSet noisyTorus(std::uint64_t seed) {
    PointFile file = closedFamilies(0.2)[1].sample(seed);
    Random random(seed);
    for (Vec3& x : file.position) x += 0.15 * random.inCube();
    return prepared(file, reach(12));
}

bool isGone(const CauseInversion& inversion) { return inversion.outcome < Inversion::NoEffect; }

}  // namespace

TEST_CASE("cause inversion: turning the decision called unavoidable makes the failure go away") {
    std::size_t all = 0;
    std::size_t gone = 0;
    std::size_t stays = 0;
    std::size_t layers = 0;
    std::size_t layersStay = 0;
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const std::vector<RunFailure> failures = failuresIn(points);
        const auto chosen = sampleOfEach(failures, kSanitized ? 10 : 30);
        const auto inversions = invertCauses(points, paper(), failures, chosen);
        REQUIRE(inversions.ok());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const RunFailure& failure = failures[chosen[i]];
            const CauseInversion& inversion = inversions.value()[i];
            CAPTURE(describe(failure.failure));
            CHECK((isGone(inversion) || !inversion.reason.empty()));
            // The subject of the scene.
            if (failure.failure.kind->name == each.failure &&
                toString(failure.moments.unavoidable.event.address) == each.address)
                CHECK(inversion.outcome != Inversion::NoEffect);
            // A lost point that can be kept is a point that is used.
            if (failure.failure.kind->name == "lost_points")
                CHECK(inversion.outcome != Inversion::NoEffect);
            if (!failure.failure.kind->fault) continue;
            gone += isGone(inversion) ? 1 : 0;
            const std::size_t stay = inversion.outcome == Inversion::NoEffect ? 1 : 0;
            // A second layer has two triangles and one decision for each.
            const bool layer = failure.failure.kind->name == "second_layers";
            layers += layer ? 1 : 0;
            layersStay += layer ? stay : 0;
            stays += layer ? 0 : stay;
            ++all;
        }
    }
    CHECK(gone * 10 > all * 8);
    CHECK(stays * 50 < all - layers);
    CHECK(layersStay * 20 < layers);
}

TEST_CASE("cause inversion: the hole of four takes the point beyond it at every test") {
    const PointSet points = prepared(findScene("four-edge-hole")->build());
    const std::vector<RunFailure> failures = failuresIn(points);
    for (const RunFailure& each : failures) {
        if (each.failure.kind->name != "intersecting_triangles") continue;
        CHECK(toString(each.moments.unavoidable.event.address) == "54.sphere.1");
        const auto inverse = inverseOf(points, each.moments.unavoidable);
        REQUIRE(inverse.has_value());
        CHECK(lineOf(*inverse) == "54.sphere drop 63");
    }
}

TEST_CASE("cause inversion: a third point of a wall is taken off the list of the pivot") {
    // Figure 14: 2 joins the ring of 0 and 1 as the nearest point of the same wall.
    PointSet points;
    points.position = {{0, 0, 0}, {0.8, 0.2, 0}, {-1, 0.2, 0}, {-1, 1, 0}};
    points.normal.assign(4, Vec3(0, 0, 1));
    points.type = {kNegativeY, kNegativeY, kNegativeY, kInterior};
    for (const Points& list : std::vector<Points>{{1, 2, 3}, {}, {}, {}})
        points.neighbors.append(list);
    REQUIRE(validate(points).ok());
    EventLog log;
    runAll(points, paper(), &log);
    const auto inserted = std::find_if(log.events().begin(), log.events().end(), [](const auto& e) {
        return std::holds_alternative<InsertEvidence>(e.evidence);
    });
    REQUIRE(inserted != log.events().end());
    REQUIRE(std::get<InsertEvidence>(inserted->evidence).third == 2);
    const auto inverse = inverseOf(points, lineOf(*inserted, {points, paper(), 0}));
    REQUIRE(inverse.has_value());
    CHECK(inverse->kind == WhatIfKind::List);
    CHECK(inverse->pivot == 1);
    CHECK(inverse->point == 0);
    CHECK(inverse->list == Points{1, 3});
}

TEST_CASE("cause inversion: with a decision that is not the cause the failure stays") {
    const PointSet points = prepared(findScene("noise")->build());
    std::vector<RunFailure> failures = failuresIn(points);
    const auto flipped = std::find_if(failures.begin(), failures.end(), [](const auto& each) {
        return each.failure.kind->name == "flipped_triangles";
    });
    REQUIRE(flipped != failures.end());
    // A decision of the very last pivots, long after the triangle was made.
    const auto late = std::find_if(failures.begin(), failures.end(), [&](const auto& each) {
        return each.moments.unavoidable.event.address.pivot >
                   flipped->moments.created.event.address.pivot &&
               inverseOf(points, each.moments.unavoidable).has_value();
    });
    REQUIRE(late != failures.end());
    flipped->moments.unavoidable = late->moments.unavoidable;
    const std::vector<std::size_t> chosen{static_cast<std::size_t>(flipped - failures.begin())};
    const auto inversions = invertCauses(points, paper(), failures, chosen);
    REQUIRE(inversions.ok());
    CHECK(inversions.value()[0].outcome == Inversion::NoEffect);
    CHECK_FALSE(inversions.value()[0].reason.empty());
}

TEST_CASE("cause inversion: a decision that another test repeats is inverted there, too") {
    const PointSet points = noisyTorus(4);
    const std::vector<RunFailure> failures = failuresIn(points);
    const auto chosen = sampleOfEach(failures, failures.size());
    const auto inversions = invertCauses(points, paper(), failures, chosen);
    REQUIRE(inversions.ok());
    const auto failuresWith = [&](const std::vector<WhatIf>& inverses) {
        Params forked = paper();
        forked.whatIf = inverses;
        return inspectMesh(points, runAll(points, forked).state.mesh());
    };
    std::size_t seen = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const CauseInversion& inversion = inversions.value()[i];
        const MeshFailure& failure = failures[chosen[i]].failure;
        if (inversion.outcome != Inversion::Later || failure.kind->find == nullptr) continue;
        CAPTURE(describe(failure));
        REQUIRE(inversion.inverses.size() > 1);
        CHECK(isStillThere(failure, failuresWith({inversion.inverses.front()})));
        for (const MeshFailure& each : failuresWith(inversion.inverses))
            CHECK_FALSE((each.kind == failure.kind && each.points == failure.points));
        ++seen;
    }
    CHECK(seen > 0);
}

TEST_CASE("cause inversion: only a failure that was not there before takes the place of one") {
    const PointSet points = noisyTorus(4);
    const std::vector<RunFailure> failures = failuresIn(points);
    const auto chosen = sampleOfEach(failures, failures.size());
    const auto inversions = invertCauses(points, paper(), failures, chosen);
    REQUIRE(inversions.ok());
    const auto isKnown = [&](const MeshFailure& each) {
        return std::any_of(failures.begin(), failures.end(), [&](const RunFailure& known) {
            return known.failure.kind == each.kind && known.failure.points == each.points;
        });
    };
    std::size_t seen = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const CauseInversion& inversion = inversions.value()[i];
        if (inversion.outcome != Inversion::Replaced) continue;
        const MeshFailure& failure = failures[chosen[i]].failure;
        CAPTURE(describe(failure));
        Params forked = paper();
        forked.whatIf = inversion.inverses;
        ++seen;
        const auto after = failuresOfRun(points, forked);
        REQUIRE(after.ok());
        CHECK(std::any_of(after.value().begin(), after.value().end(), [&](const RunFailure& each) {
            return !isKnown(each.failure) && isStillThere(failure, {each.failure});
        }));
    }
    CHECK(seen > 0);
}

TEST_CASE("cause inversion: where two triangles cross, the earlier one may be wrong") {
    const PointSet points = prepared(findScene("close-sheets")->build());
    const std::vector<RunFailure> failures = failuresIn(points);
    const auto chosen = sampleOfEach(failures, 20);
    const auto inversions = invertCauses(points, paper(), failures, chosen);
    REQUIRE(inversions.ok());
    std::size_t looked = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const RunFailure& failure = failures[chosen[i]];
        const CauseInversion& inversion = inversions.value()[i];
        if (inversion.outcome != Inversion::Earlier) continue;
        CAPTURE(describe(failure.failure));
        CHECK(failure.failure.triangles.size() == 2);
        CHECK(inversion.inverses.front().pivot < failure.moments.created.event.address.pivot);
        Params forked = paper();
        forked.whatIf = inversion.inverses;
        const Run run = runAll(points, forked);
        for (const MeshFailure& each : inspectMesh(points, run.state.mesh()))
            CHECK_FALSE(
                (each.kind == failure.failure.kind && each.points == failure.failure.points));
        ++looked;
    }
    CHECK(looked > 0);
}

TEST_CASE("cause inversion: a point outside all sectors cannot be kept, and there is a reason") {
    const PointSet points = prepared(findScene("flipped-patch")->build());
    const std::vector<RunFailure> failures = failuresIn(points);
    const auto inversions = invertCauses(points, paper(), failures, sampleOfEach(failures, 100));
    REQUIRE(inversions.ok());
    for (std::size_t i = 0; i < failures.size(); ++i) {
        if (failures[i].failure.kind->name != "lost_points") continue;
        CHECK(inversions.value()[i].outcome == Inversion::NotInvertible);
        CHECK(inversions.value()[i].reason == "The point lies outside of the free sector.");
    }
}

TEST_CASE("cause inversion: a sample is spread over each class") {
    const PointSet points = prepared(findScene("sharp-crease")->build());
    const std::vector<RunFailure> failures = failuresIn(points);
    const auto few = sampleOfEach(failures, 3);
    CHECK(std::is_sorted(few.begin(), few.end()));
    CHECK(sampleOfEach(failures, failures.size()).size() == failures.size());
    for (const FailureClass& kind : failureClasses()) {
        const auto ofKind = [&](std::size_t i) { return failures[i].failure.kind == &kind; };
        const auto count = std::count_if(few.begin(), few.end(), ofKind);
        const auto all =
            std::count_if(failures.begin(), failures.end(),
                          [&](const RunFailure& each) { return each.failure.kind == &kind; });
        CHECK(count == std::min<std::ptrdiff_t>(all, 3));
    }
}

TEST_CASE("cause inversion: cancelled") {
    const PointSet points = prepared(findScene("four-edge-hole")->build());
    const std::vector<RunFailure> failures = failuresIn(points);
    CHECK_FALSE(invertCauses(points, paper(), failures, sampleOfEach(failures, 1), [](double) {
                    return false;
                }).ok());
}
