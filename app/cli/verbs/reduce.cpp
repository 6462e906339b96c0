// spiraling-edge reduce: a minimal set of points that still fails, with a session and a test of
// it. The search is core's reduceInput(). Its effort is counted in elementary tests instead of
// seconds, so that the result does not depend on the machine.
#include "spiraling_edge/why/reduce.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "input.h"
#include "output/failures.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/spec/session_text.h"
#include "verbs.h"

namespace se::cli {
namespace {

constexpr std::uint64_t kTestsPerEffort = 1'000'000;
constexpr std::uint64_t kMaxEffort = 1'000'000'000;

struct ReduceArguments {
    InputArguments input;
    std::string failure;
    std::string output;
    std::uint64_t effort = kReduceEffort / kTestsPerEffort;
    bool quiet = false;
    ForceOption force;

    void addTo(CLI::App& app) {
        input.addTo(app);
        addOption(app, "--failure", "CLASS", failure,
                  "Class of the failure, see spiraling-edge check --help; CLASS:N for the Nth "
                  "of its class")
            ->required();
        addOutputOption(app, "-o,--output", "SMALL.ply", output,
                        "Write the points here, together with a session (.sesession) that opens "
                        "them, and a test (.sh) that fails while they do")
            ->required();
        addOption(app, "--effort", "N", effort,
                  "Stop after about N million tests of two points or two triangles, over all "
                  "runs, with the best result so far; the default takes a minute at most where "
                  "runs get tangled")
            ->capture_default_str()
            ->check(CLI::Range(std::uint64_t{1}, kMaxEffort));
        force.addTo(app);
        app.add_flag("-q,--quiet", quiet, "Print errors only");
    }
    /// The file beside that of -o with another extension.
    std::string beside(std::string_view extension) const {
        return std::filesystem::path(output).replace_extension(extension).string();
    }
};

/// Address at which the failure is created among the remaining points; the start if unknown.
std::string addressIn(const PointFile& file, const InputArguments& input, const Params& params,
                      const FailureChoice& wanted) {
    const auto prepared = prepare(file, input.prepareOptions(file));
    if (!prepared) return "0";
    const auto failures = failuresOfRun(prepared.value().points, params);
    if (!failures) return "0";
    for (const RunFailure& each : failures.value()) {
        if (each.failure.kind == wanted.kind) return toString(each.moments.created.event.address);
    }
    return "0";
}

/// The session of the reduced points, which are from the piece.
std::string sessionOf(const std::string& points, const InputArguments& input,
                      const FailureChoice& wanted, const std::string& address) {
    SessionStart session{std::filesystem::path(points).filename().string(), input.spec(), address,
                         std::string(wanted.kind->name) + ":1",
                         "Reduced from " + input.input() + "."};
    session.spec.piece = {};
    return sessionText(session);
}

/// Test script; file names and options are data in it: each is one quoted word.
std::string testText(const std::string& points, const ReduceArguments& arguments,
                     const FailureChoice& wanted) {
    const auto nameOf = [](const std::filesystem::path& path) {
        return shellPath(path.filename().string());
    };
    return fmt::format(
        "#!/bin/sh\n"
        "# Fails while these points, reduced from {0}, end in: {1}\n"
        "# Usage: [SPIRALING_EDGE=path/to/spiraling-edge] sh {2}\n"
        "here=${{0%/*}}\n"
        "[ \"$here\" != \"$0\" ] || here=.\n"
        "program=${{SPIRALING_EDGE:-spiraling-edge}}\n"
        "command -v \"$program\" >/dev/null || {{\n"
        "    echo \"$0: $program not found; set SPIRALING_EDGE=PATH\" >&2\n"
        "    exit 2\n"
        "}}\n"
        "mesh=$(mktemp --suffix=.ply) || exit 5\n"
        "trap 'rm -f \"$mesh\"' EXIT\n"
        "code=0\n"
        "\"$program\" run \"$here\"/{3}{4} -q -o \"$mesh\" || code=$?\n"
        "# 1: a run that had to be stopped; it has a mesh as well.\n"
        "[ \"$code\" -le 1 ] || exit \"$code\"\n"
        "if \"$program\" check \"$mesh\" --points \"$here\"/{3} --json | grep -q '\"{1}\": [1-9]'; "
        "then\n"
        "    echo \"still fails: {1}\"\n"
        "    exit 1\n"
        "fi\n",
        printable(arguments.input.input()), wanted.kind->name,
        nameOf(std::filesystem::path(points).replace_extension(".sh")), nameOf(points),
        optionsText(arguments.input.spec(),
                    {SpecGroup::Rules, SpecGroup::Lists, SpecGroup::Derived}));
}

/// Writes points, session and test, and prints the line that names them.
void writeReduced(const ReduceArguments& arguments, const FailureChoice& wanted,
                  const PreparedInput& run, const Reduced& reduced) {
    const std::string& output = arguments.output;
    const std::string session = arguments.beside(kSessionExtension);
    const std::string test = arguments.beside(".sh");
    writeMeshOutput(output, reduced.file, {});
    const std::string address = addressIn(reduced.file, arguments.input, run.params, wanted);
    writeOutput(session, sessionOf(output, arguments.input, wanted, address));
    writeOutput(test, testText(output, arguments, wanted));
    if (arguments.quiet) return;
    std::string text =
        fmt::format("{}: {} of {} still end in {}; session {}, test {}\n", printable(output),
                    counted(reduced.kept.size(), "point"), run.file.position.size(),
                    wanted.kind->name, printable(session), printable(test));
    if (!reduced.complete) {
        text += fmt::format("stopped early, after {} million tests: fewer points may be possible",
                            arguments.effort);
        if (arguments.effort < kMaxEffort)
            text += fmt::format("; use --effort {} to continue",
                                std::min(10 * arguments.effort, kMaxEffort));
        text += '\n';
    }
    printNote(text);
}

}  // namespace

ExitCode reduceVerb(CLI::App& app, const Arguments& words) {
    ReduceArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    const FailureChoice wanted = failureChoiceFrom(arguments.failure);
    if (wanted.kind->find == nullptr) {
        refuse("--failure {}: only failures of the mesh can be reduced; try holes",
               arguments.failure);
    }
    if (!arguments.output.ends_with(".ply"))
        refuse("-o {}: only .ply is written", arguments.output);
    arguments.force.require(arguments.input.files(),
                            {{"-o", arguments.output},
                             {"-o (session)", arguments.beside(kSessionExtension)},
                             {"-o (test)", arguments.beside(".sh")}});
    ProgressLine line(!arguments.quiet);
    const PreparedInput run = arguments.input.prepare(line);
    if (!run.params.whatIf.empty())
        refuse("--what-if names points by numbers, which reduce changes");
    requireNoStart(run.params.start, "reduce");
    const State whole = reconstruct(run.points, run.params).state;
    const auto kindOf = [](const MeshFailure& each) { return each.kind; };
    const MeshInspection found = inspectWithTotals(run.points, whole.mesh());
    const MeshFailure& failure =
        pickFailure(found.failures, kindOf, found.totals, wanted, arguments.input.input());
    const ReduceTest fails =
        failsAlike(arguments.input.spec(), run.params, run.points, failure, whole.mesh());
    const Reduced reduced =
        runWithProgress("reducing", arguments.input.input(), line, [&](const Progress& progress) {
            return reduceInput(run.file, failure.place, fails, kTestsPerEffort * arguments.effort,
                               progress);
        });
    writeReduced(arguments, wanted, run, reduced);
    return ExitCode::Good;
}

}  // namespace se::cli
