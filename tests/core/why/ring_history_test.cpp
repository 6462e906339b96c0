#include "spiraling_edge/why/ring_history.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

std::vector<LedgerLine> found(const PointSet& points, const char* line) {
    const auto query = DecisionQuery::parse(line);
    REQUIRE(query.ok());
    return findDecisions(points, paper(), query.value(), 1'000'000).value().lines;
}

RingHistory historyOf(const PointSet& points, const RingAddress& ring) {
    const auto history = whyRing(points, paper(), ring);
    REQUIRE(history.ok());
    return history.value();
}

bool has(const RingHistory& history, const Event& event) {
    return std::any_of(history.lines.begin(), history.lines.end(),
                       [&](const LedgerLine& line) { return line.event.address == event.address; });
}

}  // namespace

TEST_CASE("ring: places are written and read") {
    CHECK((ringAddressFromString("137").value() == RingAddress{{137, Stage::Pivot, 0}, 0}));
    CHECK((ringAddressFromString("137#2").value() == RingAddress{{137, Stage::Pivot, 0}, 2}));
    CHECK((ringAddressFromString("137.ring.4#1").value() == RingAddress{{137, Stage::Ring, 4}, 1}));
    for (const char* bad : {"", "#1", "137#", "137#0", "137#x", "dragon"}) {
        CAPTURE(bad);
        CHECK_FALSE(ringAddressFromString(bad).ok());
    }
    CHECK(nameOf(RingAddress{{137, Stage::Pivot, 0}, 0}) == "active ring at 137");
    CHECK(nameOf(RingAddress{{137, Stage::Ring, 4}, 2}) == "ring #2 at 137.ring.4");
    CHECK(nameOf(RingAddress{{137, Stage::Pivot, 1}, 0}) == "active ring at 137.pivot.1");
}

TEST_CASE("ring: the first ring has its seed as only ancestor, before and after it grows") {
    const PointSet points = prepared(findScene("torus")->build());
    for (const std::uint32_t pivot : {1U, 5U}) {
        const RingHistory history = historyOf(points, {{pivot, Stage::Pivot, 0}, 0});
        REQUIRE(history.lines.size() == 1);
        CHECK(toString(history.lines[0].event.address) == "1.seed.1");
        CHECK(history.answer.ends_with("(1.seed.1)"));
        CHECK(history.length >= 3);
    }
}

TEST_CASE("ring: a split makes both of its rings, and each came of all that made the one before") {
    const PointSet points = prepared(findScene("torus")->build());
    const std::vector<LedgerLine> splits = found(points, "stage=split");
    REQUIRE_FALSE(splits.empty());
    for (const LedgerLine& split : splits) {
        const Address at = split.event.address;
        const auto* e = std::get_if<SplitEvidence>(&split.event.evidence);
        REQUIRE(e != nullptr);
        const RingHistory active = historyOf(points, {at, 0});
        const RingHistory stacked = historyOf(points, {at, 1});
        CAPTURE(active.answer);
        CHECK((active.lines.back().event.address == at));
        CHECK((stacked.lines.back().event.address == at));
        CHECK(active.length == e->activeLength);
        CHECK(stacked.length == e->stackedLength);
        CHECK(toString(active.lines.front().event.address) == "1.seed.1");
        CHECK(active.cause + 1 == active.lines.size());
    }
}

TEST_CASE("ring: a join makes one ring that came of what made either") {
    const PointSet points = prepared(findScene("torus")->build());
    const std::vector<LedgerLine> joins = found(points, "stage=join");
    REQUIRE_FALSE(joins.empty());
    const Event& join = joins.front().event;
    const RingHistory joined = historyOf(points, {join.address, 0});
    CHECK((joined.lines.back().event.address == join.address));
    const auto* e = std::get_if<JoinEvidence>(&join.evidence);
    REQUIRE(e != nullptr);
    CHECK(joined.length == e->length);
    const RingHistory before = historyOf(points, {{join.address.pivot - 1, Stage::Pivot, 0}, 0});
    for (const LedgerLine& line : before.lines) CHECK(has(joined, line.event));
    CHECK(joined.lines.size() > before.lines.size());
}

TEST_CASE("ring: rings of two seeds that join came of both") {
    // Two hexagons with the point 1 in common. The ring around the first waits on the shelf; the
    // fan at 7 takes 1 from it.
    std::vector<Vec3> position{Vec3(0)};
    for (int i = 0; i < 6; ++i) position.push_back(polar(60.0 * i));
    position.emplace_back(2, 0, 0);
    for (const double degrees : {0.0, 60.0, 120.0, 240.0, 300.0})
        position.push_back(Vec3(2, 0, 0) + polar(degrees));
    std::vector<Points> lists(7, Points{0});
    lists[0] = {1, 2, 3, 4, 5, 6};
    lists.resize(13, Points{7});
    lists[7] = {8, 9, 10, 1, 11, 12};
    const PointSet points = pointsAt(position, lists);
    const Params params = paperBut(&RobustRules::shelve);

    const auto history = whyRing(points, params, {{8, Stage::Join, 1}, 0});
    REQUIRE(history.ok());
    CHECK(history.value().length == 12);
    std::vector<std::string> lines;
    for (const LedgerLine& line : history.value().lines)
        lines.push_back(toString(line.event.address));
    CHECK(lines == std::vector<std::string>{"1.seed.1", "8.seed.1", "8.join.1"});
}

TEST_CASE("ring: lengths and number of rings are those of the run at every pivot") {
    const PointSet points = prepared(findScene("stranded-point")->build());
    Timeline timeline(points, paper());
    for (const std::uint32_t pivot : {3U, 25U, 50U, 80U, 90U}) {
        timeline.seek(pivot);
        const EdgeRings& rings = timeline.state().rings;
        const Address at{pivot, Stage::Pivot, 0};
        const auto& stack = rings.stack();
        for (std::size_t k = 1; k <= stack.size(); ++k) {
            const RingHistory history = historyOf(points, {at, static_cast<Index>(k)});
            CHECK(history.length == rings.length(stack[stack.size() - k]));
        }
        if (rings.active() != kNone)
            CHECK(historyOf(points, {at, 0}).length == rings.length(rings.active()));
        CHECK_FALSE(whyRing(points, paper(), {at, static_cast<Index>(stack.size() + 1)}).ok());
    }
}

TEST_CASE("ring: an address that the run has not got is named") {
    const PointSet points = prepared(findScene("torus")->build());
    const auto history = whyRing(points, paper(), {{99999, Stage::Ring, 1}, 0});
    REQUIRE_FALSE(history.ok());
    CHECK(history.error().message.find("99999") != std::string::npos);
    CHECK_FALSE(
        whyRing(points, paper(), {{3, Stage::Pivot, 0}, 0}, [](double) { return false; }).ok());
}

TEST_CASE("ring: the history of a ring of a given start has no decision") {
    const PointSet points = sceneNamed("figure-11");
    const Params params = withStartOf(*findScene("figure-11"), paper());
    const auto history = whyRing(points, params, {{1, Stage::Pivot, 0}, 1});
    REQUIRE_FALSE(history.ok());
    CHECK(history.error().message ==
          "The ring #1 at 1 is one of the rings that the run begins with: no decision made it.");
}
