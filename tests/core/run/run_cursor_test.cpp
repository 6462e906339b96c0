#include "spiraling_edge/run/run_cursor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "spiraling_edge/run/event_text.h"
#include "support/clouds.h"

using namespace se;

namespace {

std::string placeOf(const RunCursor& cursor) {
    return cursor.event() == nullptr ? "start" : toString(cursor.event()->address);
}

}  // namespace

TEST_CASE("Forward by decision passes every event of the run once, and back takes the same way") {
    for (const char* rules : {"paper", "robust"}) {
        CAPTURE(rules);
        const Params params = paramsByName(rules).value();
        const PointSet points = test::sceneNamed("long-lists");
        std::vector<std::string> expected{"start"};
        for (const Event& event : test::eventsOf(points, params))
            expected.push_back(toString(event.address) + describe(event));
        RunCursor cursor(points, params);
        const auto here = [&] {
            return placeOf(cursor) + (cursor.event() ? describe(*cursor.event()) : "");
        };
        std::vector<std::string> places{here()};
        while (cursor.forward()) places.push_back(here());
        CHECK(places == expected);
        for (auto place = places.rbegin(); place != places.rend(); ++place) {
            CHECK(here() == *place);
            CHECK(cursor.back() == (*place != "start"));
        }
    }
}

TEST_CASE("A step by phase ends at the last decision of a stage, one by pivot at that of a pivot") {
    RunCursor cursor(test::sceneNamed("torus"), {});
    REQUIRE(cursor.goTo({30, Stage::Sort, 1}));
    REQUIRE(cursor.forward(StepUnit::Phase));
    const std::size_t sorts = cursor.event()->address.n;
    CHECK(cursor.event()->address.stage == Stage::Sort);
    CHECK(sorts > 1);
    REQUIRE(cursor.forward());
    CHECK(cursor.event()->address.stage != Stage::Sort);
    REQUIRE(cursor.back(StepUnit::Phase));
    CHECK(placeOf(cursor) == "30.sort." + std::to_string(sorts));
    REQUIRE(cursor.forward(StepUnit::Pivot));
    CHECK(cursor.event() == &cursor.pivot().events.back());
    CHECK(cursor.pivot().pivot == 30);
    REQUIRE(cursor.forward(StepUnit::Pivot));
    CHECK(cursor.pivot().pivot == 31);
    REQUIRE(cursor.back(StepUnit::Pivot));
    CHECK(cursor.pivot().pivot == 30);
    CHECK(cursor.state().complete);
}

TEST_CASE("The end of a run is its last event, also where the run was not made before") {
    for (const char* rules : {"paper", "robust"}) {
        CAPTURE(rules);
        const PointSet points = test::sceneNamed("torus");
        const Params params = paramsByName(rules).value();
        const std::string last = toString(test::eventsOf(points, params).back().address);
        RunCursor cursor(points, params);
        cursor.goToEnd();
        CHECK(placeOf(cursor) == last);
        CHECK_FALSE(cursor.forward());
        CHECK(cursor.pivot().isLast);
        REQUIRE(cursor.back());
        REQUIRE(cursor.forward());
        CHECK(placeOf(cursor) == last);
    }
}

TEST_CASE("The cursor stays where it is if the run has no such decision") {
    RunCursor cursor(test::sceneNamed("torus"), {});
    CHECK_FALSE(cursor.back());
    REQUIRE(cursor.goTo({30, Stage::Sphere, 1}));
    CHECK_FALSE(cursor.goTo({30, Stage::Sphere, 999}));
    const std::uint32_t position = cursor.timeline().position();
    CHECK_FALSE(cursor.goTo({1'000'000, Stage::Sphere, 1}));
    CHECK(cursor.timeline().position() == position);
    CHECK(placeOf(cursor) == "30.sphere.1");
    cursor.goToEnd();
    const std::string last = placeOf(cursor);
    CHECK_FALSE(cursor.forward());
    CHECK_FALSE(cursor.forward(StepUnit::Pivot));
    CHECK(placeOf(cursor) == last);
    cursor.goToStart();
    CHECK(placeOf(cursor) == "start");
    CHECK(cursor.state().rings.empty());
}

TEST_CASE("A number alone is where a pivot begins, and a step after the last pivot too") {
    const PointSet points = test::sceneNamed("long-lists");
    const Params params = paramsByName("robust").value();
    const std::vector<Event> events = test::eventsOf(points, params);
    RunCursor cursor(points, params);
    std::size_t late = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Address& first = events[i].address;
        if (i > 0 && events[i - 1].address.pivot == first.pivot) continue;
        REQUIRE_MESSAGE(cursor.goTo({first.pivot}), first.pivot);
        const auto end =
            std::find_if(events.begin() + static_cast<std::ptrdiff_t>(i), events.end(),
                         [&](const Event& event) { return event.address.pivot != first.pivot; });
        const auto pivot =
            std::find_if(events.begin() + static_cast<std::ptrdiff_t>(i), end,
                         [](const Event& event) { return event.address.stage == Stage::Pivot; });
        late += pivot == end ? 1 : 0;
        CHECK(placeOf(cursor) == toString(pivot == end ? first : pivot->address));
    }
    CHECK(late > 3);
    CHECK_FALSE(cursor.goTo({events.back().address.pivot + 1}));
}

TEST_CASE("Running until a condition stops at the first decision that a scan of the run finds") {
    const PointSet points = test::sceneNamed("torus");
    for (const char* line :
         {"verdict=removed", "stage=split", "stage=done", "margin<1e-2", "stage=emit"}) {
        CAPTURE(line);
        const DecisionQuery query = DecisionQuery::parse(line).value();
        const auto matches = [&](const Decision& decision) { return query.matches(decision); };
        const FoundDecisions scanned = findDecisions(points, {}, query, 3).value();
        REQUIRE_FALSE(scanned.lines.empty());
        RunCursor cursor(points, {});
        for (const LedgerLine& hit : scanned.lines) {
            REQUIRE(cursor.runUntil(matches));
            CHECK(placeOf(cursor) == toString(hit.event.address));
        }
        if (scanned.total > scanned.lines.size()) continue;
        CHECK_FALSE(cursor.runUntil(matches));
        CHECK_FALSE(cursor.forward());
    }
}

TEST_CASE("The neighbor ring runs from start to end by angle and loses what the sphere removes") {
    RunCursor cursor(test::sceneNamed("torus"), {});
    REQUIRE(cursor.runUntil([](const Decision& decision) {
        const auto* sphere = as<SphereEvidence>(decision.event);
        return sphere != nullptr && sphere->verdict == Verdict::Removed;
    }));
    const Index removed = as<SphereEvidence>(*cursor.event())->q;
    const DecisionState after = cursor.state();
    REQUIRE(cursor.back());
    const DecisionState before = cursor.state();
    const std::vector<RingPoint> ring = before.neighborRing();
    REQUIRE(ring.size() > 2);
    CHECK(ring.front() == RingPoint{before.start, before.startDegrees});
    CHECK(ring.back() == RingPoint{before.end, before.endDegrees});
    for (std::size_t i = 1; i < ring.size(); ++i) {
        CHECK(ring[i - 1].degrees < ring[i].degrees);
    }
    std::vector<RingPoint> rest = ring;
    CHECK(std::erase_if(rest, [&](const RingPoint& each) { return each.point == removed; }) == 1);
    CHECK(after.neighborRing() == rest);
}

TEST_CASE("Each two points of the fan that follow each other make a triangle with the pivot") {
    RunCursor cursor(test::sceneNamed("torus"), {});
    int moved = 0;
    for (int fans = 0; fans < 200; ++fans) {
        REQUIRE(cursor.runUntil([](const Decision& decision) {
            return decision.event.address.stage == Stage::Emit && decision.event.address.n == 1;
        }));
        REQUIRE(cursor.back());
        const DecisionState before = cursor.state();
        const std::vector<RingPoint> fan = before.fan();
        moved += before.startPath.empty() && before.endPath.empty() ? 0 : 1;
        REQUIRE(cursor.forward());
        REQUIRE(cursor.forward(StepUnit::Phase));
        const std::vector<Triangle> made = cursor.state().newTriangles;
        CAPTURE(placeOf(cursor));
        REQUIRE(made.size() + 1 == fan.size());
        for (std::size_t i = 0; i < made.size(); ++i) {
            CHECK(made[i] == Triangle{before.pivot, fan[i].point, fan[i + 1].point});
        }
    }
    CHECK(moved > 50);
}

TEST_CASE("A cursor over points that were moved into it keeps them alive") {
    static_assert(!std::is_copy_constructible_v<RunCursor>);
    const Params params = paramsByName("robust").value();
    const auto make = [&] {
        RunCursor cursor(test::sceneNamed("torus"), params);
        cursor.goToEnd();
        return cursor;
    };
    RunCursor cursor = make();
    REQUIRE(cursor.back());
    REQUIRE(cursor.forward());
    CHECK(cursor.pivot().isLast);
    CHECK(cursor.timeline().points().size() == test::sceneNamed("torus").size());
}
