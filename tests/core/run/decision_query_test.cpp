#include "spiraling_edge/run/decision_query.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

DecisionQuery queryOf(const char* line) {
    const auto query = DecisionQuery::parse(line);
    REQUIRE(query.ok());
    return query.value();
}

FoundDecisions found(const PointSet& points, const char* line, std::size_t limit = 1000000) {
    const auto decisions = findDecisions(points, paper(), queryOf(line), limit);
    REQUIRE(decisions.ok());
    return decisions.value();
}

}  // namespace

TEST_CASE("query: an empty line finds every event of the run") {
    const PointSet points = prepared(closedFamilies()[0].sample(1));
    const std::vector<Event> events = eventsOf(points, paper());
    CHECK(found(points, "").total == events.size());
    CHECK(found(points, "  ", 5).lines.size() == 5);
}

TEST_CASE("query: every term matches exactly its decisions") {
    const PointSet points = prepared(closedFamilies()[1].sample(1));
    const FoundDecisions all = found(points, "");
    const auto count = [&](auto&& holds) {
        return static_cast<std::size_t>(std::count_if(all.lines.begin(), all.lines.end(), holds));
    };
    const auto verdict = [](const LedgerLine& line, Verdict wanted) {
        const auto* e = std::get_if<SphereEvidence>(&line.event.evidence);
        return e != nullptr && e->verdict == wanted;
    };
    CHECK(found(points, "stage=sphere").total ==
          count([](const LedgerLine& line) { return line.event.address.stage == Stage::Sphere; }));
    CHECK(found(points, "section=6.3 refused").total ==
          count([&](const LedgerLine& line) { return verdict(line, Verdict::Removed); }));
    CHECK(found(points, "verdict=inside-sphere").total ==
          count([&](const LedgerLine& line) { return verdict(line, Verdict::InsideSphere); }));
    CHECK(found(points, "kept margin<0.05").total == count([](const LedgerLine& line) {
              return outcomeOf(line.event) == Outcome::Taken && line.reading &&
                     std::abs(line.reading->margin) < 0.05;
          }));
    CHECK(found(points, "point=7").total ==
          count([](const LedgerLine& line) { return testedPoint(line.event) == 7; }));
    CHECK(found(points, "pivot=7 stage=sort value>90").total == count([](const LedgerLine& line) {
              return line.pivot == 7 && line.event.address.stage == Stage::Sort && line.reading &&
                     line.reading->value > 90.0;
          }));
    CHECK(found(points, "at=3..5").total == count([](const LedgerLine& line) {
              return line.event.address.pivot >= 3 && line.event.address.pivot <= 5;
          }));
    CHECK(found(points, "stage=sphere stage=hole").total == 0);
}

TEST_CASE("query: points on and off the ring, edges, rings that close, components, least angles") {
    const PointSet points = prepared(closedFamilies()[1].sample(1));
    EventLog log;
    const Run run = runAll(points, paper(), &log);
    CHECK(found(points, "component").total == 1);
    CHECK(found(points, "alert").total == run.state.alerts.size());
    CHECK(found(points, "closes").total == run.state.counters.closedRings +
                                               run.state.counters.freedRings +
                                               run.state.counters.failedSeeds);
    CHECK(found(points, "stage=split").total == run.state.counters.splits);
    for (const Index p : {Index{0}, Index{7}, Index{200}}) {
        // Once DONE, a point stays so; it was on a ring before.
        const std::string name = std::to_string(p);
        CHECK(found(points, ("done=" + name).c_str()).total == 1);
        CHECK(found(points, ("used=" + name).c_str()).total >= 1);
    }
    const Triangle& t = run.state.triangles[50];
    const std::string edge = "edge=" + std::to_string(t.c) + "," + std::to_string(t.b);
    CHECK(found(points, edge.c_str()).total >= 1);
    CHECK(found(points, "edge=0,0").total == 0);
    CHECK(found(points, "angle<60.1").total == run.state.triangles.size());
    CHECK(found(points, "angle<0.1").total == 0);
    CHECK(found(points, "among=7 stage=sphere").total >=
          found(points, "point=7 stage=sphere").total);
}

TEST_CASE("query: what is not understood is named") {
    for (const char* bad :
         {"dragons", "stage=dragon", "point=x", "margin<", "margin<a", "at=3..", "pivot=-1", "Kept",
          "used=", "edge=3", "angle<", "among=3,x", "verdict=dragon", "section=9.9",
          "ring=", "candidates=x", "tests=3..x"}) {
        CAPTURE(bad);
        const auto query = DecisionQuery::parse(std::string("stage=sort ") + bad);
        REQUIRE_FALSE(query.ok());
        CHECK(query.error().message.find(bad) != std::string::npos);
    }
}

TEST_CASE("query: a point that the set has not got is named, wherever a line names points") {
    for (const char* line :
         {"point=10", "stage=sphere pivot=10", "used=10", "done=10 kept", "stranded=10",
          "edge=3,10", "among=3..5,10", "among=8..10", "status=10"})
        CHECK(missingPointIn(line, 10) == "There is no point 10: the points are 0 to 9.");
    CHECK(missingPointIn("point=99999999999999999999999", 10) ==
          "There is no point 99999999999999999999999: the points are 0 to 9.");
    for (const char* line :
         {"", "  ", "stage=sphere", "point=9 edge=0,9 among=1..3,9", "used",
          "point=", "at=100..200", "ring=10..19", "margin<1e-20", "tests=12", "dragons"})
        CHECK(missingPointIn(line, 10).empty());
}

TEST_CASE("query: a mistake has its word, and whether such a term exists") {
    CHECK_FALSE(mistakeIn("").has_value());
    CHECK_FALSE(mistakeIn(" stage=sphere  kept margin<1e-4 point=812 ").has_value());
    const auto unknown = mistakeIn("kept dragons margin<x");
    REQUIRE(unknown.has_value());
    CHECK(unknown->word == "dragons");
    CHECK(unknown->isUnknown);
    CHECK(unknown->message == "\"dragons\" is not understood.");
    const auto wrong = mistakeIn("kept margin<x");
    REQUIRE(wrong.has_value());
    CHECK(wrong->word == "margin<x");
    CHECK_FALSE(wrong->isUnknown);
}

TEST_CASE("query: terms about the pivot as a whole hold for all of its decisions") {
    const PointSet points = prepared(closedFamilies()[1].sample(1));
    const FoundDecisions all = found(points, "stage=pivot");
    const auto count = [&](auto&& holds) {
        return static_cast<std::size_t>(std::count_if(all.lines.begin(), all.lines.end(), holds));
    };
    const auto ring = [](const LedgerLine& line) {
        return std::get<PivotEvidence>(line.event.evidence).ringLength;
    };
    CHECK(found(points, "stage=pivot ring=0..4294967295").total == all.total);
    CHECK(found(points, "stage=pivot ring=10..19").total ==
          count([&](const LedgerLine& line) { return ring(line) >= 10 && ring(line) <= 19; }));
    CHECK(found(points, "stage=pivot ring=4").total ==
          count([&](const LedgerLine& line) { return ring(line) == 4; }));
    // A pivot without tests has one event: that it is the pivot.
    const std::size_t some = found(points, "stage=sort kept candidates=3").total;
    CHECK(some == 3 * found(points, "stage=pivot candidates=3").total);
    CHECK(found(points, "stage=pivot tests=0..5").total +
              found(points, "stage=pivot tests=6..100000").total ==
          all.total);
}
