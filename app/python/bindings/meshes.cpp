// Points, their preparation, meshes and verdicts.
#include <pybind11/stl.h>

#include <array>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "arrays.h"
#include "bindings.h"
#include "calls.h"
#include "paint/figures.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/sampling/gzip.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/session_text.h"
#include "spiraling_edge/why/inspected_run.h"
#include "spiraling_edge/why/trial.h"

namespace se::python {
namespace {

using namespace py::literals;
using Triangles = std::vector<Triangle>;
using TriangleArray = ArrayOf<Triangle>;

Input share(PointFile file, const std::string& source) {
    return {std::make_shared<const PointFile>(std::move(file)), source};
}

/// Rows of three numbers of any type, and how they are written.
std::vector<Vec3> rowsOf(const py::array& rows, ScalarType& type) {
    const bool single = rows.dtype().kind() == 'f' && rows.itemsize() <= 4;
    type = single ? ScalarType::Float : ScalarType::Double;
    return listOf<Vec3>(rows);
}

/// Points of arrays, and the triangles of a mesh.
Input fromArrays(const py::array& position, const py::array& normals,
                 const TriangleArray& triangles) {
    PointFile file;
    file.position = rowsOf(position, file.positionType);
    file.normal = rowsOf(normals, file.normalType);
    file.faces = listOf<Triangle>(triangles);
    return share(std::move(file), "");
}

/// The points of a file with other normals. Requires one for each.
Input withNormals(const Input& input, const py::array& normals) {
    PointFile file = *input.file;
    file.normal = rowsOf(normals, file.normalType);
    return share(std::move(file), input.source);
}

py::tuple listsOf(const NeighborLists& lists, const std::shared_ptr<const void>& owner) {
    return py::make_tuple(viewOf(lists.offset, owner), viewOf(lists.ids, owner));
}

/// The record Points.
py::object pointsRecord(const Input& input) {
    const PointFile& file = *input.file;
    py::dict attributes;
    for (const Attribute& each : file.attributes)
        attributes[textOf(each.name)] = viewOf(each.values, input.file);
    py::list notes;
    for (const std::string& each : file.notes) notes.append(textOf(each));
    return record("Points", viewOf(file.position, input.file), viewOf(file.normal, input.file),
                  viewOf(file.type, input.file), listsOf(file.neighbors, input.file),
                  viewOf(file.faces, input.file), attributes, py::tuple(notes), input);
}

py::object readSource(const py::object& path, std::uint64_t mostBytes) {
    const std::string source = pathOf(path);
    const ByteLimit limit{mostBytes, "most_bytes=N raises this limit"};
    const auto work = [&](const Progress&) -> Result<PointFile> {
        if (!isScene(source)) return readPoints(std::filesystem::path(source), limit, unpackGzip);
        const Scene* scene = findScene(std::string_view(source).substr(kScenePrefix.size()));
        if (scene != nullptr) return scene->build();
        return Error{source + ": no such scene; se.scenes() lists the scenes"};
    };
    return pointsRecord(share(require<InputError>(longCall(py::none(), work)), source));
}

/// The triangles of a mesh. Throws if they are not between the points.
Triangles trianglesOn(const PreparedRun& run, const TriangleArray& mesh) {
    Triangles triangles = listOf<Triangle>(mesh);
    if (!cornersBelow(triangles, run.points->size()))
        throw std::invalid_argument("triangles: a corner is no point of the mesh");
    return triangles;
}

void writeMade(const PreparedRun& run, const TriangleArray& mesh, const py::object& target,
               bool usedPoints, bool normals, bool force) {
    const std::string path = pathOf(target);
    std::error_code missing;
    if (!force && std::filesystem::equivalent(path, run.spec.source, missing))
        throw std::invalid_argument(path +
                                    ": the points are from this file; force=True replaces it");
    const MeshFormat* format = meshFormatOf(path);
    if (format == nullptr)
        throw std::invalid_argument(path + ": only " +
                                    listText(meshFormats(), &MeshFormat::extension, "and") +
                                    " can be written");
    if (normals && format->bytesWithNormals == nullptr)
        throw std::invalid_argument(path + ": " + std::string(format->extension) +
                                    " has no place for normals of points");
    const Triangles triangles = trianglesOn(run, mesh);
    const Status written = longCall(py::none(), [&](const Progress&) {
        PointFile file = *run.file;
        storeDerived(*run.points, run.report, file);
        if (!usedPoints) return writeMesh(path, file, triangles, {normals});
        file = withUsedPoints(file, triangles);
        return writeMesh(path, file, file.faces, {normals});
    });
    if (written) return;
    PyErr_SetObject(PyExc_OSError, textOf(written.error().message).ptr());
    throw py::error_already_set();
}

/// The record Mesh of prepared points, run to the end; `trials`: of best().
py::object meshOf(const SharedRun& run, const py::object& progress, const py::list& trials) {
    const Params params = paramsFrom(run->spec);
    Reconstruction made = longCall(progress, [&](const Progress& goOn) {
        return reconstruct(*run->points, params,
                           [&](const State& state) { return !goOnAt(state, goOn); });
    });
    return record("Mesh", preparedRecord(run), arrayOf(takeMesh(std::move(made.state))),
                  made.reason == StopReason::Capped, trials);
}

/// Tries changes of the settings, and runs with the best.
py::object bestOf(const Input& input, const Words& options, const py::object& progress) {
    const RunSpec named = specFrom(options, input.source);
    const Input piece = pieceFrom(input, named);
    if (!paramsFrom(named).start.empty())
        throw std::invalid_argument("best: the run begins with given triangles");
    const Trials trials = require<InputError>(longCall(
        progress, [&](const Progress& goOn) { return tryChanges(*piece.file, named, {}, goOn); }));
    py::list tried;
    for (const Trial& each : trials.tried)
        tried.append(record("Trial", wordsOf(each.change), headlineOf(each.verdict)));
    const Trial& best = trials.tried[trials.best];
    const SharedRun run = prepareRun(piece, changed(named, best.change), best.leaveOut, progress);
    run->named = named;
    return meshOf(run, progress, tried);
}

/// The record Verdict.
py::object verdictRecord(const JudgedMesh& judged) {
    const MeshVerdict& verdict = judged.verdict;
    py::dict counts;
    for (std::size_t i = 0; i < verdict.totals.size(); ++i)
        counts[textOf(failureClasses()[i].name)] = verdict.totals[i].total;
    for (const VerdictCount& each : verdictCounts()) counts[textOf(each.name)] = each.of(verdict);
    py::list failures;
    for (const MeshFailure& each : judged.inspection.failures)
        failures.append(record("Failure", textOf(each.kind->name), each.kind->fault, describe(each),
                               arrayOf(each.points), arrayOf(each.triangles),
                               py::make_tuple(each.place.x, each.place.y, each.place.z)));
    return record("Verdict", verdict.isSound(), headlineOf(verdict), isExact(verdict.totals),
                  verdict.places, verdict.pieces, verdict.openings, verdict.covered(),
                  verdict.fidelity.greatestDistance, verdict.fidelity.meanDistance, counts,
                  failures);
}

/// Throws if a corner is not finite.
JudgedMesh judgeFinite(const PointSet& points, const Triangles& triangles) {
    if (!haveFinitePositions(points, triangles))
        throw InputError("A triangle has a corner that is not finite.");
    return judgeMesh(points, triangles);
}

JudgedMesh judgedBy(const PreparedRun& run, const Triangles& triangles, const Progress& progress) {
    PointSet points = *run.points;
    points.judge = judgeOf(run, progress);
    return judgeFinite(points, triangles);
}

py::object judgeMade(const PreparedRun& run, const TriangleArray& mesh, bool stopped) {
    const Triangles triangles = trianglesOn(run, mesh);
    JudgedMesh judged = longCall(
        py::none(), [&](const Progress& progress) { return judgedBy(run, triangles, progress); });
    judged.verdict.stopped = stopped;
    return verdictRecord(judged);
}

/// `run`: the points that the mesh was made of; null: it is judged by its own.
py::object checkMesh(const Input& input, const SharedRun& run) {
    const PointFile& mesh = *input.file;
    if (mesh.faces.empty() && !run) throw InputError("The mesh has no triangles.");
    return verdictRecord(longCall(py::none(), [&](const Progress& progress) {
        if (!run) return judgeFinite(ownPoints(mesh), mesh.faces);
        const MatchedMesh matched = matchMesh(run->file->position, mesh);
        if (!matched.unmatchedNumbers.empty())
            throw InputError("vertex " + std::to_string(matched.unmatchedNumbers.front()) +
                             " of the mesh is none of the points that it is judged by");
        return judgedBy(*run, matched.triangles, progress);
    }));
}

/// Colors (size, size, 4) of a mesh as seen from a direction, the lowest row first. Requires
/// 1 <= size <= 8192.
py::array pictureOf(const PreparedRun& run, const TriangleArray& mesh, int size,
                    const std::array<double, 3>& toEye) {
    const Triangles triangles = trianglesOn(run, mesh);
    const Vec3 way(toEye[0], toEye[1], toEye[2]);
    if (!(glm::length(way) > 0.0)) throw std::invalid_argument("view: expected a direction");
    view::Picture picture = longCall(py::none(), [&](const Progress&) {
        return view::meshPicture(run.points->position, triangles, size, way);
    });
    return arrayOf(std::move(picture.rgba)).reshape({size, size, 4});
}

/// Writes the points with the lists of a run, and a session that opens them at an address. The path
/// of the session.
std::string writeSession(const PreparedRun& run, const py::object& folder,
                         const std::string& address) {
    PointFile file = *run.file;
    file.positionType = file.normalType = ScalarType::Double;
    file.normal = run.points->normal;
    file.type = run.points->type;
    file.neighbors = run.points->neighbors;
    const std::filesystem::path place(pathOf(folder));
    require<std::runtime_error>(writeMeshPly(place / "points.ply", file, {}));
    const RunSpec spec = withRule(specOf(paramsFrom(run.spec)), "opposing", 0.0);
    const std::filesystem::path session = place / ("run" + std::string(kSessionExtension));
    require<std::runtime_error>(
        writeFileAtomically(session, sessionText({"points.ply", spec, address})));
    return session.string();
}

/// The points prepared again, by other options.
py::object preparedAgain(const PreparedRun& run, const Words& options, const py::object& progress) {
    const SpecChange change = changeFrom(options);
    for (const FieldValue& each : change) {
        if (each.field->group == SpecGroup::Reading)
            throw std::invalid_argument(std::string(each.field->option) +
                                        ": these points are taken already");
    }
    const Input piece{run.file, run.spec.source};
    return preparedRecord(prepareRun(piece, otherRun(run.named, change), {}, progress));
}

}  // namespace

std::shared_ptr<const MeshJudge> judgeOf(const PreparedRun& run, const Progress& progress) {
    const Params params = paramsFrom(run.spec);
    const auto options =
        require<std::invalid_argument>(prepareOptionsOf(run.named, params, *run.file));
    return require<InputError>(judgeOfRun(*run.file, options, params, *run.points, progress));
}

py::object preparedRecord(const SharedRun& run) {
    const PrepareReport& report = run->report;
    py::dict counts(
        "set_aside"_a = report.countAside(), "normals_derived"_a = report.derived.normals,
        "normals_turned"_a = report.derived.turnedNormals,
        "unknown_sides"_a = report.derived.unknownSides, "rim_points"_a = report.derived.rimPoints,
        "lists_computed"_a = report.neighborsComputed, "noise"_a = report.noise);
    for (const AsideWords& each : asideReasons())
        counts[textOf(each.name)] = report.count(each.reason);
    const PointSet& points = *run->points;
    return record("Prepared", viewOf(points.position, run->points),
                  viewOf(points.normal, run->points), viewOf(points.type, run->points),
                  listsOf(points.neighbors, run->points), counts, wordsOf(valuesOf(run->spec)),
                  run);
}

void bindMeshes(py::module_& module) {
    py::class_<Input>(module, "Input")
        .def("record", pointsRecord)
        .def("with_normals", withNormals)
        .def(py::pickle([](const Input& input) { return pickled(input); },
                        [](const py::tuple& pickle) { return inputFrom(pickle); }));
    module.def("from_arrays", fromArrays);
    module.def("read", readSource);
    py::class_<PreparedRun, SharedRun>(module, "PreparedRun")
        .def("record", preparedRecord)
        .def("write_session", writeSession)
        .def("again", preparedAgain)
        .def("mesh", meshOf)
        .def("judge", judgeMade)
        .def("write", writeMade)
        .def("picture", pictureOf)
        .def(py::pickle([](const PreparedRun& run) { return pickled(run); },
                        [](const py::tuple& pickle) { return runFrom(pickle); }));
    module.def("prepare", [](const Input& input, const Words& options, const py::object& report) {
        const RunSpec spec = specFrom(options, input.source);
        return preparedRecord(prepareRun(pieceFrom(input, spec), spec, {}, report));
    });
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
