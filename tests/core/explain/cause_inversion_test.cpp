#include "spiraling_edge/explain/cause_inversion.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

std::vector<RunFailure> failuresIn(const PointSet& points) {
    auto all = failuresOfRun(points, paper());
    REQUIRE(all.ok());
    return all.value();
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
            if (failure.failure.kind->name == "unused_points")
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
        if (failures[i].failure.kind->name != "unused_points") continue;
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
