// spiraling-edge run: triangulates points, and writes mesh, report and trace.
#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <string>

#include "exit_code.h"
#include "input.h"
#include "output/report.h"
#include "output/sentences.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/stop_watch.h"
#include "spiraling_edge/mesh/fault_fields.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/stepper/stepper.h"
#include "teach/trace/setrace.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// True if the extension is that of traces with a line per pivot.
bool isPivotTrace(const std::string& path) {
    return lowerExtension(path) == teach::kTraceExtension;
}

/// A trace that is written during the run, since it may be larger than memory: a line per pivot,
/// or else a sentence per event. The file gets its name only by commit(): a run that ends early
/// leaves none.
class TraceWriter {
  public:
    /// `-`: to standard output. Throws Failure(Internal) if the file cannot be created.
    TraceWriter(const std::string& path, teach::TraceDetail detail)
        : perPivot_(isPivotTrace(path)), detail_(detail) {
        if (path != "-") file_ = require(AtomicFile::create(path), ExitCode::Internal);
    }

    /// Writes what stands before the first pivot.
    void begin(const PointSet& points) {
        if (perPivot_) buffer_ += teach::traceHeader(points);
    }
    /// Runs `stepper` to the end of its next pivot, as Stepper::stepPivot(), and appends the lines
    /// of that pivot. Throws Failure(Internal).
    bool step(Stepper& stepper) {
        constexpr std::size_t kBlock = 1U << 16U;
        bool ran = false;
        if (perPivot_) {
            const teach::TraceStep step = teach::stepTraced(stepper, detail_);
            if (step.pivot) buffer_ += teach::traceLine(*step.pivot);
            ran = step.ran;
        } else {
            stepper.setLog(&log_);
            ran = stepper.stepPivot();
            for (const Event& event : log_.events())
                buffer_ += toString(event.address) + '\t' + describe(event) + '\n';
            log_.clear();
        }
        if (buffer_.size() >= kBlock) flush();
        return ran;
    }
    /// Ends and names the file. Throws Failure(Internal) if anything could not be written.
    void commit() {
        flush();
        if (file_) require(file_->commit(), ExitCode::Internal);
    }

  private:
    void flush() {
        if (file_)
            require(file_->write(buffer_), ExitCode::Internal);
        else
            writeOutput("-", buffer_);
        buffer_.clear();
    }

    bool perPivot_;
    teach::TraceDetail detail_;
    EventLog log_;
    std::optional<AtomicFile> file_;  ///< Empty: standard output.
    std::string buffer_;
};

constexpr long long kMaxPivots = 0xffffffffLL;

bool holdsNormalsAnyway(const MeshFormat& format) {
    return format.bytesWithNormals == format.bytes;
}
bool cannotHoldNormals(const MeshFormat& format) { return format.bytesWithNormals == nullptr; }

struct RunArguments {
    InputArguments input;
    std::string output;
    bool usedPoints = false;
    bool faultFields = false;
    bool lists = false;
    std::string report;
    std::string trace;
    bool stages = false;
    std::optional<std::uint32_t> maxPivots;
    bool best = false;
    bool check = false;
    bool quiet = false;
    ForceOption force;
    WriteOptions writing;

    void addTo(CLI::App& app) {
        input.addTo(app);
        auto* out = addOutputOption(app, "-o,--output", "OUT", output,
                                    "Write the mesh to this file, as " +
                                        listText(meshFormats(), &MeshFormat::name, "or") +
                                        " by its extension; - : PLY to standard output");
        app.add_flag(
            "--normals", writing.normals,
            "With -o FILE.off: write the normals too, as NOFF, which fewer programs read; " +
                listText(meshFormats(), &MeshFormat::name, "and", holdsNormalsAnyway) +
                " hold them anyway, " +
                listText(meshFormats(), &MeshFormat::name, "and", cannotHoldNormals) + " cannot");
        app.add_flag("--used-points", usedPoints,
                     "Write only the points that are in a triangle (default: all, in their "
                     "order)")
            ->needs(out);
        app.add_flag("--fault-fields", faultFields,
                     "With -o FILE.ply: write as scalar fields of each point its most severe "
                     "fault and its distance from the mesh")
            ->needs(out);
        app.add_flag("--with-lists", lists,
                     "With -o FILE.ply: write the neighbor lists too, also computed ones")
            ->needs(out);
        app.add_flag("--best", best,
                     "Run with other settings too (rules, neighbors, normals, rims, points that "
                     "the doctor would drop) and keep the best mesh: a sound one, or else the "
                     "one with the fewest points amiss (docs/robust.md); a point "
                     "that it drops is lost. Given normals that fit the points and agree stay as "
                     "they are; at most 20 runs")
            ->excludes(app.get_option("--what-if"));
        addOption(app, "--max-pivots", "N", maxPivots,
                  "Stop after N pivots and write what there is")
            ->check(CLI::Range(0LL, kMaxPivots))
            ->excludes(app.get_option("--best"));
        addOutputOption(app, "--report", "FILE", report,
                        "Write counts and times as JSON to this file, or -");
        addOutputOption(app, "--trace", "FILE", trace,
                        "Write one line per decision to this file, or -; to a file .setrace one "
                        "per pivot, for diff");
        app.add_flag("--trace-stages", stages,
                     "With --trace FILE.setrace: also candidates after each stage, and edge rings");
        app.add_flag(
            "--check", check,
            "Search for faults, crossing triangles included; exit with 1 if there are any");
        force.addTo(app);
        app.add_flag("-q,--quiet", quiet, "Print errors only");
    }

    /// True if all faults are searched for, and judged as `check` does.
    bool searchesPairs() const { return check || best || faultFields || !report.empty(); }
    /// Reports all mistakes that can be found before the work begins.
    void validate() const {
        requireNoTerminal(output);
        if (output != "-" && meshFormatOf(output) == nullptr)
            refuse("-o {}: only {} can be written", output,
                   listText(meshFormats(), &MeshFormat::extension, "and"));
        if (writing.normals) requireNormals();
        if (faultFields) requireColumns("--fault-fields", "numbers of points");
        if (lists) requireColumns("--with-lists", "neighbor lists");
        if (lists && usedPoints)
            refuse("--with-lists: the lists name all points; leave out --used-points");
        if (stages && !isPivotTrace(trace))
            refuse(
                "--trace-stages: {} has a line per decision already; name a file .setrace with "
                "--trace",
                trace);
        force.require(input.files(), {{"-o", output}, {"--report", report}, {"--trace", trace}});
    }

    /// Reports an option whose numbers of each point cannot be written.
    void requireColumns(std::string_view option, std::string_view what) const {
        if (output == "-" || keepsColumns(*meshFormatOf(output))) return;
        refuse("{} -o {}: this format cannot hold {}; choose {}", option, output, what,
               listText(meshFormats(), &MeshFormat::extension, "or", keepsColumns));
    }

    /// Reports `--normals` where no normals can be written.
    void requireNormals() const {
        if (output.empty()) refuse("--normals: name a file with -o FILE.off");
        if (output != "-" && cannotHoldNormals(*meshFormatOf(output)))
            refuse("--normals -o {}: this format cannot hold normals of points; {} can", output,
                   listText(meshFormats(), &MeshFormat::extension, "and",
                            &MeshFormat::bytesWithNormals));
    }
};

/// Called between pivots: updates the progress line, the share of the points that are DONE, now and
/// then. Requires points.
void reportProgress(const State& state, ProgressLine& line) {
    constexpr std::uint32_t kAskEvery = 64;
    if (state.counters.pivots % kAskEvery != 0 || !line.due()) return;
    const auto done = std::count(state.status.begin(), state.status.end(), kDone);
    line.write("points done", static_cast<double>(done) / static_cast<double>(state.status.size()));
}

/// The whole run without events, the fastest way.
Reconstruction triangulateAtOnce(const PointSet& points, const Params& params, ProgressLine& line) {
    Reconstruction made = reconstruct(points, params, [&](const State& state) {
        reportProgress(state, line);
        return false;
    });
    line.clear();
    return made;
}

/// The run with a limit or a trace; the lines of a pivot are written as soon as it is complete.
Reconstruction triangulate(const PointSet& points, const Params& params,
                           std::optional<std::uint32_t> maxPivots,
                           std::optional<TraceWriter>& trace, ProgressLine& line) {
    Stepper stepper(points, params);
    if (trace) trace->begin(points);
    bool limited = maxPivots == 0U;
    while (!limited && (trace ? trace->step(stepper) : stepper.stepPivot())) {
        limited = maxPivots && stepper.state().counters.pivots >= *maxPivots;
        reportProgress(stepper.state(), line);
    }
    line.clear();
    const StopReason end = stepper.state().capped() ? StopReason::Capped : StopReason::Finished;
    return {stepper.takeState(), limited ? StopReason::Condition : end};
}

/// Writes the mesh to the destination of -o, and records the path and the offset.
void writeResult(const RunArguments& arguments, RunOutcome& outcome) {
    const PointFile& file = outcome.read.file;
    outcome.output = arguments.output;
    if (arguments.output.empty()) return;
    PointFile used;
    if (arguments.usedPoints) used = withUsedPoints(file, outcome.state.mesh());
    const PointFile& points = arguments.usedPoints ? used : file;
    const auto& mesh = arguments.usedPoints ? used.faces : outcome.state.mesh();
    writeMeshOutput(arguments.output, points, mesh, arguments.writing);
    if (arguments.output != "-")
        outcome.shift = shiftOf(*meshFormatOf(arguments.output), points, mesh);
}

/// Searches faults and counts the mesh, as far as the arguments need it.
void inspect(const RunArguments& arguments, const PointSet& points, RunOutcome& outcome) {
    const std::vector<Triangle>& mesh = outcome.state.mesh();
    if (arguments.searchesPairs()) {
        outcome.judged = judgeMesh(points, mesh);
        outcome.judged.verdict.stopped = outcome.ending == StopReason::Capped;
    } else if (!arguments.quiet) {
        outcome.judged.inspection = inspectLocally(points, mesh);
    }
}

/// Reason why a finished run fails `--check` and `--best` whatever its faults are; empty if there
/// is none.
std::string emptinessSentence(const RunOutcome& outcome) {
    const std::size_t points = outcome.mesh().points;
    if (outcome.mesh().triangles == 0)
        return fmt::format("the run made no triangle of {}", counted(points, "point"));
    const std::size_t setAside = outcome.prepared.countAside();
    if (setAside <= outcome.mesh().usedPoints) return {};
    return fmt::format("more points were set aside ({}) than used ({})", setAside,
                       outcome.mesh().usedPoints);
}

/// Tries changes of a spec, with the line of progress. Throws Failure as runWithProgress() does.
Trials tryOthers(const PointFile& file, const RunSpec& spec, ProgressLine& line) {
    std::string what = "trying settings";
    const auto visit = [&](const Trials& trials, const SpecChange& next) {
        what = trialText(next) + ", run " + std::to_string(trials.tried.size() + 1);
    };
    return runWithProgress(what, spec.source, line, [&](const Progress& progress) {
        return tryChanges(file, spec, visit, progress);
    });
}

/// How a run is made: by the named settings, with --best by the best change of them.
struct ChosenRun {
    RunSpec spec;
    std::vector<Index> leaveOut;  ///< Points that are set aside besides.
};

ChosenRun chooseRun(const RunArguments& arguments, const RunSpec& named, ProgressLine& line,
                    RunOutcome& outcome) {
    ChosenRun chosen{named, {}};
    const GivenStart start = paramsFrom(named).start;
    if (arguments.best) requireNoStart(start, "--best");
    if (outcome.read.kept < outcome.read.inFile) requireNoStart(start, "--crop, --thin");
    if (arguments.best) {
        outcome.trials = tryOthers(outcome.read.file, named, line);
        const Trial& best = outcome.trials->tried[outcome.trials->best];
        chosen = {changed(named, best.change), best.leaveOut};
    }
    outcome.spec = chosen.spec;
    outcome.params = paramsFrom(chosen.spec);
    return chosen;
}

/// Prints the summary and determines the exit code.
ExitCode conclude(const RunArguments& arguments, const RunOutcome& outcome) {
    if (!arguments.report.empty()) writeOutput(arguments.report, reportJson(outcome));
    if (!arguments.quiet) printNote(summaryText(outcome) + shiftText(outcome));
    if (outcome.ending == StopReason::Capped) {
        throw Failure(ExitCode::CheckFailed,
                      "{}: stopped at {}, more than a surface can have; the mesh so far is not a "
                      "surface. See docs/robust.md",
                      outcome.input, counted(outcome.state.mesh().size(), "triangle"));
    }
    const std::string faults = faultSentence(outcome);
    const bool none = outcome.mesh().triangles == 0;
    const std::string emptiness = none || arguments.check ? emptinessSentence(outcome) : "";
    if (!emptiness.empty() && (arguments.check || arguments.best))
        throw Failure(ExitCode::CheckFailed, "{}: {}", outcome.input, emptiness);
    if (arguments.check && !faults.empty())
        throw Failure(ExitCode::CheckFailed, "{}: {}", outcome.input, faults);
    for (const std::string& sentence : {emptiness, faults}) {
        if (!sentence.empty() && !arguments.quiet)
            printNote(fmt::format("{}: {}\n", printable(outcome.input), sentence));
    }
    return ExitCode::Good;
}

}  // namespace

ExitCode runVerb(CLI::App& app, const Arguments& words) {
    RunArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    arguments.validate();
    RunOutcome outcome;
    outcome.input = arguments.input.input();
    // What is wrong with the options is reported before the input is read.
    const RunSpec& named = arguments.input.spec();

    ProgressLine line(!arguments.quiet);
    std::optional<TraceWriter> trace;
    if (!arguments.trace.empty())
        trace.emplace(arguments.trace,
                      arguments.stages ? teach::TraceDetail::Stages : teach::TraceDetail::Fans);
    StopWatch watch;
    outcome.read = readPiece(named);
    PointFile& file = outcome.read.file;
    outcome.seconds.read = watch.lap();
    if (file.position.empty())
        throw Failure(ExitCode::Input,
                      nameOfInput(named.source) + ": holds no points to triangulate");
    const ChosenRun chosen = chooseRun(arguments, named, line, outcome);
    outcome.seconds.trials = watch.lap();
    PrepareOptions options = prepareOptionsFrom(chosen.spec, outcome.params, file);
    options.leaveOut = chosen.leaveOut;
    Prepared prepared =
        runWithProgress("preparing", named.source, line,
                        [&](const Progress& progress) { return prepare(file, options, progress); });
    arguments.input.requirePossible(prepared.points, outcome.params);
    outcome.seconds.prepare = watch.lap();
    if (arguments.searchesPairs()) {
        prepared.points.judge =
            runWithProgress("preparing", named.source, line, [&](const Progress& progress) {
                return judgeOfRun(file, prepareOptionsFrom(named, outcome.params, file),
                                  outcome.params, prepared.points, progress);
            });
        outcome.judge = prepared.points.judge;
    }
    outcome.prepared = prepared.report;
    storeDerived(prepared.points, prepared.report, file);
    outcome.seconds.judge = watch.lap();
    Reconstruction made =
        trace || arguments.maxPivots
            ? triangulate(prepared.points, outcome.params, arguments.maxPivots, trace, line)
            : triangulateAtOnce(prepared.points, outcome.params, line);
    outcome.state = std::move(made.state);
    outcome.ending = made.reason;
    outcome.seconds.triangulate = watch.lap();
    // These take as much memory as the mesh, and nothing below reads them.
    if (arguments.lists) file.neighbors = std::move(prepared.points.neighbors);
    prepared.points.neighbors = {};
    outcome.state.edges = {};
    outcome.state.repair.near = {};
    inspect(arguments, prepared.points, outcome);
    if (arguments.faultFields)
        setFaultFields(file, prepared.points, outcome.state.mesh(),
                       outcome.judged.inspection.failures);
    watch.lap();
    writeResult(arguments, outcome);
    if (trace) trace->commit();
    outcome.seconds.write = watch.lap();
    return conclude(arguments, outcome);
}

}  // namespace se::cli
