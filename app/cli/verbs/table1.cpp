// spiraling-edge table1: the paper's Table 1 beside the results of this program on the same sets.
// Volumes that are not at hand are replaced by shapes with the same number of points. A time is
// the shortest of the runs within a second, since other work of the machine can only lengthen it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "input.h"
#include "output/sentences.h"
#include "spiraling_edge/base/stop_watch.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/sampling/volume.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// A row of the paper's Table 1: the figure with its surface and its counts, and what is not there.
struct Row {
    std::string_view set;
    int number;                     ///< Of the figure.
    double seconds;                 ///< On an SGI Indigo2 of 1996.
    std::string_view standIn = {};  ///< Shape in place of a missing volume.

    const Figure& figure() const { return *findFigure(number); }
};

constexpr std::array kRows{
    Row{"Lobster", 22, 2.30, "gyroid"}, Row{"Electron Cloud", 25, 0.15, "metaballs"},
    Row{"Blast Wave", 24, 0.07},        Row{"Hydrogen", 21, 0.08},
    Row{"Hyperboloid", 23, 0.01},
};

std::string slug(std::string_view set) {
    std::string name;
    for (const char c : set) name += c == ' ' ? '_' : static_cast<char>(std::tolower(c));
    return name;
}

struct TableArguments : AnswerOptions {
    std::string volumes;
    std::string save;
    SamplerOptions sampler;
    ByteLimit limit;
    ForceOption force;
    SpecOptions run;  ///< Rules and lists.
    /// The run of each set of points; lists as of particles that repel each other.
    RunSpec spec;

    void addTo(CLI::App& app) {
        addOption(app, "--volumes", "DIR", volumes,
                  "Folder with lobster.nhdr and electron_cloud.nhdr (docs/performance.md names the "
                  "sources); without it shapes are used instead");
        run.addTo(app, {SpecGroup::Rules});
        for (const char* key : {"neighbors", "reach"}) run.addTo(app, *findSpecField(key));
        app.footer(rulesHelp());
        addOption(app, "--seed", "S", sampler.seed, "Seed of the particles")
            ->capture_default_str()
            ->check(wholeNumber(0));
        addOption(app, "--curvature", "X", sampler.curvature, "As in `spiraling-edge sample`")
            ->check(CLI::Range(0.0, 100.0));
        addOption(app, "--save", "DIR", save,
                  "Write the five sets of points into this folder, as PLY");
        force.addTo(app);
        addByteLimit(app, limit);
        addAnswerOptions(app, "As JSON", "Show no progress");
    }

    std::filesystem::path savedPath(const Row& row) const {
        return std::filesystem::path(save) / (slug(row.set) + ".ply");
    }

    /// Makes the spec, and reports all mistakes that can be found before the work begins.
    void validate() {
        spec.neighbors.reach = WithinSpacings{};
        spec = specOf(run.given(), std::move(spec));
        for (const auto& [option, folder] :
             {std::pair{"--volumes", &volumes}, std::pair{"--save", &save}}) {
            std::error_code ignored;
            if (!folder->empty() && !std::filesystem::is_directory(*folder, ignored))
                refuse("{} {}: no such folder", option, *folder);
        }
        NamedFiles inputs;
        NamedFiles outputs;
        for (const Row& row : kRows) {
            const std::string surface = surfaceOf(row.figure(), volumes);
            if (isVolumePath(surface)) {
                inputs.push_back({"--volumes", surface});
                inputs.push_back({"the data file", dataFileOf(surface)});
            }
            if (!save.empty()) outputs.push_back({"--save", savedPath(row)});
        }
        force.require(std::move(inputs), std::move(outputs));
    }
};

/// Result for a row.
struct Made {
    std::string source;
    bool standIn = false;
    std::size_t wallPoints = 0;
    MeshReport mesh;
    std::uint64_t joins = 0;
    bool capped = false;
    double seconds = 0.0;

    /// Triangles of a surface like this one that uses every point: 2 V - 2 chi - boundary.
    long long ideal() const {
        return 2 * static_cast<long long>(mesh.points) - 2 * mesh.eulerCharacteristic -
               static_cast<long long>(mesh.boundaryEdges);
    }
    long long missing() const { return ideal() - static_cast<long long>(mesh.triangles); }
    double trianglesPerPoint() const {
        return static_cast<double>(mesh.triangles) / static_cast<double>(mesh.points);
    }
};

/// The shortest of the runs within a second: the others were slowed by other work of the machine.
Reconstruction timedRun(const PointSet& points, const Params& params, double& seconds) {
    constexpr int kLeastRuns = 3;
    constexpr double kEnough = 1.0;
    Reconstruction last;
    double total = 0.0;
    for (int i = 0; i < kLeastRuns || total < kEnough; ++i) {
        StopWatch watch;
        last = reconstruct(points, params);
        const double passed = watch.lap();
        total += passed;
        seconds = i == 0 ? passed : std::min(seconds, passed);
    }
    return last;
}

Made make(const Row& row, const TableArguments& arguments, const Params& params,
          ProgressLine& line) {
    Made made;
    made.source = surfaceOf(row.figure(), arguments.volumes);
    made.standIn = made.source.empty();
    if (made.standIn) made.source = row.standIn;
    SamplerOptions options = arguments.sampler;
    options.count = row.figure().counts.points;
    const PointFile file = samplePoints(readSurface(made.source, std::nullopt, arguments.limit),
                                        options, made.source, line);
    if (!arguments.save.empty()) writeMeshOutput(arguments.savedPath(row).string(), file, {});
    made.wallPoints = countOfType(file, isBoundary);
    const PrepareOptions preparing = prepareOptionsFrom(arguments.spec, params, file);
    const PointSet points = require(prepare(file, preparing), ExitCode::Internal).points;
    const Reconstruction run = timedRun(points, params, made.seconds);
    made.mesh = reportMesh(points, run.state.mesh());
    made.joins = run.state.counters.joins;
    made.capped = run.reason == StopReason::Capped;
    return made;
}

/// Adds the results of a row beside those of the paper.
void addRow(const Row& row, const Made& made, Answer& answer) {
    const auto [points, triangles] = row.figure().counts;
    const double perPoint = static_cast<double>(triangles) / static_cast<double>(points);
    answer.text += fmt::format(
        "{:<16} {:>6}  {:>8} {:>8}  {:>7.3f} {:>7.3f}  {:>6.2f} {:>8.5f} "
        "{:>6.0f}  {:>6} {:>5} {:>6} {:>5} {:>8} {:>5}{}\n",
        fmt::format("{}{}", row.set, made.standIn ? " *" : ""), made.mesh.points, triangles,
        made.mesh.triangles, perPoint, made.trianglesPerPoint(), row.seconds, made.seconds,
        row.seconds / made.seconds, made.mesh.unusedPoints, made.missing(), made.mesh.boundaryEdges,
        made.mesh.boundaryLoops, made.mesh.nonManifoldEdges, made.joins,
        made.capped ? "  stopped" : "");
    answer.json["sets"].push_back({{"set", row.set},
                                   {"source", made.source},
                                   {"stand_in", made.standIn},
                                   {"points", made.mesh.points},
                                   {"wall_points", made.wallPoints},
                                   {"triangles", made.mesh.triangles},
                                   {"ideal_triangles", made.ideal()},
                                   {"seconds", made.seconds},
                                   {"points_in_no_triangle", made.mesh.unusedPoints},
                                   {"boundary_edges", made.mesh.boundaryEdges},
                                   {"boundary_loops", made.mesh.boundaryLoops},
                                   {"non_manifold_edges", made.mesh.nonManifoldEdges},
                                   {"euler_characteristic", made.mesh.eulerCharacteristic},
                                   {"joins", made.joins},
                                   {"capped", made.capped},
                                   {"paper_points", points},
                                   {"paper_triangles", triangles},
                                   {"paper_seconds", row.seconds}});
}

Answer tableAnswer(const std::vector<Made>& all, const TableArguments& arguments) {
    const RunSpec& spec = arguments.spec;
    const auto* nearest = std::get_if<KNearest>(&spec.neighbors.reach);
    const auto* within = std::get_if<WithinSpacings>(&spec.neighbors.reach);
    const std::string reach = nearest != nullptr
                                  ? counted(nearest->k, "nearest neighbor")
                                  : fmt::format("neighbors within {:g} spacings", within->spacings);
    Answer answer{
        fmt::format("Table 1, rules {}, {}, seed {}, curvature {}; seconds: triangulation "
                    "alone, the best of the runs within a second\n\n",
                    spec.rules, reach, arguments.sampler.seed, arguments.sampler.curvature),
        {{"rules", spec.rules},
         {"neighbors", nearest != nullptr ? Json(nearest->k) : Json()},
         {"reach", within != nullptr ? Json(within->spacings) : Json()},
         {"seed", arguments.sampler.seed},
         {"curvature", arguments.sampler.curvature},
         {"sets", Json::array()}}};
    answer.text += fmt::format(
        "{:<16} {:>6}  {:>17}  {:>15}  {:>15} {:>6}  {:>6} {:>5} {:>6} {:>5} {:>8} "
        "{:>5}\n",
        "", "", "triangles", "per point", "seconds", "", "", "", "", "", "non-", "");
    answer.text += fmt::format(
        "{:<16} {:>6}  {:>8} {:>8}  {:>7} {:>7}  {:>6} {:>8} {:>6}  {:>6} {:>5} "
        "{:>6} {:>5} {:>8} {:>5}\n",
        "set", "points", "paper", "here", "paper", "here", "paper", "here", "times", "unused",
        "short", "rim", "loops", "manifold", "joins");
    for (std::size_t i = 0; i < all.size(); ++i) addRow(kRows[i], all[i], answer);
    answer.text +=
        "\nshort: triangles missing to 2 V - 2 chi - rim, the number of a surface "
        "that uses every point; rim: edges of one triangle\n";
    if (std::any_of(all.begin(), all.end(), [](const Made& m) { return m.standIn; }))
        answer.text += "* a shape of this program instead of the volume; give --volumes DIR\n";
    return answer;
}

}  // namespace

ExitCode table1Verb(CLI::App& app, const Arguments& words) {
    TableArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    arguments.validate();
    const Params params = paramsFrom(arguments.spec);
    ProgressLine line(!arguments.quiet);
    std::vector<Made> all;
    all.reserve(kRows.size());
    for (const Row& row : kRows) all.push_back(make(row, arguments, params, line));
    print(tableAnswer(all, arguments), arguments.json);
    return ExitCode::Good;
}

}  // namespace se::cli
