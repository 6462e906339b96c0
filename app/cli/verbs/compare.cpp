// spiraling-edge compare: two runs on the same points, or a run and the mesh of another program.
#include <fmt/format.h>

#include "compare_words.h"
#include "failure_choice.h"
#include "input.h"
#include "output/compare_text.h"
#include "output/output.h"
#include "progress.h"
#include "spiraling_edge/io/write_mesh.h"
#include "verbs.h"

namespace se::cli {
namespace {

struct CompareArguments {
    InputArguments input;
    std::string mesh;
    std::size_t limit = 10;
    bool json = false;
    bool quiet = false;

    void addTo(CLI::App& app) {
        input.addTo(app);
        // Removed before the words are parsed; declared here for the help.
        app.add_flag_callback(
            "--with", [] {},
            "The other run: the options after this word are those in which B "
            "differs from A");
        app.add_option("--mesh", mesh,
                       "Instead of another run: a mesh (" +
                           listText(pointFormats(), &PointFormat::name, "or", &PointFormat::faces) +
                           ") made from the same points; its vertices are matched by position")
            ->type_name("FILE");
        app.add_option("--most", limit, "List N regions of difference")
            ->type_name("N")
            ->capture_default_str();
        app.add_flag("--json", json, "As JSON, with all triangles that only one of the two has");
        app.add_flag("-q,--quiet", quiet, "Only the exit code: 1 if the meshes differ");
        app.footer(app.get_footer() +
                   "\n\nExample: spiraling-edge compare scene:torus --rules paper --with --rules "
                   "robust\nEvery decision begins with an address: spiraling-edge-viewer IN "
                   "OPTIONS --goto ADDRESS shows it.");
    }
};

/// A and B as two runs.
Comparison compareTwoRuns(const CompareArguments& arguments, const RunSpec& other,
                          ProgressLine& line) {
    const std::string& input = arguments.input.input();
    // Read once: standard input cannot be read a second time.
    const PointFile file = arguments.input.read(line);
    const PreparedInput a = arguments.input.prepare(file, line);
    const PreparedInput b = arguments.input.prepare(file, other, line);
    RunComparison runs = runWithProgress("comparing", input, line, [&](const Progress& progress) {
        return compareRuns({a.points, a.params}, {b.points, b.params}, progress);
    });
    MeshDifference meshes = compareMeshes(a.points.position, runs.a.triangles, runs.b.triangles);
    return {input,
            a.points.size(),
            {titleOf(arguments.input.spec()), runs.a},
            {titleOf(other), runs.b},
            std::move(meshes),
            std::move(runs),
            {}};
}

/// A as a run, B as the finished mesh of a file.
Comparison compareWithMesh(const CompareArguments& arguments, ProgressLine& line) {
    const std::string& input = arguments.input.input();
    const PointFile file = readInput(arguments.mesh, arguments.input.limit());
    if (file.faces.empty())
        throw Failure(ExitCode::Input, arguments.mesh + ": has no triangles to compare with");
    const PreparedInput a = arguments.input.prepare(line);
    MatchedMesh matched = matchMesh(a.points.position, file);
    // The run without B, to know where each triangle was made.
    MadeMesh run = runWithProgress("running", input, line, [&](const Progress& progress) {
        return makeMesh({a.points, a.params}, progress);
    });
    std::vector<Vec3> position = a.points.position;
    position.insert(position.end(), matched.unmatchedVertices.begin(),
                    matched.unmatchedVertices.end());
    MeshDifference meshes = compareMeshes(position, run.triangles, matched.triangles);
    MadeMesh other;
    other.triangles = std::move(matched.triangles);
    return {input,
            a.points.size(),
            {titleOf(arguments.input.spec()), std::move(run)},
            {arguments.mesh, std::move(other)},
            std::move(meshes),
            std::nullopt,
            std::move(matched.unmatchedNumbers)};
}

}  // namespace

ExitCode compareVerb(const Arguments& words) {
    const ComparedWords split = splitAtWith(words);
    CompareArguments arguments;
    CLI::App app("Compares two runs on the same points, or a run and the mesh of another program.",
                 "spiraling-edge compare");
    arguments.addTo(app);
    if (const auto code = parseArguments(app, split.a)) return *code;
    if (split.hasWith == !arguments.mesh.empty())
        throw Failure(ExitCode::Usage, "give the other run after --with, or a mesh by --mesh");
    if (arguments.input.input() == kStandardInput && arguments.mesh == kStandardInput)
        throw Failure(ExitCode::Usage, "--mesh -: standard input is IN already; name a file");
    // Mistakes in B are reported before the long work.
    const RunSpec other = specOfB(arguments.input.spec(), split.with);
    ProgressLine line(!arguments.quiet);
    const Comparison found =
        split.hasWith ? compareTwoRuns(arguments, other, line) : compareWithMesh(arguments, line);
    if (!arguments.quiet) {
        printText(arguments.json ? comparisonJson(found) : comparisonText(found, arguments.limit));
    }
    return found.meshes.same() ? ExitCode::Good : ExitCode::CheckFailed;
}

}  // namespace se::cli
