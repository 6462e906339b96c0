#include "spiraling_edge/run/moved_pivot.h"

#include <doctest/doctest.h>

#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/timeline.h"
#include "support/clouds.h"

using namespace se;

namespace {

std::vector<std::string> sentencesOf(const PivotRecord& record) {
    std::vector<std::string> made;
    for (const Event& event : record.events)
        made.push_back(toString(event.address) + " " + describe(event));
    return made;
}

/// The first point that is removed in a sphere test of that pivot.
Index removedPoint(const PivotRecord& record) {
    for (const Event& event : record.events) {
        if (event.address.stage == Stage::Sphere && outcomeOf(event) == Outcome::Refused)
            return subjectOf(event);
    }
    return kNone;
}

}  // namespace

TEST_CASE("A moved pivot is that of the run with the move as a what-if") {
    const PointSet points = test::sceneNamed("torus");
    for (const char* rules : {"paper", "robust"}) {
        for (const std::uint32_t number : {1U, 7U, 60U, 200U}) {
            CAPTURE(rules);
            CAPTURE(number);
            Params params = paramsByName(rules).value();
            const auto moved = MovedPivot::make(points, params, number);
            REQUIRE(moved);
            CHECK(moved->pivot() == number);
            const auto plain = Timeline(points, params).record(number);
            const Index point = points.neighbors[subjectOf(plain->events.front())][0];
            const Vec3 to = points.position[point] + Vec3(0.02, -0.01, 0.03);
            params.whatIf = {{WhatIfKind::Move, number, Stage::Pivot, point, to, {}}};
            const auto expected = Timeline(points, params).record(number);
            const auto found = moved->record(point, to);
            CHECK(sentencesOf(*found) == sentencesOf(*expected));
            CHECK(found->after.status == expected->after.status);
            CHECK(found->after.triangleCount == expected->after.triangleCount);
            const auto unmoved = moved->record(point, points.position[point]);
            CHECK(unmoved->after.status == plain->after.status);
        }
    }
}

TEST_CASE("The turn of a moved pivot parts the two outcomes of a decision") {
    const PointSet points = test::sceneNamed("torus");
    std::size_t turns = 0;
    for (std::uint32_t number = 20; number < 60; ++number) {
        const auto plain = Timeline(points, Params{}).record(number);
        const Index q = removedPoint(*plain);
        if (q == kNone) continue;
        const auto moved = MovedPivot::make(points, Params{}, number);
        REQUIRE(moved);
        const PointDecisions decisions{Stage::Sphere, q};
        REQUIRE(outcomeOf(*plain, decisions) == Outcome::Refused);
        // Toward the pivot: into the sphere.
        const Vec3 from = points.position[q];
        const Vec3 to = points.position[subjectOf(plain->events.front())];
        const auto turn = moved->turn(q, from, 0.9 * to + 0.1 * from, decisions);
        if (!turn) continue;
        ++turns;
        const auto outcomeAt = [&](double share) {
            const Vec3 place = from + share * (0.9 * to + 0.1 * from - from);
            return outcomeOf(*moved->record(q, place), decisions);
        };
        CHECK(outcomeAt(*turn) != Outcome::Refused);
        CHECK(outcomeAt(*turn - 1e-4) == Outcome::Refused);
    }
    CHECK(turns > 3);
}

TEST_CASE("A moved pivot is refused where the run has no such pivot") {
    const PointSet points = test::sceneNamed("torus");
    CHECK_FALSE(MovedPivot::make(points, Params{}, 0));
    CHECK_FALSE(MovedPivot::make(points, Params{}, 1'000'000));
    CHECK_FALSE(MovedPivot::make(points, Params{}, 300, [] { return false; }));
}
