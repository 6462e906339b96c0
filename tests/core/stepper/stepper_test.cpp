#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <type_traits>

#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/run/event_text.h"
#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

/// FNV-1a of the triangles, in order.
std::uint64_t triangleHash(const State& state) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const Triangle& t : state.triangles) {
        for (const Index corner : {t.a, t.b, t.c}) hash = (hash ^ corner) * 0x100000001B3ULL;
    }
    return hash;
}

}  // namespace

TEST_CASE("advance, stepPivot, runUntil and run lead to the same state") {
    const PointSet points = sceneNamed("figure-12");
    Stepper phases(points, paper());
    Stepper pivots(points, paper());
    Stepper until(points, paper());
    Stepper all(points, paper());
    while (phases.advance()) {
    }
    while (pivots.stepPivot()) {
    }
    for (std::uint32_t n = 10; !until.state().finished(); n += 10) {
        until.runUntil([n](const State& s) { return s.counters.pivots >= n; });
    }
    CHECK(all.run() == StopReason::Finished);
    const std::uint64_t hash = stateHash(all.state());
    CHECK(stateHash(phases.state()) == hash);
    CHECK(stateHash(pivots.state()) == hash);
    CHECK(stateHash(until.state()) == hash);
}

TEST_CASE("stepPivot completes exactly one pivot") {
    const PointSet points = sceneNamed("figure-8");
    Stepper stepper(points, paper());
    for (std::uint32_t n = 1; stepper.stepPivot(); ++n) {
        CHECK(stepper.state().counters.pivots == n);
    }
    CHECK(stepper.state().finished());
    CHECK_FALSE(stepper.stepPivot());
    CHECK_FALSE(stepper.advance());
}

TEST_CASE("stepPivot from the middle of a pivot completes that one") {
    const PointSet points = sceneNamed("figure-8");
    Stepper stepper(points, paper());
    while (stepper.state().phase != Phase::Sphere) stepper.advance();
    CHECK(stepper.stepPivot());
    CHECK(stepper.state().counters.pivots == 1);
    CHECK(stepper.state().phase == Phase::Pivot);
}

TEST_CASE("runUntil stops between two pivots, where the condition holds") {
    const PointSet points = sceneNamed("figure-12");
    Stepper stepper(points, paper());
    const auto stop = stepper.runUntil([](const State& s) { return s.counters.splits > 0; });
    CHECK(stop == StopReason::Condition);
    CHECK(stepper.state().counters.splits > 0);
    CHECK(stepper.state().phase == Phase::Pivot);
    CHECK(stepper.runUntil([](const State&) { return false; }) == StopReason::Finished);
}

TEST_CASE("a copy of a State, taken anywhere, continues as the original does") {
    const PointSet points = sceneNamed("figure-12");
    Stepper straight(points, paper());
    straight.run();
    Stepper source(points, paper());
    for (int step = 0; source.advance(); ++step) {
        if (step % 97 != 0) continue;
        const State copy = source.state();
        CHECK(stateHash(copy) == stateHash(source.state()));
        Stepper continued(points, paper());
        continued.setState(copy);
        continued.run();
        CHECK(stateHash(continued.state()) == stateHash(straight.state()));
    }
}

TEST_CASE("a run that frees what is past ends with the same mesh, and without the table of edges") {
    const PointSet points = sceneNamed("torus");
    const Params params = *paramsByName("robust");
    Stepper plain(points, params);
    Stepper freeing(points, params);
    plain.run();
    while (freeing.stepPivot()) freeing.freePast();
    CHECK(freeing.state().mesh() == plain.state().mesh());
    CHECK(freeing.state().counters.pivots == plain.state().counters.pivots);
    CHECK(freeing.state().edges.empty());
    CHECK_FALSE(plain.state().edges.empty());
}

TEST_CASE("the hash differs between states at every phase") {
    const PointSet points = sceneNamed("figure-8");
    Stepper stepper(points, paper());
    std::vector<std::uint64_t> seen;
    do {
        seen.push_back(stateHash(stepper.state()));
    } while (stepper.advance());
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

TEST_CASE("the hash covers which point is on which stacked ring") {
    // The same points in the same order, three and two of them or two and three.
    const auto hashOf = [](Index ofFirst) {
        State state(5);
        for (const auto& [from, to] : {std::pair<Index, Index>{0, ofFirst}, {ofFirst, 5}}) {
            Index entry = state.rings.next(state.rings.start(from, from + 1));
            for (Index point = from + 2; point < to; ++point)
                entry = state.rings.insertAfter(entry, point);
            const Index ring = state.rings.active();
            state.rings.push(ring, state.rings.head(ring));
        }
        return stateHash(state);
    };
    CHECK(hashOf(3) != hashOf(2));
}

TEST_CASE("takeState gives the run away and starts over") {
    const PointSet points = sceneNamed("figure-8");
    Stepper stepper(points, paper());
    stepper.run();
    const State taken = stepper.takeState();
    CHECK(taken.triangles.size() == 74);
    CHECK(stateHash(stepper.state()) == stateHash(State(points.size())));
}

TEST_CASE("a run that makes too many triangles is stopped with an alert") {
    const PointSet points = sceneNamed("figure-8");
    Params params = paper();
    params.maxTrianglesPerPoint = 1;
    Stepper stepper(points, params);
    CHECK(stepper.run() == StopReason::Capped);
    CHECK(stepper.state().alerts.back().kind == AlertKind::TriangleCap);
    CHECK(stepper.state().finished());
    CHECK(stepper.state().triangles.size() <= points.size() + 12);
}

TEST_CASE("equal on every machine and build: pinned triangles of three scenes") {
    // If a deliberate change of the algorithm or of a scene moves these, pin the new values.
    const auto hashOf = [](std::string_view id) {
        return triangleHash(runAll(sceneNamed(id), paper()).state);
    };
    CHECK(hashOf("grid") == 17800343098606382897ULL);
    CHECK(hashOf("figure-12") == 9090584713349510477ULL);
    CHECK(hashOf("sheet") == 7475980425805152956ULL);
}

TEST_CASE("moved by a million, exactly, the points give the same triangles and events") {
    PointFile file = findScene("figure-12")->build();
    for (Vec3& x : file.position) x = glm::round(x * 0x1p20) * 0x1p-20;
    const PointSet near = prepared(file);
    for (Vec3& x : file.position) x += Vec3(1e6, -1e6, 1e6);
    const PointSet far = prepared(file);
    CHECK(near.neighbors.ids == far.neighbors.ids);
    EventLog nearLog;
    EventLog farLog;
    const Run atHome = runAll(near, paper(), &nearLog);
    const Run away = runAll(far, paper(), &farLog);
    CHECK(atHome.state.triangles == away.state.triangles);
    CHECK(stateHash(atHome.state) == stateHash(away.state));
    REQUIRE(nearLog.events().size() == farLog.events().size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < nearLog.events().size(); ++i) {
        const Event& a = nearLog.events()[i];
        const Event& b = farLog.events()[i];
        different += a.address == b.address && describe(a) == describe(b) ? 0 : 1;
    }
    CHECK(different == 0);
}

TEST_CASE("An observer is shown the decisions of the log, and its run ends in the same state") {
    for (const char* rules : {"paper", "robust"}) {
        CAPTURE(rules);
        const Params params = paramsByName(rules).value();
        const PointSet points = sceneNamed("long-lists");
        EventLog log;
        Stepper logged(points, params, &log);
        CHECK(logged.run() == StopReason::Finished);
        std::vector<Address> shown;
        Stepper observed(points, params);
        observed.setObserver([&](const Event& event) {
            shown.push_back(event.address);
            return false;
        });
        CHECK(observed.run() == StopReason::Finished);
        CHECK(stateHash(observed.state()) == stateHash(logged.state()));
        REQUIRE(shown.size() == log.events().size());
        for (std::size_t i = 0; i < shown.size(); ++i) CHECK((shown[i] == log.events()[i].address));
    }
}

TEST_CASE(
    "An observer stops a run after the phase of the decision, and the run goes on from there") {
    const PointSet points = sceneNamed("torus");
    Stepper whole(points, {});
    whole.run();
    Stepper stepper(points, {});
    const Address wanted{40, Stage::Sphere, 1};
    stepper.setObserver([&](const Event& event) { return event.address == wanted; });
    CHECK(stepper.run() == StopReason::Observer);
    CHECK(stepper.stopped());
    CHECK(stepper.state().counters.pivots == 40);
    CHECK(stepper.state().phase == Phase::TwoPoint);
    CHECK(stepper.run() == StopReason::Finished);
    CHECK_FALSE(stepper.stopped());
    CHECK(stateHash(stepper.state()) == stateHash(whole.state()));
    // Within a pivot, stepPivot() ends as well.
    Stepper single(points, {});
    single.setObserver([&](const Event& event) { return event.address == wanted; });
    while (single.stepPivot()) {
    }
    CHECK(single.stopped());
    CHECK(single.state().phase == Phase::TwoPoint);
    single.setObserver({});
    CHECK(single.run() == StopReason::Finished);
    CHECK(stateHash(single.state()) == stateHash(whole.state()));
}

TEST_CASE("A stepper keeps points alive that were moved into it, and borrows others") {
    static_assert(!std::is_constructible_v<Stepper, const PointSet&&, Params>);
    PointSet points = sceneNamed("torus");
    Stepper borrowed(points, {});
    CHECK(&borrowed.points() == &points);
    borrowed.run();
    Stepper owning(std::move(points), {});
    owning.run();
    CHECK(stateHash(owning.state()) == stateHash(borrowed.state()));
    const auto shared = std::make_shared<const PointSet>(owning.points());
    Stepper sharing(shared, {});
    CHECK(&sharing.points() == shared.get());
}

namespace {

/// The last event of a run, which is the only one of its stage.
Event endOf(const PointSet& points, const Params& params, State& state) {
    EventLog log;
    Stepper stepper(points, params, &log);
    stepper.run();
    const auto& events = log.events();
    REQUIRE_FALSE(events.empty());
    const auto isEnd = [](const Event& e) { return e.address.stage == Stage::Finished; };
    CHECK(std::count_if(events.begin(), events.end(), isEnd) == 1);
    REQUIRE(isEnd(events.back()));
    state = stepper.takeState();
    return events.back();
}

}  // namespace

TEST_CASE("3 the last event of every run sums up its mesh, under the number after the last pivot") {
    for (const char* scene : {"sphere", "sheet", "linked-tori", "stranded-point"}) {
        for (const char* rules : {"paper", "robust"}) {
            CAPTURE(scene);
            CAPTURE(rules);
            const PointSet points = sceneNamed(scene);
            State state;
            const Event end = endOf(points, *paramsByName(rules), state);
            CHECK((end.address == Address{state.counters.pivots + 1, Stage::Finished, 1}));
            const MeshReport report = reportMesh(points, state.mesh());
            const auto& e = std::get<FinishedEvidence>(end.evidence);
            CHECK(e.triangles == state.mesh().size());
            CHECK(e.components == report.components);
            CHECK(e.unused == report.unusedPoints);
            CHECK(e.loops == report.boundaryLoops);
            CHECK_FALSE(e.capped);
        }
    }
}

TEST_CASE("3 a run without a triangle has an end as well") {
    PointFile file;
    file.position = {{0, 0, 0}};
    file.normal = {{0, 0, 1}};
    State state;
    const Event end = endOf(prepared(file), paper(), state);
    CHECK(end.address.pivot == 1);
    CHECK(std::get<FinishedEvidence>(end.evidence).unused == 1);
}

TEST_CASE("3 a run that is stopped ends with its last pivot") {
    Params params = paper();
    params.maxTrianglesPerPoint = 1;
    State state;
    const Event end = endOf(sceneNamed("figure-8"), params, state);
    REQUIRE(state.capped());
    CHECK(end.address.pivot == state.counters.pivots);
    CHECK(std::get<FinishedEvidence>(end.evidence).capped);
}
