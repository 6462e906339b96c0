// spiraling-edge reduce: the fewest points that still fail, with a session and a test of them.
#include "spiraling_edge/reduce.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "failure_choice.h"
#include "interrupt.h"
#include "mesh_text.h"
#include "output.h"
#include "prepared_input.h"
#include "progress_work.h"
#include "rule_json.h"
#include "verbs.h"

namespace se::cli {
namespace {

struct ReduceArguments {
    InputArguments input;
    std::string failure;
    std::string output;
    bool quiet = false;

    void addTo(CLI::App& app) {
        input.addTo(app);
        app.add_option(
               "--failure", failure,
               "Class of the failure, see spiraling-edge check --help; CLASS:N for the N-th "
               "of its class")
            ->type_name("CLASS")
            ->required();
        addOutputOption(app, "-o,--output", output,
                        "Write the points here; beside them a session (.sesession) that opens on "
                        "them, and a test (.sh) that fails as long as they do")
            ->type_name("SMALL.ply")
            ->required();
        app.add_flag("-q,--quiet", quiet, "Only say what went wrong");
    }
};

/// The places of a failure's points, in order: what a hole is known again by.
std::vector<Vec3> placesOf(const PointSet& points, const MeshFailure& failure) {
    std::vector<Vec3> places;
    places.reserve(failure.points.size());
    for (const Index p : failure.points) places.push_back(points.position[p]);
    std::sort(places.begin(), places.end(), [](const Vec3& a, const Vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return places;
}

/// The way a user would have to type the options again.
std::string optionText(const InputArguments& input) {
    std::string text;
    for (const std::string& word : input.options()) text += " " + word;
    return text;
}

/// "auto", or the six numbers of "X0,Y0,Z0,X1,Y1,Z1".
nlohmann::ordered_json boxJson(const std::string& text) {
    if (text == "auto") return text;
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) numbers.push_back(std::stod(word));
    return numbers;
}

/// How the points are prepared, by the names that sessions have for it.
void addPreparing(nlohmann::ordered_json& options, const InputArguments& input) {
    for (const GivenOption& each : input.given()) {
        const std::string& value = each.words.back();
        if (each.name == "neighbors") options["neighbors"] = std::stoul(value);
        if (each.name == "radius" || each.name == "reach") options[each.name] = std::stod(value);
        if (each.name == "symmetric") options["symmetric"] = true;
        if (each.name == "keep-opposing") options["keep_opposing"] = true;
        if (each.name == "keep-noise") options["keep_noise"] = true;
        if (each.name == "orient") options["normals"] = "oriented";
        if (each.name == "derive-normals") options["normals"] = "derived";
        if (each.name == "derive-rim") options["rim"] = true;
        if (each.name == "box") options["box"] = boxJson(value);
    }
}

/// Where the failure comes about among the points that are left; the start if there is no saying.
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

std::string sessionText(const std::string& points, const PreparedInput& run,
                        const InputArguments& input, const FailureChoice& wanted,
                        const std::string& address) {
    nlohmann::ordered_json json;
    json["format"] = "spiraling-edge session";
    json["version"] = 1;
    json["input"]["source"] = std::filesystem::path(points).filename().string();
    json["options"]["rules"] = input.ruleSet();
    const Params plain = paramsByName(input.ruleSet()).value_or(Params{});
    for (const RuleValue& each : differingRules(run.params, plain)) {
        json["options"]["switches"][each.name] = ruleJson(*findRuleSetting(each.name), each.value);
    }
    addPreparing(json["options"], input);
    json["address"] = address;
    json["alert"] = std::string(wanted.kind->name) + ":1";
    json["notes"] = "Reduced from " + input.input() + ".";
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string testText(const std::string& points, const ReduceArguments& arguments,
                     const FailureChoice& wanted) {
    return fmt::format(
        "#!/bin/sh\n"
        "# Fails as long as these points, reduced from {0}, end in: {1}\n"
        "# Usage: [SPIRALING_EDGE=path/to/spiraling-edge] sh {2}\n"
        "here=$(dirname \"$0\")\n"
        "program=${{SPIRALING_EDGE:-spiraling-edge}}\n"
        "command -v \"$program\" >/dev/null || {{\n"
        "    echo \"$0: there is no $program; say where it is by SPIRALING_EDGE=PATH\" >&2\n"
        "    exit 2\n"
        "}}\n"
        "mesh=$(mktemp --suffix=.ply) || exit 5\n"
        "trap 'rm -f \"$mesh\"' EXIT\n"
        "\"$program\" run \"$here/{3}\"{4} -q -o \"$mesh\" || exit $?\n"
        "if \"$program\" check \"$mesh\" --points \"$here/{3}\" --json | grep -q '\"{1}\": [1-9]'; "
        "then\n"
        "    echo \"still fails: {1}\"\n"
        "    exit 1\n"
        "fi\n",
        arguments.input.input(), wanted.kind->name,
        std::filesystem::path(points).replace_extension(".sh").filename().string(),
        std::filesystem::path(points).filename().string(), optionText(arguments.input));
}

/// Points, session and test, and the line that names them.
void writeReduced(const ReduceArguments& arguments, const FailureChoice& wanted,
                  const PreparedInput& run, const Reduced& reduced) {
    const std::string& output = arguments.output;
    const auto beside = [&](const char* extension) {
        return std::filesystem::path(output).replace_extension(extension).string();
    };
    const Status status = writeMeshPly(output, reduced.file, {});
    if (!status) throw Failure(ExitCode::Internal, status.error().message);
    const std::string address = addressIn(reduced.file, arguments.input, run.params, wanted);
    writeOutput(beside(".sesession"), sessionText(output, run, arguments.input, wanted, address));
    writeOutput(beside(".sh"), testText(output, arguments, wanted));
    if (arguments.quiet) return;
    fmt::print(stderr, "{}: {} of {} still end in {}; session {}, test {}\n", output,
               counted(reduced.kept.size(), "point"), run.file.position.size(), wanted.kind->name,
               beside(".sesession"), beside(".sh"));
}

}  // namespace

ExitCode reduceVerb(const Arguments& words) {
    ReduceArguments arguments;
    CLI::App app("Shrinks an input to the fewest points that still fail in the same class.",
                 "spiraling-edge reduce");
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    const FailureChoice wanted = failureChoiceFrom(arguments.failure);
    if (wanted.kind->find == nullptr) {
        throw Failure(ExitCode::Usage,
                      fmt::format("--failure {}: only what is in the mesh can be shrunk to; try "
                                  "holes",
                                  arguments.failure));
    }
    if (!arguments.output.ends_with(".ply"))
        throw Failure(ExitCode::Usage,
                      fmt::format("-o {}: only .ply is written", arguments.output));
    requireWritable({{"-o", arguments.output}});
    catchInterrupts();
    ProgressLine line(!arguments.quiet);
    const PreparedInput run = arguments.input.prepare(line);
    if (!run.params.whatIf.empty())
        throw Failure(ExitCode::Usage, "--what-if names points by numbers that reduce changes");
    const MeshFailure failure = pickFailure(inspectMesh(run.points, meshOf(run.points, run.params)),
                                            wanted, arguments.input.input());
    const std::vector<Vec3> places = placesOf(run.points, failure);
    const bool isHole = wanted.kind == findFailureClass("holes");
    // What is cut off leaves a border: a hole must be the very same one.
    const auto fails = [&](const PointFile& file) {
        const auto prepared = prepare(file, arguments.input.prepareOptions(file));
        if (!prepared) return false;
        const PointSet& points = prepared.value().points;
        const std::vector<MeshFailure> all = inspectMesh(points, meshOf(points, run.params));
        return std::any_of(all.begin(), all.end(), [&](const MeshFailure& each) {
            return each.kind == wanted.kind && (!isHole || placesOf(points, each) == places);
        });
    };
    const Reduced reduced =
        workedOut("reducing", arguments.input.input(), line, [&](const Progress& progress) {
            return reduceInput(run.file, failure.place, fails, progress);
        });
    writeReduced(arguments, wanted, run, reduced);
    return ExitCode::Good;
}

}  // namespace se::cli
