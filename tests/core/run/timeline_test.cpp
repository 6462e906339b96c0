#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"

using namespace se;

namespace {

constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();

/// Hashes of a straight run, by pivots completed. The last one is that of the end.
std::map<std::uint32_t, std::uint64_t> straightHashes(const PointSet& points, std::uint64_t& end,
                                                      const Params& params = {}) {
    Stepper stepper(points, params);
    std::map<std::uint32_t, std::uint64_t> hashes;
    hashes.emplace(0, stateHash(stepper.state()));
    while (stepper.stepPivot()) {
        hashes.try_emplace(stepper.state().counters.pivots, stateHash(stepper.state()));
    }
    end = stateHash(stepper.state());
    return hashes;
}

}  // namespace

TEST_CASE("Seeking every pivot from the last to the first gives the states of a straight run") {
    // The second run has alerts.
    for (const auto& [scene, rules] :
         {std::pair("linked-tori", "paper"), {"wrong-lists", "paper"}, {"linked-tori", "robust"}}) {
        const Params params = paramsByName(rules).value();
        const PointSet points = test::sceneNamed(scene);
        std::uint64_t end = 0;
        const auto hashes = straightHashes(points, end, params);
        // The second budget is far too small for more than a few keyframes.
        for (const std::size_t budget : {Timeline::defaultBudget(points), std::size_t{20'000}}) {
            CAPTURE(scene);
            CAPTURE(rules);
            CAPTURE(budget);
            Timeline timeline(points, params, budget);
            timeline.seek(kEnd);
            CHECK(timeline.endKnown());
            CHECK(stateHash(timeline.state()) == end);
            for (auto it = hashes.rbegin(); it != hashes.rend(); ++it) {
                timeline.seek(it->first);
                REQUIRE(timeline.position() == it->first);
                REQUIRE(stateHash(timeline.state()) == it->second);
            }
        }
    }
}

TEST_CASE("Going back restores all that a State holds, not only what its hash covers") {
    const PointSet points = test::sceneNamed("linked-tori");
    const Params params = paramsByName("robust").value();
    Timeline timeline(points, params, 20'000);
    timeline.seek(kEnd);
    for (std::uint32_t place = timeline.farthest(); place > 37; place -= 37) {
        timeline.seek(place - 37);
        Stepper straight(points, params);
        straight.runUntil([&](const State& s) { return s.counters.pivots == timeline.position(); });
        const State& a = timeline.state();
        const State& b = straight.state();
        REQUIRE(a.status == b.status);
        REQUIRE(a.done == b.done);
        REQUIRE(a.triangles == b.triangles);
        REQUIRE(a.mesh() == b.mesh());
        for (Index p = 0; p < points.size(); ++p) {
            Index x = a.rings.firstEntryOf(p);
            Index y = b.rings.firstEntryOf(p);
            for (; x != kNone && y != kNone;
                 x = a.rings[x].nextOfPoint, y = b.rings[y].nextOfPoint) {
                REQUIRE(x == y);
            }
            REQUIRE(x == y);
            REQUIRE(a.edges.firstFrom(p) == b.edges.firstFrom(p));
        }
    }
}

TEST_CASE("Keyframes stay within their budget, and their size is that of the rings") {
    const PointSet points = test::sceneNamed("torus");
    constexpr std::size_t kBudget = 100'000;
    Timeline timeline(points, Params{}, kBudget);
    timeline.seek(kEnd);
    CHECK(timeline.keyframeBytes() <= kBudget);
    CHECK(timeline.keyframeBytes() > kBudget / 4);
}

TEST_CASE("Events after the last pivot have a number of their own") {
    // Two points that list each other, and one that has an empty list and is stranded at the end.
    PointSet points;
    points.position = {{0, 0, 0}, {1, 0, 0}, {9, 9, 9}};
    points.normal = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    points.type = {0, 0, 0};
    const Index zero[] = {1};
    const Index one[] = {0};
    points.neighbors.append(zero);
    points.neighbors.append(one);
    points.neighbors.append({});
    Timeline timeline(points, Params{});
    timeline.seek(kEnd);
    REQUIRE(timeline.endKnown());
    REQUIRE(timeline.lastPivot() == timeline.position() + 1);
    const std::vector<Event> tail = timeline.record(timeline.lastPivot())->events;
    // The pair, whose seeds get no triangle, is stranded there as well.
    REQUIRE(tail.size() == 4);
    for (std::size_t i = 0; i < 3; ++i) CHECK(tail[i].address.stage == Stage::Strand);
    CHECK(tail[3].address.stage == Stage::Finished);
    CHECK(timeline.state().finished());
}

TEST_CASE("A seek can be stopped and resumed") {
    const PointSet points = test::sceneNamed("torus");
    std::uint64_t end = 0;
    const auto hashes = straightHashes(points, end);
    Timeline timeline(points, Params{});
    int asked = 0;
    timeline.seek(kEnd, [&] { return ++asked < 3; });
    CHECK(asked == 3);
    CHECK(timeline.position() > 0);
    CHECK_FALSE(timeline.endKnown());
    CHECK(stateHash(timeline.state()) == hashes.at(timeline.position()));
    timeline.seek(kEnd);
    CHECK(stateHash(timeline.state()) == end);
}

TEST_CASE("A mesh that is edited at the end takes no keyframes from the pivots") {
    const PointSet points = test::sceneNamed("linked-tori");
    const Params params = paramsByName("robust").value();
    Stepper straight(points, params);
    straight.runUntil([](const State& s) { return !s.repair.empty(); });
    const std::uint32_t pivots = straight.state().counters.pivots;
    // The edited mesh is larger than a quarter of this budget, and than all of it.
    Timeline timeline(points, params, 20'000);
    timeline.seek(pivots);
    const std::size_t bytes = timeline.keyframeBytes();
    timeline.seek(kEnd);
    REQUIRE(timeline.position() > pivots + 100);
    CHECK(timeline.keyframeBytes() == bytes);
}

TEST_CASE("A stepper set to any place after the last pivot reaches the end of the run" *
          doctest::test_suite("long")) {
    const Params params = paramsByName("robust").value();
    std::uint32_t steps = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        const PointSet points = test::randomPoints(seed);
        Timeline timeline(points, params);
        timeline.seek(kEnd);
        const std::uint64_t end = stateHash(timeline.state());
        const std::uint32_t last = timeline.farthest();
        // Back through the whole run, with a look at the events of each step, which makes it again.
        for (std::uint32_t pivot = last; pivot > 0; --pivot) {
            timeline.seek(pivot);
            REQUIRE(timeline.position() == pivot);
            if (timeline.state().repair.empty()) break;
            ++steps;
            Stepper stepper(points, params);
            stepper.setState(timeline.state());
            stepper.run();
            CHECK(stateHash(stepper.state()) == end);
            CHECK_FALSE(timeline.record(pivot)->events.empty());
        }
        // Forward again, in one move and step by step.
        timeline.seek(kEnd);
        CHECK(stateHash(timeline.state()) == end);
        timeline.seek(last > 5 ? last - 5 : 0);
        while (timeline.stepPivot()) {
        }
        CHECK(stateHash(timeline.state()) == end);
    }
    CHECK(steps > 250);
}

TEST_CASE("Seeking goes back to a given start") {
    const PointSet points = test::sceneNamed("figure-11");
    const Params params = test::withStartOf(*findScene("figure-11"), test::paper());
    Timeline timeline(points, params);
    const std::uint64_t begin = stateHash(timeline.state());
    timeline.seek(0xffffffffU);
    const std::uint64_t end = stateHash(timeline.state());
    timeline.seek(0);
    CHECK(stateHash(timeline.state()) == begin);
    CHECK(begin == stateHash(startState(points, params)));
    timeline.seek(0xffffffffU);
    CHECK(stateHash(timeline.state()) == end);
}

TEST_CASE("A timeline shows its visitor every event once, in order, wherever it moves meanwhile") {
    for (const char* rules : {"paper", "robust"}) {
        CAPTURE(rules);
        const Params params = paramsByName(rules).value();
        const PointSet points = test::sceneNamed("uneven-density");
        std::vector<std::string> swept;
        const auto end = sweep(points, params, [&](const SweptPivot& pivot) {
            for (const Event& event : pivot.events) swept.push_back(describe(event));
        });
        REQUIRE(end.has_value());
        std::vector<std::string> shown;
        Timeline timeline(points, params, 20'000);
        timeline.setVisitor([&](const SweptPivot& pivot) {
            CHECK(pivot.point == pivotPoint(pivot.events));
            for (const Event& event : pivot.events) shown.push_back(describe(event));
        });
        // Two steps forward, one back, with records on the way, as a user moves while it is made.
        for (std::uint32_t place = 20; !timeline.endKnown(); place += 10) {
            timeline.seek(place);
            timeline.record(place > 30 ? place - 30 : 0);
            timeline.record(place / 2);
        }
        timeline.seek(kEnd);
        CHECK(shown == swept);
        CHECK(stateHash(timeline.state()) == stateHash(*end));
    }
}

TEST_CASE("A pass in slices is the pass in one go") {
    const PointSet points = test::sceneNamed("linked-tori");
    const Params params = paramsByName("robust").value();
    std::vector<std::uint32_t> whole;
    const auto end = sweep(points, params, [&](const SweptPivot& pivot) {
        whole.push_back(pivot.events.front().address.pivot);
    });
    std::vector<std::uint32_t> sliced;
    Sweep pass(points, params, [&](const SweptPivot& pivot) {
        sliced.push_back(pivot.events.front().address.pivot);
    });
    double share = 0.0;
    while (pass.advance(7)) {
        CHECK(pass.share() >= share);
        share = pass.share();
    }
    CHECK(pass.share() == 1.0);
    CHECK(sliced == whole);
    CHECK(stateHash(pass.state()) == stateHash(*end));
    CHECK_FALSE(pass.advance(7));
}

TEST_CASE("Steps after the last pivot that were passed are made again, and shown to nobody") {
    const Params params = paramsByName("robust").value();
    const PointSet points = test::prepared(test::fibonacciSphere(600));
    std::uint64_t end = 0;
    const auto hashes = straightHashes(points, end, params);
    std::size_t shown = 0;
    Timeline timeline(points, params);
    timeline.setVisitor([&](const SweptPivot&) { ++shown; });
    // In the shortest slices, with a move away after every few of them.
    int cutShort = 0;
    for (int slice = 1; !timeline.state().finished(); ++slice) {
        timeline.makeRest([] { return false; });
        if (slice % 19 != 0 || timeline.state().finished()) continue;
        cutShort += timeline.state().repair.empty() ? 0 : 1;
        timeline.seek(slice % 2 == 0 ? 5 : timeline.position() + 1);
    }
    CHECK(cutShort > 0);
    CHECK(stateHash(timeline.state()) == end);
    CHECK(shown == timeline.lastPivot());
    timeline.seek(5);
    for (auto it = hashes.rbegin(); it != hashes.rend(); ++it) {
        timeline.seek(it->first);
        REQUIRE(stateHash(timeline.state()) == it->second);
    }
    timeline.seek(kEnd);
    CHECK(stateHash(timeline.state()) == end);
    CHECK(shown == timeline.lastPivot());
}
