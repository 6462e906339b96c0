// spiraling-edge diff: the trace of another implementation beside the run of this one.
#include "input.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/prepare/prepare.h"
#include "teach/trace/rule_guess.h"
#include "verbs.h"

namespace se::cli {
namespace {

using teach::Trace;
using teach::TraceComparison;
using teach::TraceDifference;
using teach::TracePivot;
using teach::TraceStage;

struct DiffArguments : AnswerOptions {
    std::string trace;
    InputArguments input;
    std::string stage;

    void addTo(CLI::App& app) {
        app.add_option("TRACE", trace, "Trace, .setrace, or -")->required();
        input.addTo(app);
        const std::string names = listText(teach::traceStages(), &teach::TraceStageRow::name, "");
        addOption(app, "--upto", "STAGE", stage, "Compare no stage after this one: " + names);
        addAnswerOptions(app, "As JSON", "Only the exit code: 1 if the runs differ");
    }

    /// Throws Failure(Usage) if there is no stage of that name.
    std::optional<TraceStage> upto() const {
        if (stage.empty()) return std::nullopt;
        if (const auto* row = findNamed(teach::traceStages(), stage)) return row->id;
        refuse("--upto {}: no such stage; see spiraling-edge diff --help", stage);
    }
};

Json reasonJson(const teach::TraceReason& reason) {
    Json json = Json::object();
    if (reason.point != kNone)
        json = {{"point", reason.point}, {"in", reason.inTrace ? "yours" : "ours"}};
    json["ours"] = reason.decision;
    if (!reason.address) return json;
    json["address"] = toString(*reason.address);
    json["section"] = stageSection(reason.address->stage);
    return json;
}

Json pivotJson(const std::optional<TracePivot>& pivot) {
    return pivot ? Json::parse(teach::traceLine(*pivot)) : Json();
}

Json diffJson(const TraceComparison& comparison, const teach::RuleGuess& guess) {
    Json json{{"same", !comparison.difference}, {"alike", comparison.alike}};
    if (comparison.difference) {
        const TraceDifference& found = *comparison.difference;
        json["pivot"] = found.pivot;
        json["line"] = found.trace ? Json(found.trace->line) : Json();
        json["what"] = found.what;
        json["stage"] = found.stage ? Json(teach::rowOf(*found.stage).name) : Json();
        json["yours"] = pivotJson(found.trace);
        json["ours"] = pivotJson(found.run);
        json["both"] = found.both;
        json["our_pivots"] = found.runPivots > 0 ? Json(found.runPivots) : Json();
        json["reasons"] = Json::array();
        for (const teach::TraceReason& each : found.reasons)
            json["reasons"].push_back(reasonJson(each));
        json["rules"] = Json::array();
        for (const RuleValue& each : guess.whole) json["rules"].push_back(lineOf(each));
    }
    return json;
}

/// The other value of `opposing`, if it gives the whole trace. It has a part in the lists only, so
/// the input is prepared again.
std::optional<RuleValue> guessOpposing(const Trace& trace, const InputArguments& input,
                                       const PreparedInput& prepared,
                                       std::optional<TraceStage> upto) {
    const bool drops = !prepared.params.dropOpposingNormals;
    PrepareOptions options = input.prepareOptions(prepared.file);
    options.neighbors.dropOpposingNormals = drops;
    Result<Prepared> other = prepare(prepared.file, options);
    if (!other || other.value().points.size() != trace.points) return std::nullopt;
    const SharedPoints points(std::move(other.value().points));
    if (!teach::matchTrace(trace, points, prepared.params, upto).whole) return std::nullopt;
    return RuleValue{"opposing", drops ? 1.0 : 0.0};
}

}  // namespace

ExitCode diffVerb(CLI::App& app, const Arguments& words) {
    DiffArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    const std::optional<TraceStage> upto = arguments.upto();
    const std::string& input = arguments.input.input();
    if (arguments.trace == kStandardInput && input == kStandardInput)
        refuse("-: standard input is TRACE already; name a file");
    const std::string path = isStandardInput(arguments.trace) ? "/dev/stdin" : arguments.trace;
    const Trace trace =
        require(teach::readTraceFile(path, upto.value_or(TraceStage::Emit)), ExitCode::Input);
    ProgressLine line(!arguments.quiet);
    PreparedInput prepared = arguments.input.prepare(line);
    require(teach::requireTraceOf(trace, prepared.points, arguments.trace), ExitCode::Input);
    const SharedPoints points(std::move(prepared.points));
    const TraceComparison found =
        runWithProgress("comparing", input, line, [&](const Progress& progress) {
            return teach::compareTrace(trace, points, prepared.params, upto, progress);
        });
    teach::RuleGuess guess;
    // A short trace is alike under every rule that does not matter to it.
    const bool endsEarly = found.difference && found.difference->runPivots > 0;
    if (found.difference && !endsEarly && !arguments.quiet) {
        guess = runWithProgress("trying rules", input, line, [&](const Progress& progress) {
            return teach::guessRules(trace, points, prepared.params, upto, progress);
        });
        const auto opposing = guessOpposing(trace, arguments.input, prepared, upto);
        if (opposing) guess.whole.push_back(*opposing);
    }
    std::string text = teach::differenceText(found);
    if (found.difference && !endsEarly) text += teach::guessText(guess, trace);
    if (!arguments.quiet) print({text, diffJson(found, guess)}, arguments.json);
    return found.difference ? ExitCode::CheckFailed : ExitCode::Good;
}

}  // namespace se::cli
