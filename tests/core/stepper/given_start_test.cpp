#include "spiraling_edge/stepper/given_start.h"

#include <doctest/doctest.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/stepper/invariants.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// A scene with a start, and the params of its run.
struct Started {
    explicit Started(std::string_view id)
        : points(sceneNamed(id)), params(withStartOf(*findScene(id), paper())) {}
    PointSet points;
    Params params;
};

/// The reason against the start of Figure 11 after a change.
std::string reason(const std::function<void(GivenStart&)>& change) {
    Started started("figure-11");
    change(started.params.start);
    const Status status = requireStart(started.points, started.params.start);
    return status ? std::string() : status.error().message;
}

}  // namespace

TEST_CASE("a given start is the state before the first pivot") {
    const Started started("figure-11");
    const State state = startState(started.points, started.params);
    CHECK(state.phase == Phase::Pivot);
    CHECK(state.triangles == started.params.start.triangles);
    CHECK(ringFrom(state, state.pivot.pivot) == Points{0, 2, 6, 3, 4, 5, 1});
    REQUIRE(state.rings.stack().size() == 1);
    CHECK(ringFrom(state, state.rings.head(state.rings.stack()[0])) == Points{1, 9, 10});
    CHECK(state.status[1] == 2);
    CHECK(state.status[7] == kUnused);
    Stepper stepper(started.points, started.params);
    CHECK(stateHash(stepper.state()) == stateHash(state));
    stepper.run();
    CHECK(stateHash(stepper.takeState()) != stateHash(state));
    CHECK(stateHash(stepper.state()) == stateHash(state));
}

TEST_CASE("without a start a run begins with nothing") {
    const PointSet points = sceneNamed("figure-2");
    CHECK(GivenStart{}.empty());
    CHECK(requireStart(points, {}).ok());
    CHECK(stateHash(startState(points, paper())) == stateHash(State(points.size())));
}

TEST_CASE("runs from given starts keep the invariants") {
    for (const Figure& figure : figures()) {
        if (figure.scene.start == nullptr) continue;
        CAPTURE(figure.number);
        const Started started(figure.scene.id);
        CHECK(requireStart(started.points, started.params.start).ok());
        InvariantChecker checker(started.points, started.params,
                                 InvariantChecker::Level::WellSampled);
        Stepper stepper(started.points, started.params);
        CHECK(checker.check(stepper.state()) == "");
        while (stepper.stepPivot()) CHECK(checker.check(stepper.state()) == "");
        CHECK(stepper.state().finished());
    }
}

TEST_CASE("a start that no run could reach is refused, with the entry and the invariant") {
    using Start = GivenStart;
    CHECK(reason([](Start&) {}) == "");
    CHECK(reason([](Start& s) { s.rings[1][3] = 12; }) ==
          "rings[1][3]: there is no point 12; the points are 0 to 10.");
    CHECK(reason([](Start& s) { s.triangles[2].c = 40; }) ==
          "triangles[2]: there is no point 40; the points are 0 to 10.");
    CHECK(reason([](Start& s) { s.rings.push_back({1}); }) ==
          "rings[2]: a ring has two points or more (invariant 2).");
    CHECK(reason([](Start& s) { s.rings[1].push_back(1); }) ==
          "rings[1][6]: point 1 follows itself.");
    CHECK(reason([](Start& s) { s.triangles.push_back(s.triangles[3]); }) ==
          "triangles[8]: triangles[3] has the edge 10 -> 0 in the same direction (invariant 5).");
    CHECK(reason([](Start& s) {
              s.triangles[0] = {2, 2, 3};
          }) == "triangles[0]: point 2 is a corner twice.");
    CHECK(reason([](Start& s) { s.done = {12}; }) ==
          "done[0]: there is no point 12; the points are 0 to 10.");
    CHECK(reason([](Start& s) { s.done = {3}; }) ==
          "done[0]: point 3 is on a ring, so it is not DONE (invariant 1).");
    CHECK(reason([](Start& s) { s.done = {7, 7}; }) == "done[1]: point 7 is named twice.");
    CHECK(reason([](Start& s) { s.open = {{0, 3}}; }) == "open[0]: no ring has the step 0 -> 3.");
    CHECK(reason([](Start& s) { s.triangles.erase(s.triangles.begin() + 1); }) ==
          "rings[1]: the step 2 -> 6 is no edge of a triangle; give the triangle on its left, or "
          "name the step in \"open\" (invariant 3).");
    CHECK(reason([](Start& s) { s.rings.push_back(s.rings[0]); }) ==
          "rings[2]: the step 1 -> 9 is on rings[0] too.");
    CHECK(reason([](Start& s) {
              s.triangles.push_back({2, 0, 1});
          }) == "rings[1]: the step 0 -> 2 has triangles on both sides (invariant 3).");
    CHECK(reason([](Start& s) { s.rings.erase(s.rings.begin()); }) ==
          "triangles[3]: point 10 is neither on a ring nor in \"done\".");
    Started aside("figure-11");
    aside.points.aside.assign(aside.points.size(), Aside::No);
    aside.points.aside[9] = Aside::Noise;
    CHECK(requireStart(aside.points, aside.params.start).error().message ==
          "triangles[5]: point 9 was set aside, no triangle has it.");
}

TEST_CASE("an entry between two of one point is a finished edge, and refused") {
    PointFile file;
    file.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    file.normal.assign(4, Vec3(0, 0, 1));
    const PointSet points = prepared(file);
    // 0 -> 1 and 1 -> 0 have a triangle on their left each, and none on their right.
    GivenStart start{.triangles = {{0, 1, 2}}, .rings = {{0, 1}}, .done = {2}, .open = {{1, 0}}};
    CHECK(requireStart(points, start).ok());
    start.triangles.push_back({1, 0, 3});
    start.done.push_back(3);
    start.open.clear();
    CHECK(requireStart(points, start).error().message ==
          "rings[0]: the step 0 -> 1 has triangles on both sides (invariant 3).");
}

TEST_CASE("open steps of a start are no edges for the rules") {
    Started started("figure-4");
    started.params.start.open = {{5, 1}};
    started.params.start.triangles.pop_back();  // the triangle at that step
    started.params.start.open.push_back({4, 5});
    REQUIRE(requireStart(started.points, started.params.start).ok());
    EventLog log;
    Stepper stepper(started.points, started.params, &log);
    stepper.stepPivot();
    for (const Event& event : log.events()) {
        const auto* limit = std::get_if<LimitEvidence>(&event.evidence);
        if (limit != nullptr && limit->to == 5) CHECK(limit->verdict == Verdict::NotAnEdge);
    }
    CHECK(stepper.state().rings.open(stepper.state().rings.firstEntryOf(5)));
}

TEST_CASE("a given start counts its longest ring, its stack and its component") {
    const Started started("figure-11");
    const Counters counters = startState(started.points, started.params).counters;
    CHECK(counters.maxRingLength == 7);
    CHECK(counters.maxStackDepth == 1);
    CHECK(counters.seeds == 1);
    CHECK(counters.pivots == 0);
}

TEST_CASE("rules on finished triangles know those of a given start") {
    Started started("figure-11");
    started.params.robust.guard = true;
    const State state = startState(started.points, started.params);
    CHECK(state.edges.has(0, 2));
    CHECK_FALSE(state.edges.has(2, 0));
}

TEST_CASE("a start without rings goes on with a new component") {
    PointFile file = findScene("figure-2")->build();
    const PointSet points = prepared(file);
    Params params = paper();
    params.start.done = {0};
    Stepper stepper(points, params);
    CHECK(stepper.state().phase == Phase::Seed);
    CHECK(stepper.state().status[0] == kDone);
    stepper.stepPivot();
    CHECK(stepper.state().triangles.front().a != 0);
}
