// Points, their preparation, meshes and verdicts. Each class has one function that gives its parts
// as a dict, of which the package makes records.
#include <pybind11/stl.h>

#include <stdexcept>

#include "arrays.h"
#include "bindings.h"
#include "calls.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/session_text.h"
#include "spiraling_edge/why/inspected_run.h"
#include "spiraling_edge/why/trial.h"

namespace se::python {
namespace {

using namespace py::literals;
using Triangles = std::vector<Triangle>;

/// A mesh that a run has made.
struct MadeMesh {
    SharedRun run;
    std::shared_ptr<const Triangles> triangles;
    Counters counters;
    bool stopped = false;  ///< AlertKind::TriangleCap.
};

Input share(PointFile file, const std::string& source) {
    return {std::make_shared<const PointFile>(std::move(file)), source};
}

/// Points of arrays, and the triangles of a mesh; `single`, `singleNormals`: they were floats.
Input fromArrays(const ArrayOf<Vec3>& position, bool single, const ArrayOf<Vec3>& normals,
                 bool singleNormals, const ArrayOf<Triangle>& triangles) {
    PointFile file;
    file.position = listOf<Vec3>(position);
    file.normal = listOf<Vec3>(normals);
    file.faces = listOf<Triangle>(triangles);
    file.positionType = single ? ScalarType::Float : ScalarType::Double;
    file.normalType = singleNormals ? ScalarType::Float : ScalarType::Double;
    return share(std::move(file), "");
}

Result<PointFile> readSource(const std::string& source) {
    if (!isScene(source)) return readPoints(std::filesystem::path(source));
    const Scene* scene = findScene(std::string_view(source).substr(kScenePrefix.size()));
    if (scene != nullptr) return scene->build();
    return Error{source + ": no such scene; se.scenes() lists the scenes"};
}

py::tuple listsOf(const NeighborLists& lists, const std::shared_ptr<const void>& owner) {
    return py::make_tuple(viewOf(lists.offset, owner), viewOf(lists.ids, owner));
}

py::dict partsOf(const Input& input) {
    const PointFile& file = *input.file;
    py::dict attributes;
    for (const Attribute& each : file.attributes)
        attributes[textOf(each.name)] = viewOf(each.values, input.file);
    return py::dict("position"_a = viewOf(file.position, input.file),
                    "normals"_a = viewOf(file.normal, input.file),
                    "types"_a = viewOf(file.type, input.file),
                    "triangles"_a = viewOf(file.faces, input.file),
                    "neighbors"_a = listsOf(file.neighbors, input.file),
                    "attributes"_a = attributes, "notes"_a = py::tuple(py::cast(file.notes)));
}

py::dict partsOf(const PreparedRun& run) {
    const PrepareReport& report = run.report;
    py::dict counts(
        "set_aside"_a = report.countAside(), "normals_derived"_a = report.derived.normals,
        "normals_turned"_a = report.derived.turnedNormals,
        "unknown_sides"_a = report.derived.unknownSides, "rim_points"_a = report.derived.rimPoints,
        "lists_computed"_a = report.neighborsComputed, "noise"_a = report.noise);
    for (const AsideWords& each : asideReasons())
        counts[textOf(each.name)] = report.count(each.reason);
    const PointSet& points = *run.points;
    return py::dict("position"_a = viewOf(points.position, run.points),
                    "normals"_a = viewOf(points.normal, run.points),
                    "types"_a = viewOf(points.type, run.points),
                    "neighbors"_a = listsOf(points.neighbors, run.points), "report"_a = counts,
                    "options"_a = wordsOf(valuesOf(run.spec)));
}

/// The points of a run as they are written beside a mesh.
PointFile writtenPoints(const PreparedRun& run) {
    PointFile file = *run.file;
    storeDerived(*run.points, run.report, file);
    return file;
}

void writeMade(const MadeMesh& mesh, const std::string& path, bool usedPoints, bool normals) {
    if (meshFormatOf(path) == nullptr)
        throw std::invalid_argument(path + ": only " +
                                    listText(meshFormats(), &MeshFormat::extension, "and") +
                                    " can be written");
    const Status written = longCall(py::none(), [&](const Progress&) {
        PointFile file = writtenPoints(*mesh.run);
        if (!usedPoints) return writeMesh(path, file, *mesh.triangles, {normals});
        file = withUsedPoints(file, *mesh.triangles);
        return writeMesh(path, file, file.faces, {normals});
    });
    if (written) return;
    PyErr_SetString(PyExc_OSError, written.error().message.c_str());
    throw py::error_already_set();
}

/// Runs prepared points to the end.
MadeMesh reconstructRun(const SharedRun& run, const py::object& progress) {
    const Params params = paramsFrom(run->spec);
    Reconstruction made = longCall(progress, [&](const Progress& goOn) {
        return reconstruct(*run->points, params,
                           [&](const State& state) { return !goOnAt(state, goOn); });
    });
    const Counters counters = made.state.counters;
    auto mesh = std::make_shared<const Triangles>(takeMesh(std::move(made.state)));
    return {run, std::move(mesh), counters, made.reason == StopReason::Capped};
}

/// Tries changes of the settings, and runs with the best; with the words and headlines of all.
py::tuple bestOf(const Input& input, const Options& options, const py::object& progress) {
    RunSpec named = withOptions({}, options);
    named.source = input.source;
    const Input piece = pieceFrom(input, named);
    if (!paramsFrom(named).start.empty())
        throw std::invalid_argument("best: the run begins with given triangles");
    const Trials trials = require<InputError>(longCall(
        progress, [&](const Progress& goOn) { return tryChanges(*piece.file, named, {}, goOn); }));
    py::list tried;
    for (const Trial& each : trials.tried)
        tried.append(py::make_tuple(wordsOf(each.change), headlineOf(each.verdict)));
    const Trial& best = trials.tried[trials.best];
    const SharedRun run = prepareRun(piece, changed(named, best.change), best.leaveOut, progress);
    run->named = named;
    return py::make_tuple(reconstructRun(run, progress), tried);
}

/// The judge of meshes of a run, by what the user has set.
std::shared_ptr<const MeshJudge> judgeOf(const PreparedRun& run, const Progress& progress) {
    const Params params = paramsFrom(run.spec);
    const auto options =
        require<std::invalid_argument>(prepareOptionsOf(run.named, params, *run.file));
    auto judge = require<InputError>(judgeFor(*run.file, options, *run.points, progress));
    return withoutOpeningsToClose(std::move(judge), params);
}

py::dict dictOf(const JudgedMesh& judged) {
    const MeshVerdict& verdict = judged.verdict;
    py::dict counts;
    for (std::size_t i = 0; i < verdict.totals.size(); ++i)
        counts[textOf(failureClasses()[i].name)] = verdict.totals[i].total;
    for (const VerdictCount& each : verdictCounts()) counts[textOf(each.name)] = each.of(verdict);
    py::list failures;
    for (const MeshFailure& each : judged.inspection.failures) {
        const py::dict failure(
            "kind"_a = textOf(each.kind->name), "is_fault"_a = each.kind->fault,
            "sentence"_a = describe(each), "points"_a = arrayOf(each.points),
            "triangles"_a = arrayOf(each.triangles),
            "place"_a = py::make_tuple(each.place.x, each.place.y, each.place.z));
        failures.append(failure);
    }
    return py::dict("sound"_a = verdict.isSound(), "headline"_a = headlineOf(verdict),
                    "exact"_a = isExact(verdict.totals), "places"_a = verdict.places,
                    "pieces"_a = verdict.pieces, "openings"_a = verdict.openings,
                    "covered"_a = verdict.covered(),
                    "greatest_distance"_a = verdict.fidelity.greatestDistance,
                    "mean_distance"_a = verdict.fidelity.meanDistance, "counts"_a = counts,
                    "failures"_a = failures);
}

py::dict judgeMade(const MadeMesh& mesh) {
    JudgedMesh judged = longCall(py::none(), [&](const Progress& progress) {
        PointSet points = *mesh.run->points;
        points.judge = judgeOf(*mesh.run, progress);
        return judgeMesh(points, *mesh.triangles);
    });
    judged.verdict.stopped = mesh.stopped;
    return dictOf(judged);
}

/// The points that judge a mesh: those that it was made of, in whose numbers `mesh` is then, or its
/// own if `run` is null.
PointSet judgingPoints(PointFile& mesh, const SharedRun& run, const Progress& progress) {
    PointSet points;
    if (!run) {
        points.position = std::move(mesh.position);
        points.normal = std::move(mesh.normal);
        points.type = std::move(mesh.type);
        return points;
    }
    MatchedMesh matched = matchMesh(run->file->position, mesh);
    if (!matched.unmatchedNumbers.empty())
        throw InputError("vertex " + std::to_string(matched.unmatchedNumbers.front()) +
                         " of the mesh is none of the points that it is judged by");
    mesh.faces = std::move(matched.triangles);
    auto judge = judgeOf(*run, progress);
    points = judge->points;
    points.judge = std::move(judge);
    return points;
}

py::dict checkMesh(const Input& input, const SharedRun& run) {
    PointFile mesh = *input.file;
    if (mesh.faces.empty() && !run) throw InputError("The mesh has no triangles.");
    if (!cornersBelow(mesh.faces, mesh.position.size()))
        throw std::invalid_argument("triangles: a corner is no point of the mesh");
    return dictOf(longCall(py::none(), [&](const Progress& progress) {
        const PointSet points = judgingPoints(mesh, run, progress);
        if (!haveFinitePositions(points, mesh.faces))
            throw InputError("A triangle has a corner that is not finite.");
        return judgeMesh(points, mesh.faces);
    }));
}

/// Writes the points with the lists of a run, and a session that opens them at an address.
void writeSession(const PreparedRun& run, const std::string& folder, const std::string& address) {
    PointFile file = *run.file;
    file.positionType = file.normalType = ScalarType::Double;
    file.normal = run.points->normal;
    file.type = run.points->type;
    file.neighbors = run.points->neighbors;
    const std::filesystem::path place(folder);
    require<std::runtime_error>(writeMeshPly(place / "points.ply", file, {}));
    const RunSpec spec = withRule(specOf(paramsFrom(run.spec)), "opposing", 0.0);
    require<std::runtime_error>(
        writeFileAtomically(place / "run.sesession", sessionText({"points.ply", spec, address})));
}

/// The same points with the rules of these options; without any, with their own.
SharedRun withRules(const PreparedRun& run, const Options& options) {
    if (options.empty()) return std::make_shared<PreparedRun>(run);
    for (const auto& option : options) {
        const SpecField* const field = findSpecField(option.first);
        if (field != nullptr && field->group != SpecGroup::Rules)
            throw std::invalid_argument(option.first + ": these points are prepared already");
    }
    PreparedRun other = run;
    other.spec = other.named = withOptions(withRulesOf(run.named, {}), options);
    const Params before = paramsFrom(run.spec);
    const Params after = possibleParams(other);
    if (before.setNoiseAside != after.setNoiseAside ||
        before.setStraysAside != after.setStraysAside ||
        before.dropOpposingNormals != after.dropOpposingNormals)
        throw std::invalid_argument(
            "rules: these set other points aside, or others from the lists; prepare the points by "
            "them");
    return std::make_shared<PreparedRun>(std::move(other));
}

}  // namespace

py::dict countersDict(const Counters& c) {
    return py::dict("pivots"_a = c.pivots, "skipped"_a = c.skipped, "seeds"_a = c.seeds,
                    "isolated"_a = c.isolated, "stranded"_a = c.stranded,
                    "discarded"_a = c.discarded, "splits"_a = c.splits, "joins"_a = c.joins,
                    "freed_rings"_a = c.freedRings, "holes"_a = c.holes);
}

void bindMeshes(py::module_& module) {
    py::class_<Input>(module, "Input").def("parts", [](const Input& i) { return partsOf(i); });
    module.def("from_arrays", fromArrays);
    module.def("from_source", [](const std::string& source) {
        const auto work = [&](const Progress&) { return readSource(source); };
        return share(require<InputError>(longCall(py::none(), work)), source);
    });
    module.def("from_bytes", [](const std::string& bytes, const std::string& name) {
        const auto work = [&](const Progress&) { return readPoints(bytes, name); };
        return share(require<InputError>(longCall(py::none(), work)), name);
    });
    py::class_<PreparedRun, SharedRun>(module, "PreparedRun")
        .def("parts", [](const PreparedRun& run) { return partsOf(run); })
        .def("source", [](const PreparedRun& run) { return py::bytes(run.spec.source); })
        .def("write_session", writeSession)
        .def("with_rules", withRules);
    module.def("prepare", [](const Input& input, const Options& options, const py::object& report) {
        RunSpec spec = withOptions({}, options);
        spec.source = input.source;
        return prepareRun(pieceFrom(input, spec), spec, {}, report);
    });
    py::class_<MadeMesh>(module, "MadeMesh")
        .def("parts",
             [](const MadeMesh& mesh) {
                 return py::dict("triangles"_a = viewOf(*mesh.triangles, mesh.triangles),
                                 "counters"_a = countersDict(mesh.counters),
                                 "stopped"_a = mesh.stopped);
             })
        .def_readonly("run", &MadeMesh::run)
        .def("judge", judgeMade)
        .def("write", writeMade);
    module.def("reconstruct", reconstructRun);
    module.def("best", bestOf);
    module.def("check", checkMesh);
    module.def("scenes", [] {
        py::dict titles;
        for (const Scene& each : scenes()) titles[textOf(each.id)] = textOf(each.title);
        for (const FailureScene& each : failureScenes())
            titles[textOf(each.scene.id)] = textOf(each.scene.title);
        return titles;
    });
}

}  // namespace se::python
