#include "spiraling_edge/explain/closest_calls.h"

#include <doctest/doctest.h>

#include <cmath>

#include "spiraling_edge/replay/timeline.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

ClosestCalls callsOf(const PointSet& points, const Params& params, std::size_t count) {
    const Result<ClosestCalls> calls = closestCalls(points, params, count);
    REQUIRE(calls.ok());
    return calls.value();
}

/// The event at an address; null if the run has none there.
const Event* eventAt(const std::vector<Event>& events, const Address& address) {
    for (const Event& event : events) {
        if (event.address == address) return &event;
    }
    return nullptr;
}

}  // namespace

TEST_CASE("closest calls: nudging the listed point by the listed amount turns the decision") {
    for (const char* set : {"paper", "robust"}) {
        const Params params = *paramsByName(set);
        for (const Family& family : closedFamilies()) {
            CAPTURE(set);
            CAPTURE(family.name);
            PointSet points = prepared(family.sample(5));
            const ClosestCalls calls = callsOf(points, params, 6);
            REQUIRE(calls.calls.size() == 6);
            for (const ClosestCall& call : calls.calls) {
                CAPTURE(describe(call.event));
                CAPTURE(call.reading.margin);
                const Vec3 before = points.position[call.nudge.point];
                points.position[call.nudge.point] += call.nudge.by;
                Timeline timeline(points, params);
                const std::vector<Event> events = timeline.eventsOf(call.event.address.pivot);
                points.position[call.nudge.point] = before;
                const Event* now = eventAt(events, call.event.address);
                REQUIRE(now != nullptr);
                CHECK(outcomeOf(*now) != outcomeOf(call.event));
            }
        }
    }
}

TEST_CASE("closest calls: by margin, and the moves are as small as the margins") {
    const PointSet points = prepared(closedFamilies()[1].sample(2));
    const ClosestCalls calls = callsOf(points, paper(), 50);
    REQUIRE(calls.calls.size() == 50);
    for (std::size_t i = 0; i < calls.calls.size(); ++i) {
        const ClosestCall& call = calls.calls[i];
        const double margin = std::abs(call.reading.margin);
        if (i > 0) CHECK(margin >= std::abs(calls.calls[i - 1].reading.margin));
        // Taken is positive, refused negative.
        CHECK((call.reading.margin >= 0.0) == (outcomeOf(call.event) == Outcome::Taken));
        const double arm =
            glm::length(points.position[call.nudge.point] - points.position[call.pivot]);
        CHECK(glm::length(call.nudge.by) <= 10.0 * margin * arm + 1e-8);
        CHECK(calls.leastMargin[testedPoint(call.event)] <= margin);
    }
}

TEST_CASE("closest calls: a lattice decides at the very limit") {
    // In a square grid neighbors are at 0, 45, 90 ... degrees: first and last among them.
    PointFile file;
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) file.position.emplace_back(x, y, 0.0);
    }
    file.normal.assign(file.position.size(), {0, 0, 1});
    const ClosestCalls calls = callsOf(prepared(file), paper(), 10);
    REQUIRE_FALSE(calls.calls.empty());
    CHECK(std::abs(calls.calls[0].reading.margin) < 1e-9);
}

TEST_CASE("closest calls: zero requested; cancelled") {
    const PointSet points = prepared(closedFamilies()[0].sample(2));
    CHECK(callsOf(points, paper(), 0).calls.empty());
    CHECK_FALSE(closestCalls(points, paper(), 5, [](double) { return false; }).ok());
}
