#include "spiraling_edge/why/run_compare.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/given_start.h"
#include "support/clouds.h"
#include "support/repair_mesh.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

PointSet withNearest(const char* id, std::size_t k) {
    PrepareOptions options;
    options.neighbors.reach = KNearest{k};
    options.neighbors.recompute = true;
    const auto made = prepare(findScene(id)->build(), options);
    REQUIRE(made.ok());
    return made.value().points;
}

RunComparison compared(const ComparedRun& a, const ComparedRun& b) {
    const auto found = compareRuns(a, b);
    REQUIRE(found.ok());
    return found.value();
}

/// The side's line is an event of its run, found at its address.
void checkAddress(const ComparedRun& run, const DifferenceSide& side) {
    REQUIRE(side.line);
    Timeline timeline(run.points, run.params);
    const std::vector<Event> events = timeline.record(side.line->event.address.pivot)->events;
    const auto found = std::find_if(events.begin(), events.end(), [&](const Event& e) {
        return e.address == side.line->event.address;
    });
    REQUIRE(found != events.end());
    CHECK(describe(*found) == describe(side.line->event));
}

struct Planted {
    Params params;
    const char* scene;
    Stage stage;
};

}  // namespace

TEST_CASE("run comparison: equal params on equal points give no difference, on every scene") {
    for (const Scene& scene : scenes()) {
        CAPTURE(scene.id);
        const PointSet points = prepared(scene.build());
        const Params params = withStartOf(scene, paper());
        const RunComparison found = compared({points, params}, {points, params});
        CHECK_FALSE(found.first);
        CHECK_FALSE(found.harmless);
        CHECK(found.harmlessPivots == 0);
        Stepper stepper(points, params);
        stepper.run();
        CHECK(found.a.triangles == stepper.state().mesh());
        CHECK(found.b.triangles == stepper.state().mesh());
    }
}

TEST_CASE("run comparison: one rule turned over is found at the stage of that rule") {
    for (const Planted& planted :
         {Planted{paperBut(&Readings::limitsFirst), "torus", Stage::Limits},
          {paperBut(&Readings::freeSector), "torus", Stage::Reciprocal},
          {paperBut(&Readings::realHole), "sheet", Stage::Hole},
          {paperBut(&Readings::closeTwo), "torus", Stage::Ring},
          {paperBut(&RobustRules::tangent), "torus", Stage::Sort},
          {paperBut(&RobustRules::unblocked), "torus", Stage::Limits},
          {paperBut(&RobustRules::stepBack), "torus", Stage::Sphere},
          {paperBut(&RobustRules::bothWalls), "close-sheets", Stage::Insert},
          {paperBut(&RobustRules::guard), "four-edge-hole", Stage::Guard},
          {paperBut(&RobustRules::gap), "coarse-torus", Stage::Guard},
          {paperBut(&RobustRules::noPillow), "noise", Stage::Guard},
          {paperBut(&RobustRules::noCross), "torus", Stage::Guard},
          {paperBut(&RobustRules::noFold), "torus", Stage::Guard},
          {paperBut(&RobustRules::noMeet), "four-edge-hole", Stage::Guard},
          {paperBut(&RobustRules::reinsert), "torus", Stage::Reinsert},
          {paperBut(&RobustRules::flip), "torus", Stage::Flip}}) {
        CAPTURE(planted.scene);
        CAPTURE(stageName(planted.stage));
        const PointSet points = sceneNamed(planted.scene);
        const Params a = paper();
        const Params& b = planted.params;
        const RunComparison found = compared({points, a}, {points, b});
        REQUIRE(found.first);
        const DifferenceSide& asked = found.first->a.decides ? found.first->a : found.first->b;
        REQUIRE(asked.line);
        CHECK(asked.line->event.address.stage == planted.stage);
        if (found.first->a.line) checkAddress({points, a}, found.first->a);
        if (found.first->b.line) checkAddress({points, b}, found.first->b);
    }
}

TEST_CASE("run comparison: before the first difference both runs are in the same state") {
    const PointSet points = sceneNamed("torus");
    const Params a = paper();
    const Params b = paperBut(&Readings::freeSector);
    const RunComparison found = compared({points, a}, {points, b});
    REQUIRE(found.first);
    Stepper left(points, a);
    Stepper right(points, b);
    for (std::uint32_t i = 0; i < found.commonPivots; ++i) {
        left.stepPivot();
        right.stepPivot();
    }
    CHECK(stateHash(left.state()) == stateHash(right.state()));
    left.stepPivot();
    right.stepPivot();
    CHECK(stateHash(left.state()) != stateHash(right.state()));
    CHECK(found.first->a.line->event.address.pivot == found.commonPivots + 1);
    // 6.1, Fig. 6: the free side of the ring takes the pivot, the finished side does not.
    CHECK(found.first->a.line->role == LineRole::Taken);
    CHECK(found.first->b.line->role == LineRole::Refused);
    CHECK(found.first->a.line->reading->margin > 0.0);
    CHECK(found.first->b.line->reading->margin < 0.0);
}

TEST_CASE("run comparison: A against B is B against A") {
    const PointSet points = sceneNamed("torus");
    const Params a = paper();
    const Params b = *paramsByName("robust");
    const RunComparison there = compared({points, a}, {points, b});
    const RunComparison back = compared({points, b}, {points, a});
    REQUIRE(there.first);
    REQUIRE(back.first);
    CHECK(there.commonPivots == back.commonPivots);
    CHECK(there.harmlessPivots == back.harmlessPivots);
    CHECK((there.first->a.line->event.address == back.first->b.line->event.address));
    CHECK((there.first->b.line->event.address == back.first->a.line->event.address));
    CHECK(there.a.triangles == back.b.triangles);
    CHECK((there.a.made == back.b.made));
}

TEST_CASE("run comparison: decisions without a consequence come before the first difference") {
    const PointSet points = sceneNamed("torus");
    const Params a = paper();
    const Params b = paperBut(&Readings::freeSector);
    const RunComparison found = compared({points, a}, {points, b});
    REQUIRE(found.first);
    REQUIRE(found.harmless);
    CHECK(found.harmlessPivots > 0);
    CHECK(found.harmless->a.line->event.address.pivot <= found.commonPivots);
    CHECK(found.harmless->a.line->role != found.harmless->b.line->role);
}

TEST_CASE("run comparison: the harmless difference is the first decision made differently") {
    const PointSet points = sceneNamed("torus");
    const Params a = paper();
    const Params b = paperBut(&Readings::freeSector);
    const RunComparison found = compared({points, a}, {points, b});
    REQUIRE(found.harmless);
    REQUIRE(found.harmlessPivots > 1);
    const auto outcomes = [&](const Params& params) {
        const std::vector<Event> events = eventsOf(points, params);
        std::vector<std::vector<Outcome>> ofPivot;
        for (const Event& event : events) {
            ofPivot.resize(std::max<std::size_t>(ofPivot.size(), event.address.pivot + 1));
            ofPivot.back().push_back(outcomeOf(event));
        }
        return ofPivot;
    };
    const auto inA = outcomes(a);
    const auto inB = outcomes(b);
    const auto first = std::mismatch(inA.begin(), inA.end(), inB.begin(), inB.end()).first;
    CHECK(found.harmless->a.line->event.address.pivot ==
          static_cast<std::uint32_t>(first - inA.begin()));
}

TEST_CASE("run comparison: other neighbor lists part at a decision about what only one lists") {
    const PointSet a = sceneNamed("torus");
    const Params params = paper();
    SUBCASE("a point that the mesh needs is taken out of one list") {
        const RunComparison alone = compared({a, params}, {a, params});
        // The seed's first pivot makes triangles with its neighbors; one of them goes.
        const Triangle& fan = alone.a.triangles.front();
        PointSet b = a;
        std::vector<Index>& ids = b.neighbors.ids;
        const auto list = b.neighbors[fan.a];
        const auto at = std::find(list.begin(), list.end(), fan.c) - list.begin();
        REQUIRE(static_cast<std::size_t>(at) < list.size());
        ids.erase(ids.begin() + b.neighbors.offset[fan.a] + at);
        for (std::size_t i = fan.a + 1; i < b.neighbors.offset.size(); ++i) --b.neighbors.offset[i];
        const RunComparison found = compared({a, params}, {b, params});
        REQUIRE(found.first);
        CHECK(found.commonPivots == 0);
        const std::string lists = "A lists point " + std::to_string(fan.c);
        CAPTURE(found.first->words);
        CHECK(found.first->words.find(lists) != std::string::npos);
    }
    SUBCASE("k of 16 instead of 12") {
        const PointSet b = withNearest("torus", 16);
        const RunComparison found = compared({a, params}, {b, params});
        REQUIRE(found.first);
        checkAddress({a, params}, found.first->a);
        checkAddress({b, params}, found.first->b);
    }
}

TEST_CASE("run comparison: each triangle is made at its address") {
    const PointSet points = sceneNamed("torus");
    const Params robust = *paramsByName("robust");
    const auto made = makeMesh({points, robust});
    REQUIRE(made.ok());
    const MadeMesh& mesh = made.value();
    REQUIRE(mesh.triangles.size() == mesh.made.size());
    Timeline timeline(points, robust);
    std::size_t emitted = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 37) {
        const Triangle& t = mesh.triangles[i];
        const auto has = [&](Index p) { return t.a == p || t.b == p || t.c == p; };
        const std::vector<Event> events = timeline.record(mesh.made[i].pivot)->events;
        const auto found = std::find_if(events.begin(), events.end(),
                                        [&](const Event& e) { return e.address == mesh.made[i]; });
        REQUIRE(found != events.end());
        const auto* emit = std::get_if<EmitEvidence>(&found->evidence);
        if (emit == nullptr) continue;
        ++emitted;
        CHECK((has(emit->corners.a) && has(emit->corners.b) && has(emit->corners.c)));
    }
    CHECK(emitted > 10);
}

TEST_CASE(
    "run comparison: triangles of both windings on three points each have their own address") {
    // A seed with a single further neighbor; the rule takes a patch out only beside a larger one.
    const PointSet points = flatPoints({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const Params params = paperBut(&RobustRules::dropPatches);
    const auto made = makeMesh({points, params});
    REQUIRE(made.ok());
    REQUIRE_FALSE(made.value().emitted.empty());
    CHECK(made.value().triangles == Triangles{{0, 1, 2}, {0, 2, 1}});
    REQUIRE(made.value().made.size() == 2);
    CHECK(toString(made.value().made[0]) == "1.emit.1");
    CHECK(toString(made.value().made[1]) == "1.emit.2");
}

TEST_CASE("run comparison: the first decision of several triangles is the earliest in the run") {
    MadeMesh mesh;
    mesh.made = {
        {5, Stage::Emit, 2}, {3, Stage::Emit, 7}, {3, Stage::Emit, 1}, {4, Stage::Emit, 1}};
    const auto firstOf = [&](const Points& triangles) {
        const auto first = firstMade(mesh, triangles);
        return first ? toString(*first) : "none";
    };
    CHECK(firstOf({0, 1, 2, 3}) == "3.emit.1");
    CHECK(firstOf({1, 0}) == "3.emit.7");
    CHECK(firstOf({0}) == "5.emit.2");
    // Triangles that the record does not have do not count.
    CHECK(firstOf({3, 4}) == "4.emit.1");
    CHECK(firstOf({4}) == "none");
    CHECK(firstOf({}) == "none");
}

TEST_CASE("run comparison: other numbers of points and cancelling are errors") {
    const PointSet torus = sceneNamed("torus");
    const PointSet sphere = sceneNamed("sphere");
    const Params params = paper();
    CHECK_FALSE(compareRuns({torus, params}, {sphere, params}).ok());
    CHECK_FALSE(compareRuns({torus, params}, {torus, params}, [](double) { return false; }).ok());
    CHECK_FALSE(makeMesh({torus, params}, [](double) { return false; }).ok());
}

TEST_CASE("run comparison: triangles are dated after those of a given start") {
    const PointSet points = sceneNamed("figure-7");
    const Params params = withStartOf(*findScene("figure-7"), paper());
    const Result<MadeMesh> mesh = makeMesh({points, params}, {});
    REQUIRE(mesh.ok());
    const std::size_t given = params.start.triangles.size();
    REQUIRE(mesh.value().made.size() > given);
    CHECK(mesh.value().made[0].pivot == 0);
    CHECK(toString(mesh.value().made[given]) == "1.emit.1");
    const std::vector<Index> both{0, static_cast<Index>(given)};
    CHECK(toString(firstMade(mesh.value(), both).value()) == "1.emit.1");
    CHECK_FALSE(firstMade(mesh.value(), std::vector<Index>{0}).has_value());
}
