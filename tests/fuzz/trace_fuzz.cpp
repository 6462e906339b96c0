/// Feeds arbitrary bytes to the readers of traces and of moves: no crash, each fault has a message,
/// and what is complete has valid points, reads back, and can be compared with a run. As
/// readers_fuzz.cpp a plain program unless SPIRALING_EDGE_LIBFUZZER is defined.
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "teach/practice.h"
#include "teach/trace/trace_diff.h"

namespace {

/// The points of Figure 4 and their run.
struct FuzzedRun {
    se::SharedPoints points{se::prepare(se::findScene("figure-4")->build(), {}).value().points};
    se::Params params;
    FuzzedRun() { params.start = se::startOfScene("figure-4"); }
};

void compareWithRun(se::teach::Trace trace) {
    static const FuzzedRun run;
    if (!se::teach::requireTraceOf(trace, *run.points, "input")) return;
    for (const auto& row : se::teach::traceStages()) {
        const auto found = se::teach::compareTrace(trace, run.points, run.params, row.id);
        demand(found.ok() && !se::teach::differenceText(found.value()).empty(), "no text");
    }
}

void readAndGradeMoves(std::string_view bytes) {
    static const se::teach::PracticeTask task = se::teach::practiceTask(7);
    const auto moves = se::teach::readMoves(bytes, "input", task);
    demand(moves.ok() || !moves.error().message.empty(), "an error without a message");
    if (!moves.ok()) return;
    const se::teach::PracticeGrade grade = se::teach::gradePractice(task, moves.value());
    demand(grade.right || !grade.sentence.empty(), "a wrong move without a sentence");
    for (const se::teach::PlayMove& each : moves.value()) {
        const auto again = se::teach::moveFromText(se::teach::moveText(each));
        demand(again.ok() && again.value() == each, "another move");
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    readAndGradeMoves(bytes);
    for (const auto& row : se::teach::traceStages()) {
        const auto trace = se::teach::readTrace(bytes, "input", row.id);
        demand(trace.ok() || !trace.error().message.empty(), "an error without a message");
        if (!trace.ok()) continue;
        std::string text =
            "{\"setrace\":1,\"points\":" + std::to_string(trace.value().points) + "}\n";
        for (const se::teach::TracePivot& pivot : trace.value().pivots)
            text += se::teach::traceLine(pivot);
        demand(se::teach::readTrace(text, "written", row.id).ok(), "another trace");
        compareWithRun(trace.value());
    }
    return 0;
}
