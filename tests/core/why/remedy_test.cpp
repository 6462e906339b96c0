#include "spiraling_edge/why/remedy.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/failure_moments.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

struct Tried {
    MeshFailure failure;
    Remedies remedies;
    PointSet points;
};

/// The first failure that a scene of the gallery is about.
Tried tried(const char* scene) {
    Tried result;
    result.points = prepared(findScene(scene)->build());
    const auto gallery = failureScenes();
    const auto row = std::find_if(gallery.begin(), gallery.end(),
                                  [&](const FailureScene& each) { return each.scene.id == scene; });
    REQUIRE(row != gallery.end());
    const auto all = failuresOfRun(result.points, paper());
    REQUIRE(all.ok());
    const auto first = std::find_if(
        all.value().begin(), all.value().end(),
        [&](const RunFailure& each) { return each.failure.kind->name == row->failure; });
    REQUIRE(first != all.value().end());
    result.failure = first->failure;
    const auto remedies = findRemedies(result.points, paper(), result.failure);
    REQUIRE(remedies.ok());
    result.remedies = remedies.value();
    return result;
}

const Remedy* remedyNamed(const Remedies& remedies, std::string_view name) {
    const auto found = std::find_if(remedies.tried.begin(), remedies.tried.end(),
                                    [&](const Remedy& each) { return nameOf(each) == name; });
    return found == remedies.tried.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("remedy: every rule that robust has beyond the paper is tried, and both sets") {
    const Tried four = tried("four-edge-hole");
    const Params robust = *paramsByName("robust");
    for (const RuleSetting& each : ruleSwitches()) {
        const bool beyond = each.isOn(robust) && !each.isOn(paper());
        CHECK((remedyNamed(four.remedies, each.name) != nullptr) == beyond);
    }
    for (const char* set : {"corrected", "robust"}) {
        const Remedy* remedy = remedyNamed(four.remedies, set);
        REQUIRE(remedy != nullptr);
        CHECK(remedy->rule == nullptr);
    }
    // The gallery names it as a remedy.
    CHECK(remedyNamed(four.remedies, "corrected")->prevents);
}

TEST_CASE("remedy: a run with the rule that prevents it is without the failure") {
    for (const char* scene : {"four-edge-hole", "noise", "uneven-density"}) {
        CAPTURE(scene);
        const Tried t = tried(scene);
        REQUIRE_FALSE(t.remedies.tried.empty());
        const Remedy& best = t.remedies.tried.front();
        CAPTURE(nameOf(best));
        REQUIRE(best.prevents);
        Params params = paper();
        if (best.rule != nullptr) {
            best.rule->turnOn(params);
        } else {
            params = *paramsByName(best.set);
        }
        const Run run = runAll(t.points, params);
        for (const MeshFailure& each : inspectMesh(t.points, run.state.mesh()))
            CHECK_FALSE((each.kind == t.failure.kind && each.points == t.failure.points));
    }
}

TEST_CASE("remedy: preventing rules come first, single rules before sets, the fewest failures") {
    const Tried t = tried("four-edge-hole");
    const auto rank = [](const Remedy& r) {
        return std::tuple(!r.prevents, r.rule == nullptr, r.all);
    };
    for (std::size_t i = 1; i < t.remedies.tried.size(); ++i)
        CHECK(rank(t.remedies.tried[i - 1]) <= rank(t.remedies.tried[i]));
    CHECK(t.remedies.all >= t.remedies.ofClass);
    CHECK(t.remedies.ofClass > 0);
}

TEST_CASE("remedy: normals that are flipped in the input are no rule's business") {
    const Tried t = tried("flipped-patch");
    for (const char* set : {"guard", "unblocked"}) {
        const Remedy* remedy = remedyNamed(t.remedies, set);
        REQUIRE(remedy != nullptr);
        CHECK_FALSE(remedy->prevents);
    }
}

TEST_CASE("remedy: a hole that has become smaller is still there") {
    MeshFailure hole;
    hole.kind = findFailureClass("holes");
    hole.points = {1, 2, 3, 4, 5};
    MeshFailure smaller = hole;
    smaller.points = {2, 3, 9};
    CHECK(isStillThere(hole, {smaller}));
    smaller.points = {3, 8, 9};
    CHECK_FALSE(isStillThere(hole, {smaller}));
    MeshFailure unused;
    unused.kind = findFailureClass("lost_points");
    unused.points = {7};
    MeshFailure isolated = unused;
    isolated.kind = findFailureClass("isolated_points");
    CHECK(isStillThere(unused, {isolated}));
    CHECK_FALSE(isStillThere(unused, {hole}));
}

TEST_CASE("remedy: cancelled") {
    const PointSet points = prepared(findScene("four-edge-hole")->build());
    MeshFailure failure;
    failure.kind = findFailureClass("holes");
    CHECK_FALSE(findRemedies(points, paper(), failure, [](double) { return false; }).ok());
}
