// spiraling-edge check: the faults of a mesh, of this program or of any other.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "input.h"
#include "output/failures.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "verbs.h"

namespace se::cli {
namespace {

/// The classes that a mesh can have, without those at the end that only a run has.
std::span<const FailureClass> meshClasses() {
    const std::span<const FailureClass> all = failureClasses();
    const auto isOfMeshes = [](const FailureClass& each) { return each.find != nullptr; };
    return all.first(static_cast<std::size_t>(std::count_if(all.begin(), all.end(), isOfMeshes)));
}

struct CheckArguments : AnswerOptions {
    std::string mesh;
    std::string cloud;
    SpecOptions run;  ///< Those of the run, which prepare the points.
    RunSpec spec;     ///< The points, prepared as in the run.
    ByteLimit limit;
    std::vector<std::string> allowed;

    void addTo(CLI::App& app) {
        app.add_option("MESH", mesh,
                       "File with triangles (" +
                           listText(pointFormats(), &PointFormat::name, "or", &PointFormat::faces) +
                           "), or - for stdin")
            ->required();
        addOption(
            app, "--points", "CLOUD", cloud,
            "The points that the mesh was made of: their normals show what is flipped (derived "
            "ones if they do not fit the points), their wall types show what is no hole, and "
            "lost points are listed; with the options of the run, they are prepared as it "
            "prepared them, so that those it set aside are not listed");
        for (const char* key : {"crop", "thin", "scale", "rules", "switches"})
            run.addTo(app, *findSpecField(key));
        run.addTo(app, {SpecGroup::Lists, SpecGroup::Derived});
        addByteLimit(app, limit);
        addOption(app, "--allow", "CLASS", allowed,
                  "A class that is no fault here; may be repeated")
            ->allow_extra_args(false);
        addAnswerOptions(app,
                         fmt::format("As JSON, with all indices; of intersecting triangles, and of "
                                     "second layers, the first {}",
                                     kMaxListed),
                         "Only the exit code: 1 if there is a fault");
        std::string footer = "\nClasses:\n";
        for (const FailureClass& each : meshClasses())
            footer += fmt::format("  {:<23} {}\n", each.name, each.meaning);
        footer.pop_back();
        app.footer(footer);
    }

    /// True if an option of the run was given.
    bool prepares() const { return !run.given().empty(); }
    /// Makes the spec, and reports all mistakes that can be found before the work begins.
    void validate() {
        spec = specOf(run.given());
        spec.source = cloud;
        spec.maxBytes = limit.bytes;
        if (mesh == kStandardInput && cloud == kStandardInput)
            refuse("--points -: standard input is MESH already; name a file");
        if (cloud.empty() && prepares())
            refuse("options of a run prepare points: name them by --points");
        for (const std::string& name : allowed) {
            if (findFailureClass(name) == nullptr)
                refuse("--allow {}: no such class; see spiraling-edge check --help", name);
        }
    }
    bool allows(std::string_view name) const {
        return std::find(allowed.begin(), allowed.end(), name) != allowed.end();
    }
};

/// The points that a mesh is judged by; what the options of the run name counts.
PointSet judgedPoints(const PointFile& file, const CheckArguments& arguments) {
    const auto judgeOf = [&]() -> Result<std::shared_ptr<const MeshJudge>> {
        if (!arguments.prepares()) return judgeFor(file);
        const Params params = paramsFrom(arguments.spec);
        const PrepareOptions options = prepareOptionsFrom(arguments.spec, params, file);
        const Result<Prepared> prepared = prepare(file, options);
        if (!prepared) return prepared.error();
        return judgeOfRun(file, options, params, prepared.value().points);
    };
    auto judge = require(judgeOf(), ExitCode::Input, nameOfInput(arguments.cloud) + ": ");
    PointSet points = judge->points;
    points.judge = std::move(judge);
    return points;
}

/// The triangles in the numbering of the cloud's points. Throws Failure if a corner is not one
/// of them.
std::vector<Triangle> trianglesOn(const PointFile& cloud, const PointFile& mesh,
                                  const CheckArguments& names) {
    MatchedMesh matched = matchMesh(cloud.position, mesh);
    if (matched.unmatchedNumbers.empty()) return std::move(matched.triangles);
    const Vec3& x = matched.unmatchedVertices.front();
    throw Failure(ExitCode::Input,
                  "{}: vertex {} at ({:.6g}, {:.6g}, {:.6g}) is no point of {}; omit --points, or "
                  "give the points that the mesh was made of",
                  names.mesh, matched.unmatchedNumbers.front(), x.x, x.y, x.z, names.cloud);
}

/// True if the mesh is sound but for the allowed classes; one without a triangle never is.
bool isGood(const CheckArguments& arguments, const MeshVerdict& verdict) {
    std::vector<ClassTotal> totals = verdict.totals;
    for (std::size_t i = 0; i < totals.size(); ++i) {
        if (arguments.allows(failureClasses()[i].name)) totals[i] = {};
    }
    return isSound(totals, verdict.triangles);
}

constexpr std::size_t kShownFailures = 10;

/// Adds a class with the first of its failures.
void addClass(const CheckArguments& arguments, const FailureClass& kind, const ClassTotal& total,
              const std::vector<MeshFailure>& failures, std::string& text) {
    if (total.total == 0) return;
    const char* const allowance = arguments.allows(kind.name) ? ", allowed\n" : "\n";
    text += classText(kind, total) + (kind.fault ? allowance : ", no fault\n");
    std::size_t shown = 0;
    for (const MeshFailure& failure : failures) {
        if (failure.kind != &kind) continue;
        if (shown++ == kShownFailures) break;
        text += "          " + describe(failure).substr(kind.name.size() + 2) + "\n";
    }
    if (total.total > kShownFailures)
        text += total.all() ? "          ... all of them by --json\n"
                            : fmt::format("          ... the first {} by --json\n", total.listed);
}

Answer checkAnswer(const CheckArguments& arguments, const std::string& judgedBy,
                   const JudgedMesh& judged, bool good) {
    const MeshInspection& found = judged.inspection;
    const MeshVerdict& verdict = judged.verdict;
    Answer answer{fmt::format("{}: {}, {}{}\n", printable(arguments.mesh),
                              counted(verdict.triangles, "triangle"), headlineOf(verdict),
                              good && !verdict.isSound() ? ", allowed" : ""),
                  {{"mesh", arguments.mesh},
                   {"points", orNull(arguments.cloud)},
                   {"triangles", verdict.triangles},
                   {"judged", orNull(judgedBy)},
                   {"good", good},
                   {"verdict", verdictJson(verdict)}}};
    if (!judgedBy.empty()) answer.text += fmt::format("judged {}\n", judgedBy);
    addTotals(found.totals, meshClasses(), answer.json);
    std::vector<std::optional<std::size_t>> rowOf;
    for (std::size_t i = 0; i < found.failures.size(); ++i) rowOf.emplace_back(i);
    answer.text += placesText(judged.places, found.failures, kShownFailures);
    addPlaces(judged.places, found.failures, rowOf, judged.places.size(), answer.json);
    for (std::size_t i = 0; i < meshClasses().size(); ++i)
        addClass(arguments, meshClasses()[i], found.totals[i], found.failures, answer.text);
    answer.json["failures"] = Json::array();
    for (const MeshFailure& failure : found.failures)
        answer.json["failures"].push_back(failureRow(failure));
    return answer;
}

void requireFinite(const PointFile& file, const std::vector<Triangle>& triangles,
                   const std::string& name) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        for (const Index p : {t.a, t.b, t.c}) {
            if (isFinite(file.position[p])) continue;
            throw Failure(ExitCode::Input, "{}: triangle {} has corner {}, which is not finite",
                          name, i, p);
        }
    }
}

}  // namespace

ExitCode checkVerb(CLI::App& app, const Arguments& words) {
    CheckArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    arguments.validate();
    const PointFile mesh = readInput(arguments.mesh, arguments.limit);
    // A run that made nothing is a mesh as well, if the points are given.
    if (mesh.faces.empty() && arguments.cloud.empty())
        throw Failure(
            ExitCode::Input,
            "{0}: has no triangles; check reads meshes: spiraling-edge run {1} -o mesh.ply makes "
            "one, spiraling-edge why {1} --failures explains what goes wrong in the run",
            arguments.mesh, shellPath(arguments.mesh));
    const bool alone = arguments.cloud.empty();
    const PointFile cloud = alone ? PointFile{} : readPiece(arguments.spec).file;
    const PointFile& file = alone ? mesh : cloud;
    const std::vector<Triangle> triangles =
        alone ? mesh.faces : trianglesOn(cloud, mesh, arguments);
    requireFinite(file, triangles, arguments.mesh);
    const PointSet points = alone ? ownPoints(mesh) : judgedPoints(file, arguments);
    const std::string judgedBy = alone ? "" : departureText(*points.judge);
    const JudgedMesh judged = judgeMesh(points, triangles);
    const bool good = isGood(arguments, judged.verdict);
    if (!arguments.quiet) print(checkAnswer(arguments, judgedBy, judged, good), arguments.json);
    return good ? ExitCode::Good : ExitCode::CheckFailed;
}

}  // namespace se::cli
