#include "spiraling_edge/why/nearest_decisions.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "spiraling_edge/run/timeline.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

NearestDecisions nearestOf(const PointSet& points, const Params& params, std::size_t count) {
    const Result<NearestDecisions> decisions = nearestDecisions(points, params, count);
    REQUIRE(decisions.ok());
    return decisions.value();
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
            const NearestDecisions decisions = nearestOf(points, params, 6);
            REQUIRE(decisions.decisions.size() == 6);
            for (const NearestDecision& decision : decisions.decisions) {
                CAPTURE(describe(decision.event));
                CAPTURE(decision.reading.margin);
                const Vec3 before = points.position[decision.move.point];
                points.position[decision.move.point] += decision.move.by;
                Timeline timeline(points, params);
                const std::vector<Event> events =
                    timeline.record(decision.event.address.pivot)->events;
                points.position[decision.move.point] = before;
                const Event* now = eventAt(events, decision.event.address);
                REQUIRE(now != nullptr);
                CHECK(outcomeOf(*now) != outcomeOf(decision.event));
            }
        }
    }
}

TEST_CASE("closest calls: by margin, and the moves are as small as the margins") {
    const PointSet points = prepared(closedFamilies()[1].sample(2));
    const NearestDecisions decisions = nearestOf(points, paper(), 50);
    REQUIRE(decisions.decisions.size() == 50);
    for (std::size_t i = 0; i < decisions.decisions.size(); ++i) {
        const NearestDecision& decision = decisions.decisions[i];
        const double margin = std::abs(decision.reading.margin);
        if (i > 0) CHECK(margin >= std::abs(decisions.decisions[i - 1].reading.margin));
        // Taken is positive, refused negative.
        CHECK((decision.reading.margin >= 0.0) == (outcomeOf(decision.event) == Outcome::Taken));
        const double arm =
            glm::length(points.position[decision.move.point] - points.position[decision.pivot]);
        CHECK(glm::length(decision.move.by) <= 10.0 * margin * arm + 1e-8);
        CHECK(decisions.leastMargin[testedPoint(decision.event)] <= margin);
    }
}

TEST_CASE("closest calls: where a third point of 7 is first or last, angles begin or end at it") {
    const PointSet points = sceneNamed("sheet");
    const Params params = paper();
    std::set<std::uint32_t> pivots;
    for (const Event& event : eventsOf(points, params)) {
        const auto* insert = std::get_if<InsertEvidence>(&event.evidence);
        if (insert != nullptr && insert->third != kNone) pivots.insert(event.address.pivot);
    }
    int seen = 0;
    for (const NearestDecision& decision : nearestOf(points, params, 400).decisions) {
        if (!pivots.contains(decision.event.address.pivot)) continue;
        CAPTURE(describe(decision.event));
        const double arm =
            glm::length(points.position[decision.move.point] - points.position[decision.pivot]);
        CHECK(glm::length(decision.move.by) <=
              10.0 * std::abs(decision.reading.margin) * arm + 1e-8);
        ++seen;
    }
    CHECK(seen > 3);
}

TEST_CASE("closest calls: the least margin of a point is that of all its tests, near either side") {
    const PointSet points = prepared(closedFamilies(0.3)[0].sample(4));
    const Params params = paper();
    const std::vector<Event> events = eventsOf(points, params);
    std::vector<double> least(points.size(), std::numeric_limits<double>::infinity());
    Index pivot = kNone;
    std::size_t refused = 0;
    for (const Event& event : events) {
        if (const auto* e = std::get_if<PivotEvidence>(&event.evidence)) pivot = e->pivot;
        const auto reading = readingOf(event, {points, params, pivot});
        const Index p = testedPoint(event);
        if (!reading || p == kNone) continue;
        refused += reading->margin < 0.0 ? 1 : 0;
        least[p] = std::min(least[p], std::abs(reading->margin));
    }
    CHECK(refused > 0);
    CHECK(nearestOf(points, params, 1).leastMargin == least);
}

TEST_CASE("closest calls: a lattice decides at the very limit") {
    // In a square grid neighbors are at 0, 45, 90 ... degrees: first and last among them.
    PointFile file;
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) file.position.emplace_back(x, y, 0.0);
    }
    file.normal.assign(file.position.size(), {0, 0, 1});
    const NearestDecisions decisions = nearestOf(prepared(file), paper(), 10);
    REQUIRE_FALSE(decisions.decisions.empty());
    CHECK(std::abs(decisions.decisions[0].reading.margin) < 1e-9);
}

TEST_CASE("closest calls: zero requested, cancelled") {
    const PointSet points = prepared(closedFamilies()[0].sample(2));
    CHECK(nearestOf(points, paper(), 0).decisions.empty());
    CHECK_FALSE(nearestDecisions(points, paper(), 5, [](double) { return false; }).ok());
}
