#include "teach/trace/trace_diff.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "traced_scenes.h"

namespace se::teach {
namespace {

Trace traceOf(const TracedScene& scene, std::string_view rule,
              TraceDetail detail = TraceDetail::Fans) {
    const Params params = rule.empty() ? scene.params : withRule(scene.params, rule);
    return readTrace(traceText(scene.points, params, detail), "x").value();
}

std::string textOfDifference(const TracedScene& scene, const Trace& trace,
                             std::optional<TraceStage> upto = {}) {
    return differenceText(compareTrace(trace, scene.points, scene.params, upto).value());
}

}  // namespace

TEST_CASE("the own trace has no difference") {
    const TracedScene scene = tracedScene("figure-12");
    const Trace trace = traceOf(scene, "", TraceDetail::Stages);
    CHECK(textOfDifference(scene, trace) == "all 122 pivots alike\n");
}

TEST_CASE("the first difference names each point of the fans with our decision") {
    const TracedScene scene = tracedScene("figure-8");
    CHECK(textOfDifference(scene, traceOf(scene, "limits=off")) ==
          "after 7 pivots alike, pivot 8 (point 11 between 1 and 3): the fans differ\n"
          "  yours has no 17: ours moved start to it, 8.limits.1 (6.1)\n"
          "  yours has no 8: ours kept it: inside sphere, 8.sphere.1 (6.3)\n"
          "  yours has no 15: ours moved end to it, 8.limits.3 (6.1)\n");
    Trace more = traceOf(scene, "");
    more.pivots[8].fan = {20, 9, 46, 31, 35, 39};
    CHECK(textOfDifference(scene, more) ==
          "after 8 pivots alike, pivot 9 (point 15 between 20 and 39): the fans differ\n"
          "  yours has 46: ours left it out: removed, 9.sphere.2 (6.3)\n");
    more.pivots[8].fan = {20, 31, 9, 35, 39};
    CHECK(textOfDifference(scene, more) ==
          "after 8 pivots alike, pivot 9 (point 15 between 20 and 39): the fans differ: the same "
          "points in another order\n");
    more.pivots[8].fan = {20, 9, 31, 49, 35, 39};
    CHECK(textOfDifference(scene, more).find("yours has 49: ours has it not in the list") !=
          std::string::npos);
}

TEST_CASE("another pivot is named with the decision that led to ours") {
    const TracedScene scene = tracedScene("torus");
    CHECK(textOfDifference(scene, traceOf(scene, "next=start")) ==
          "after 2 pivots alike, pivot 3 (yours: point 605 between 3 and 277; ours: point 559 "
          "between 534 and 578): the pivots differ\n"
          "  ours: The next pivot is 559, 2.advance.1 (6.5)\n");
}

TEST_CASE("another first or last is named with the point that left our ring, or entered it") {
    const TracedScene scene = tracedScene("figure-12");
    Trace trace = traceOf(scene, "");
    // At pivot 46 start moves over 158, which leaves the ring. A trace that keeps it there has it
    // before 51.
    trace.pivots[46].first = 158;
    CHECK(textOfDifference(scene, trace) ==
          "after 46 pivots alike, pivot 47 (yours: point 51 between 158 and 103; ours: point 51 "
          "between 48 and 103): the edge rings beside it differ\n"
          "  ours: Point 158 leaves the ring: now DONE, 46.ring.3 (6.5)\n");
    trace.pivots[46].first = 51;
    CHECK(textOfDifference(scene, trace).find("Point 48 ") != std::string::npos);
}

TEST_CASE("a trace that ends early differs, unless its last pivot says that it is meant to") {
    const TracedScene scene = tracedScene("figure-8");
    Trace trace = traceOf(scene, "");
    trace.pivots.resize(10);
    for (const std::optional<TraceStage> upto : {std::optional<TraceStage>{}, {TraceStage::Emit}}) {
        CHECK(textOfDifference(scene, trace, upto) ==
              "alike as far as yours goes, 10 pivots; ours goes on to 76 pivots\n"
              "  the last line of a trace that is meant to end early has \"ends\": true\n");
    }
    trace.pivots.back().ends = true;
    CHECK(textOfDifference(scene, trace) == "all 10 pivots alike\n");
    trace.pivots.back().fan = {trace.pivots[9].first, trace.pivots[9].last};
    CHECK(textOfDifference(scene, trace).find("the fans differ") != std::string::npos);
    trace.pivots.clear();
    CHECK(textOfDifference(scene, trace, TraceStage::Emit) ==
          "yours has no pivots, ours has 76: nothing is compared\n");
    Trace longer = traceOf(scene, "");
    longer.pivots.push_back(longer.pivots.back());
    CHECK(textOfDifference(scene, longer).find("our run has ended") != std::string::npos);
}

TEST_CASE("a trace that ends in a pivot is compared as far as it goes") {
    const TracedScene scene = tracedScene("figure-8");
    Trace trace = traceOf(scene, "", TraceDetail::Stages);
    trace.pivots.resize(6);
    TracePivot& last = trace.pivots.back();
    last.reciprocal = last.hole = last.sphere = last.fan = last.ring = std::nullopt;
    CHECK(textOfDifference(scene, trace, TraceStage::Ring)
              .starts_with("alike as far as yours goes, 5 pivots and pivot 6 up to limits; ours "));
    last.sort = std::vector<Index>{};
    CHECK(textOfDifference(scene, trace).find("the candidates after sort differ") !=
          std::string::npos);
}

TEST_CASE("stages are compared in their order, up to the last one asked for") {
    const TracedScene scene = tracedScene("figure-8");
    Trace trace = traceOf(scene, "sphere=off", TraceDetail::Stages);
    CHECK(textOfDifference(scene, trace, TraceStage::Hole).starts_with("after 1 pivot alike"));
    trace.pivots.resize(1);
    trace.pivots[0].ends = true;
    CHECK(textOfDifference(scene, trace, TraceStage::Hole) == "all 1 pivot alike\n");
    CHECK(textOfDifference(scene, trace, TraceStage::Sphere)
              .find("the candidates after sphere differ\n  yours has 3: ours left it out: removed, "
                    "1.sphere.") != std::string::npos);
}

TEST_CASE("a reason is a decision of the stage that differs, or of one before it") {
    const TracedScene scene = tracedScene("figure-8");
    Trace trace = traceOf(scene, "", TraceDetail::Stages);
    // 46 is a candidate until the circumsphere test removes it.
    trace.pivots[8].sort = {9, 31, 35};
    CHECK(textOfDifference(scene, trace, TraceStage::Sort)
              .find("the candidates after sort differ\n  yours has no 46: ours kept it, 9.sort.") !=
          std::string::npos);
}

TEST_CASE("reasons agree with the fan, whatever is missing in a trace or surplus") {
    const TracedScene scene = tracedScene("coarse-torus");
    const Trace trace = traceOf(scene, "");
    std::size_t passed = 0;
    for (std::size_t i = 0; i < trace.pivots.size(); ++i) {
        const std::vector<Index>& fan = *trace.pivots[i].fan;
        if (fan.size() < 3) continue;
        Trace other = trace;
        other.pivots[i].fan = std::vector<Index>{fan.front()};
        for (const Index x : scene.points->neighbors[trace.pivots[i].p]) {
            if (std::find(fan.begin(), fan.end(), x) == fan.end())
                other.pivots[i].fan->push_back(x);
        }
        other.pivots[i].fan->push_back(fan.back());
        const TraceComparison comparison =
            compareTrace(other, scene.points, scene.params, {}).value();
        std::size_t starts = 0;
        std::size_t ends = 0;
        for (const TraceReason& each : comparison.difference.value().reasons) {
            CAPTURE(each.decision);
            CHECK(each.inTrace == each.decision.starts_with("left it out: "));
            starts += each.decision == "moved start to it" ? 1 : 0;
            ends += each.decision == "moved end to it" ? 1 : 0;
        }
        passed += starts > 1 || ends > 1 ? 1 : 0;
    }
    CHECK(passed > 0);  // Pivots at which a limit moves twice.
}

TEST_CASE("moved limits are compared where a trace has them") {
    const TracedScene scene = tracedScene("figure-4");
    Trace trace = traceOf(scene, "", TraceDetail::Stages);
    trace.pivots[0].start = trace.pivots[0].first;
    const std::string text = textOfDifference(scene, trace, TraceStage::Limits);
    CHECK(text.find(
              "the candidates after limits differ\n  start: yours 1, ours 5\n  ours: Point 5 ") !=
          std::string::npos);
    CHECK(text.find(", 1.limits.1 (6.1)") != std::string::npos);
    trace.pivots[0].start = 8;
    CHECK(
        textOfDifference(scene, trace, TraceStage::Limits).find("start stays, 1.limits.2 (6.1)") !=
        std::string::npos);
}

TEST_CASE("another edge ring is named with the changes of ours") {
    const TracedScene scene = tracedScene("figure-12");
    Trace trace = traceOf(scene, "", TraceDetail::Stages);
    trace.pivots[34].ring->pop_back();
    const std::string text = textOfDifference(scene, trace);
    CHECK(text.find("after 34 pivots alike, pivot 35") == 0);
    CHECK(text.find("the edge rings differ\n  ring from place ") != std::string::npos);
    CHECK(text.find(" on: yours no more, ours ") != std::string::npos);
    CHECK(text.find("35.split.1 (6.5)") != std::string::npos);
}

TEST_CASE("given starts are where a comparison begins") {
    const TracedScene scene = tracedScene("figure-6");
    const std::string text = textOfDifference(scene, traceOf(scene, "reciprocal=off"));
    CHECK(
        text ==
        "after 0 pivots alike, pivot 1 (point 0 between 1 and 2): the fans differ: ours has none\n"
        "  yours has 5: ours left it out: not reciprocal, 1.reciprocal.1 (6.1)\n"
        "  ours: Only first and last are left, 191.4 deg apart: over 180, the ring is "
        "discarded, 1.twopoint.1 (6.4)\n");
}

}  // namespace se::teach
