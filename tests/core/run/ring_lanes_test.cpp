#include "spiraling_edge/run/ring_lanes.h"

#include <doctest/doctest.h>

#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rule_values.h"

using namespace se;
using namespace se::test;

namespace {

/// True if the lanes are the rings: as many, in the same order, of the same lengths and numbers.
bool lanesAreRings(const LaneTracker& lanes, const EdgeRings& rings) {
    if (lanes.active().has_value() != (rings.active() != kNone)) return false;
    if (lanes.stack().size() != rings.stack().size()) return false;
    for (std::size_t i = 0; i < rings.stack().size(); ++i) {
        if (lanes.stack()[i].length != rings.length(rings.stack()[i])) return false;
        if (lanes.stack()[i].number != rings.number(rings.stack()[i])) return false;
    }
    return !lanes.active() || lanes.active()->number == rings.number(rings.active());
}

Event eventOf(std::uint32_t pivot, Stage stage, const Evidence& evidence) {
    return {{pivot, stage, 1}, evidence};
}

/// Pivots after which the lanes are other rings than those of the run.
std::size_t wrongPivots(const PointSet& points, const Params& params) {
    EventLog log;
    Stepper stepper(points, params, &log);
    LaneTracker lanes(params.paper.stack);
    lanes.begin(stepper.state().rings);
    std::size_t wrong = lanesAreRings(lanes, stepper.state().rings) ? 0 : 1;
    while (stepper.stepPivot()) {
        for (const Event& event : log.events()) lanes.take(event);
        lanes.settle(stepper.state().rings);
        log.clear();
        const EdgeRings& rings = stepper.state().rings;
        const std::size_t count = rings.stack().size() + (rings.active() == kNone ? 0U : 1U);
        if (lanes.live() != count || !lanesAreRings(lanes, rings)) ++wrong;
    }
    CHECK(stepper.state().counters.pivots > 0);
    return wrong;
}

}  // namespace

TEST_CASE("lanes: at every pivot as many as rings, the active one and the stack, and as long") {
    for (const Scene& scene : scenes()) {
        for (const Params& params : {paper(), robust()}) {
            CAPTURE(scene.id);
            CHECK(wrongPivots(prepared(scene.build()), withStartOf(scene, params)) == 0);
        }
    }
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        CHECK(wrongPivots(prepared(each.scene.build()), robust()) == 0);
    }
}

TEST_CASE("lanes: they are the rings by every value of a rule of the paper") {
    for (const std::string scene : {"torus", "figure-12", "linked-tori"}) {
        const PointSet points = sceneNamed(scene);
        for (const Params& base : {paper(), robust()}) {
            forEachPaperRule(base, [&](const Params& params, const std::string& rule) {
                CAPTURE(scene);
                CAPTURE(rule);
                CHECK(wrongPivots(points, params) == 0);
            });
        }
    }
}

TEST_CASE("lanes: free ones are reused") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(4, Stage::Done, FreeEvidence{4, 0}));
    keeper.take(eventOf(5, Stage::Seed, SeedEvidence{2, 3, 1.0}));
    const auto changes = keeper.takeChanges();
    REQUIRE(changes.size() == 3);
    CHECK(changes[1].kind == LaneChangeKind::Freed);
    CHECK(changes[1].live == 0);
    CHECK(changes[2].lane == changes[0].lane);
    CHECK(keeper.takeChanges().empty());
}

TEST_CASE("lanes: a freed ring with an alert ends at a hole") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(4, Stage::Done, FreeEvidence{4, 2}));
    keeper.take(eventOf(4, Stage::Done, AlertEvidence{AlertKind::Hole, 3}));
    CHECK(keeper.takeChanges().back().kind == LaneChangeKind::Hole);
}

TEST_CASE("lanes: a seed without a triangle ends its lane, at no boundary and no hole") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(2, Stage::Done, FreeEvidence{2, 2, true}));
    CHECK(keeper.takeChanges().back().kind == LaneChangeKind::Failed);
}

TEST_CASE("lanes: the top of the stack continues when the active ring has ended") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(3, Stage::Pivot, PivotEvidence{0, 1, 2, 10, 90.0}));
    keeper.take(eventOf(3, Stage::Split, SplitEvidence{4, 6, 4, 1}));
    keeper.take(eventOf(9, Stage::Done, FreeEvidence{6, 0}));
    keeper.take(eventOf(9, Stage::Advance, AdvanceEvidence{4, 0, true}));
    const auto changes = keeper.takeChanges();
    CHECK(changes.back().kind == LaneChangeKind::Activated);
    CHECK(changes.back().lane == 1);
    CHECK(lanesAt(changes, 2) == 1);
    CHECK(lanesAt(changes, 3) == 2);
    CHECK(lanesAt(changes, 9) == 1);
    CHECK(lanesAt(changes, 0) == 0);
}

TEST_CASE("lanes: of several that are free the least is taken") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(2, Stage::Pivot, PivotEvidence{0, 1, 2, 12, 90.0}));
    keeper.take(eventOf(2, Stage::Split, SplitEvidence{4, 8, 4, 1}));
    keeper.take(eventOf(3, Stage::Pivot, PivotEvidence{0, 1, 2, 8, 90.0}));
    keeper.take(eventOf(3, Stage::Split, SplitEvidence{4, 5, 3, 2}));
    REQUIRE(keeper.stack().size() == 2);
    CHECK(keeper.stack()[1].lane == 2);
    // Lane 0 ends, then lane 2 comes off the stack and ends.
    keeper.take(eventOf(9, Stage::Done, FreeEvidence{5, 0}));
    keeper.take(eventOf(9, Stage::Advance, AdvanceEvidence{4, 0, true}));
    keeper.take(eventOf(12, Stage::Done, FreeEvidence{3, 0}));
    keeper.take(eventOf(12, Stage::Advance, AdvanceEvidence{4, 0, true}));
    keeper.take(eventOf(13, Stage::Pivot, PivotEvidence{0, 1, 2, 4, 90.0}));
    keeper.take(eventOf(13, Stage::Split, SplitEvidence{4, 2, 2, 1}));
    CHECK(keeper.stack().back().lane == 0);
    keeper.take(eventOf(14, Stage::Split, SplitEvidence{4, 1, 1, 2}));
    CHECK(keeper.stack().back().lane == 2);
}

TEST_CASE("lanes: a ring that this pivot has pushed may split on the stack") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(2, Stage::Pivot, PivotEvidence{0, 1, 2, 12, 90.0}));
    keeper.take(eventOf(2, Stage::Split, SplitEvidence{4, 7, 5, 1}));
    keeper.takeChanges();
    keeper.take(eventOf(2, Stage::Split, SplitEvidence{4, 3, 2, 2}));
    const auto changes = keeper.takeChanges();
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].other == 1);  // The lane that was split off before.
    CHECK(keeper.active()->length == 7);
    CHECK(keeper.stack()[0].length == 3);
    CHECK(keeper.stack()[1].length == 2);
}

TEST_CASE("lanes: a shelved ring goes below those that are on the stack") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(2, Stage::Pivot, PivotEvidence{0, 1, 2, 10, 90.0}));
    keeper.take(eventOf(2, Stage::Split, SplitEvidence{4, 6, 4, 1}));
    keeper.take(eventOf(9, Stage::Done, ShelveEvidence{6, 0}));
    REQUIRE(keeper.stack().size() == 2);
    CHECK(keeper.stack()[0].lane == 0);
    CHECK(keeper.stack()[1].lane == 1);
    keeper.take(eventOf(9, Stage::Advance, AdvanceEvidence{4, 0, true}));
    REQUIRE(keeper.active().has_value());
    CHECK(keeper.active()->lane == 1);
    // The next one goes above those that are shelved.
    keeper.take(eventOf(15, Stage::Done, ShelveEvidence{4, 1}));
    CHECK(keeper.stack()[0].lane == 0);
    CHECK(keeper.stack()[1].lane == 1);
}

TEST_CASE("lanes: where the pivot's ring was closed, the one that it had split off is active") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(2, Stage::Pivot, PivotEvidence{0, 1, 2, 10, 90.0}));
    keeper.take(eventOf(2, Stage::Split, SplitEvidence{4, 7, 3, 1}));
    keeper.take(eventOf(3, Stage::Pivot, PivotEvidence{0, 1, 2, 7, 90.0}));
    keeper.take(eventOf(3, Stage::Split, SplitEvidence{4, 2, 5, 2}));
    keeper.take(eventOf(3, Stage::Ring, CloseEvidence{3, 4}));
    CHECK_FALSE(keeper.active().has_value());
    // The run goes on in the ring of five without an event.
    EdgeRings rings(5);
    Index entry = rings.start(0, 1);
    for (const Index p : {2U, 3U, 4U}) entry = rings.insertAfter(entry, p);
    keeper.takeChanges();
    keeper.settle(rings);
    REQUIRE(keeper.active().has_value());
    CHECK(keeper.active()->lane == 2);
    CHECK(keeper.active()->length == 5);
    REQUIRE(keeper.stack().size() == 1);
    CHECK(keeper.stack()[0].lane == 1);
    const auto changes = keeper.takeChanges();
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].kind == LaneChangeKind::Activated);
    // Nothing is left to correct.
    keeper.settle(rings);
    CHECK(keeper.takeChanges().empty());
}

TEST_CASE("lanes: a ring of two that an earlier pivot has stacked is not the one that is closed") {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(2, Stage::Pivot, PivotEvidence{0, 1, 2, 6, 90.0}));
    keeper.take(eventOf(2, Stage::Split, SplitEvidence{4, 4, 2, 1}));
    keeper.take(eventOf(3, Stage::Pivot, PivotEvidence{0, 1, 2, 4, 90.0}));
    keeper.take(eventOf(3, Stage::Ring, CloseEvidence{3, 4}));
    CHECK_FALSE(keeper.active().has_value());
    REQUIRE(keeper.stack().size() == 1);
    CHECK(keeper.stack()[0].lane == 1);
    const auto changes = keeper.takeChanges();
    CHECK(changes.back().kind == LaneChangeKind::Closed);
    CHECK(changes.back().lane == 0);
}
