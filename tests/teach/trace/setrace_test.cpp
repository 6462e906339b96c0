#include "teach/trace/setrace.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "traced_scenes.h"

namespace se::teach {
namespace {

const std::string kHeader = "{\"setrace\":1,\"points\":6}\n";

/// The message for a trace of six points with these lines after its header.
std::string traceFault(const std::string& lines, TraceStage upto = TraceStage::Emit) {
    const Result<Trace> trace = readTrace(kHeader + lines, "x.setrace", upto);
    return trace ? std::string("none") : trace.error().message;
}

}  // namespace

TEST_CASE("a trace has a line per pivot, also for those that are passed over") {
    const TracedScene scene = tracedScene("figure-13");
    const std::string text = traceText(scene.points, scene.params);
    const Trace trace = readTrace(text, "x").value();
    REQUIRE(trace.pivots.size() == 9);
    CHECK(trace.points == 8);
    CHECK(trace.hash == pointsHash(*scene.points));
    CHECK(trace.pivots[0].p == 0);
    CHECK(trace.pivots[0].fan == std::vector<Index>{});
    CHECK(trace.pivots[1].p == 2);
    CHECK(trace.pivots[1].fan->size() == 4);
    CHECK(trace.pivots[1].fan->front() == trace.pivots[1].first);
    CHECK(trace.pivots[1].line == 3);
}

TEST_CASE("a trace with stages reads back and is written the same") {
    const TracedScene scene = tracedScene("figure-8");
    const std::string text = traceText(scene.points, scene.params, TraceDetail::Stages);
    const Trace trace = readTrace(text, "x", TraceStage::Ring).value();
    const TracePivot& pivot = trace.pivots[8];
    CHECK(pivot.p == 15);
    CHECK(pivot.limits == std::vector<Index>{9, 46, 31, 35});
    CHECK(pivot.sphere == std::vector<Index>{9, 31, 35});
    CHECK(pivot.fan == std::vector<Index>{20, 9, 31, 35, 39});
    CHECK(pivot.ring->front() == pivot.next);
    // `stack`, `open` and `done` are not read.
    Trace again = readTrace(traceHeader(*scene.points) + traceLine(pivot), "x").value();
    CHECK(traceLine(again.pivots[0]) == traceLine(pivot));
}

TEST_CASE("the candidates after the limits are those that the convexity test leaves") {
    const TracedScene scene = tracedScene("figure-5");
    Stepper stepper(scene.points, scene.params);
    const TracePivot pivot = stepTraced(stepper, TraceDetail::Stages).pivot.value();
    CHECK(pivot.sort == std::vector<Index>{2, 3});
    CHECK(pivot.limits == std::vector<Index>{3});
}

TEST_CASE("a malformed trace is refused with line and field") {
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,3,2]}\n") == "none");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,6,2]}\n") ==
          "x.setrace: line 2: fan[1]: expected the number of a point, from 0 to 5, got 6");
    CHECK(
        traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[3,2]}\n") ==
        "x.setrace: line 2: fan: expected points from first, 1, to last, 2, at pivot 1 (point 0), "
        "got [3,2]");
    CHECK(traceFault("\n{\"p\":-1,\"first\":1,\"last\":2,\"fan\":[]}\n") ==
          "x.setrace: line 3: p: expected the number of a point, from 0 to 5, got -1");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"fan\":[]}\n") ==
          "x.setrace: line 2: last: expected the number of a point, from 0 to 5, it is missing");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,0,2]}\n") ==
          "x.setrace: line 2: fan: expected no p, which every triangle has anyway, at "
          "pivot 1 (point 0), got [1,0,2]");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,3") ==
          "x.setrace: line 2: expected one JSON object, got "
          "\"{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,3\"; the last line may be cut off");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,2],\"x\":\"\xff\"}\n") ==
          "x.setrace: line 2: not UTF-8; a trace is a text file");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2}\n{\"p\":0,\"first\":1,\"last\":2}\n") ==
          "x.setrace: line 2: fan: expected a list of points, it is missing");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[],\"ends\":1}\n") ==
          "x.setrace: line 2: ends: expected true or false, got 1");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":7}\n") ==
          "x.setrace: line 2: fan: expected a list of points, got 7");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":1,\"fan\":[1]}\n") ==
          "x.setrace: line 2: fan: expected two points or more, or [] for none, at pivot 1 "
          "(point 0), got [1]");
}

TEST_CASE("a malformed header of a trace is refused") {
    const auto fault = [](const std::string& text) {
        return readTrace(text, "x.setrace").error().message;
    };
    CHECK(fault("") == "x.setrace: the file is empty");
    CHECK(fault("{\"points\":6}\n").starts_with("x.setrace: line 1: expected the header"));
    CHECK(fault("{\"setrace\":2,\"points\":6}\n") ==
          "x.setrace: line 1: setrace: expected version 1, got 2");
    CHECK(fault("{\"setrace\":1,\"points\":0}\n") ==
          "x.setrace: line 1: points: expected the number of points of the input, got 0");
    CHECK(fault("{\"setrace\":1,\"points\":6,\"hash\":7}\n") ==
          "x.setrace: line 1: hash: expected a text, got 7");
    CHECK(fault("[1]\n").starts_with("x.setrace: line 1: expected one JSON object"));
}

TEST_CASE("only the last stage that is compared has to be in a line") {
    const std::string sorted = "{\"p\":0,\"first\":1,\"last\":2,\"sort\":[3]}\n";
    CHECK(traceFault(sorted, TraceStage::Sort) == "none");
    CHECK(traceFault(sorted + sorted, TraceStage::Sphere) ==
          "x.setrace: line 2: sphere: expected a list of points, it is missing");
    // Passed over, a pivot has no stages.
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[]}\n", TraceStage::Sphere) ==
          "none");
}

TEST_CASE("the last pivot of a trace may lack stages, where its program stopped") {
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2}\n") == "none");
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,2]}\n", TraceStage::Ring) ==
          "none");
}

TEST_CASE("only the last pivot of a trace can say that it ends there") {
    const std::string meant = "{\"p\":0,\"first\":1,\"last\":2,\"fan\":[1,2],\"ends\":true}\n";
    const Trace trace = readTrace(kHeader + meant, "x").value();
    CHECK(trace.pivots[0].ends);
    CHECK(traceLine(trace.pivots[0]) == meant);
    CHECK(traceFault(meant + meant) ==
          "x.setrace: line 2: ends: expected in the last line only, another pivot follows");
}

TEST_CASE("unknown fields of a trace are passed over") {
    CHECK(traceFault("{\"p\":0,\"first\":1,\"last\":2,\"fan\":[],\"tests\":[1],\"mine\":{}}\n") ==
          "none");
}

TEST_CASE("a trace is of the points whose number and hash it has") {
    const TracedScene scene = tracedScene("figure-8");
    Trace trace = readTrace(traceText(scene.points, scene.params), "x").value();
    CHECK(requireTraceOf(trace, *scene.points, "x").ok());
    PointSet moved = *scene.points;
    moved.position[7].y += 1e-9;
    CHECK(requireTraceOf(trace, moved, "x")
              .error()
              .message.starts_with("x: line 1: hash: the input has fnv1a64:"));
    trace.hash.clear();
    CHECK(requireTraceOf(trace, moved, "x").ok());
    trace.points = 49;
    CHECK(requireTraceOf(trace, moved, "x").error().message ==
          "x: line 1: points: the input has 50 points, the trace is of 49");
}

TEST_CASE("a huge trace is refused before it is read") {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / "se_huge_trace_test.setrace";
    { std::ofstream file(path); }
    std::filesystem::resize_file(path, kMaxTraceBytes + 1);  // Sparse: it takes no room.
    const Result<Trace> trace = readTraceFile(path.string());
    std::filesystem::remove(path);
    REQUIRE_FALSE(trace.ok());
    CHECK(trace.error().message.find(": holds more than 268435456 bytes") != std::string::npos);
}

}  // namespace se::teach
