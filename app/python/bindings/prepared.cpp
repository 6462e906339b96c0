// Options of a run, points prepared by them, and both in pickles.
#include <pybind11/stl.h>

#include <array>
#include <stdexcept>

#include "bindings.h"
#include "calls.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se::python {

SpecChange changeFrom(const Words& words) {
    return require<std::invalid_argument>(changeFromWords(words));
}

RunSpec specFrom(const Words& words, const std::string& source) {
    RunSpec spec = changed({}, changeFrom(words));
    spec.source = source;
    return spec;
}

Params paramsFrom(const RunSpec& spec) { return require<std::invalid_argument>(paramsOf(spec)); }

Input pieceFrom(const Input& input, const RunSpec& spec) {
    if (spec.piece.isWhole() && !spec.piece.isScaled()) return input;
    const std::string name = input.source.empty() ? "points" : input.source;
    PointFile piece = require<std::invalid_argument>(cutPiece(*input.file, spec.piece, name));
    if (piece.position.size() < input.file->position.size() && !paramsFrom(spec).start.empty())
        throw std::invalid_argument("The run begins with given triangles, which name all points.");
    return {std::make_shared<const PointFile>(std::move(piece)), input.source};
}

SharedRun prepareRun(const Input& piece, const RunSpec& spec, const std::vector<Index>& leaveOut,
                     const py::object& progress) {
    const PointFile& file = *piece.file;
    if (file.position.empty()) throw InputError("There are no points to triangulate.");
    const Params params = paramsFrom(spec);
    PrepareOptions options = require<std::invalid_argument>(prepareOptionsOf(spec, params, file));
    options.leaveOut = leaveOut;
    Prepared prepared = require<InputError>(
        longCall(progress, [&](const Progress& goOn) { return prepare(file, options, goOn); }));
    auto points = std::make_shared<const PointSet>(std::move(prepared.points));
    auto run = std::make_shared<PreparedRun>(
        PreparedRun{piece.file, std::move(points), prepared.report, spec, spec, leaveOut});
    possibleParams(*run);
    return run;
}

Params possibleParams(const PreparedRun& run) {
    Params params = paramsFrom(run.spec);
    require<InputError>(requireStart(*run.points, params.start));
    require<std::invalid_argument>(requireWhatIfs(*run.points, params));
    return params;
}

// Pickles, for other processes of the same version.

namespace {

/// All that is set, as words that changeFrom() reads.
Words wordsIn(const RunSpec& spec) {
    Words words;
    for (const auto& [field, text] : valuesOf(spec))
        words.push_back(std::string(field->option.substr(field->option.find("--"))) + "=" + text);
    return words;
}

}  // namespace

py::tuple pickled(const Input& input) {
    const PointFile& file = *input.file;
    std::optional<std::array<double, 3>> viewpoint;
    if (file.viewpoint) viewpoint = {file.viewpoint->x, file.viewpoint->y, file.viewpoint->z};
    const std::string bytes = meshFormats().front().bytes(file, file.faces);
    const std::vector<py::bytes> notes(file.notes.begin(), file.notes.end());
    return py::make_tuple(py::bytes(input.source), py::bytes(bytes), viewpoint, notes);
}

Input inputFrom(const py::tuple& pickle) {
    PointFile file = require<InputError>(readPoints(pickle[1].cast<std::string>(), "pickle.ply"));
    if (const auto at = pickle[2].cast<std::optional<std::array<double, 3>>>())
        file.viewpoint = Vec3((*at)[0], (*at)[1], (*at)[2]);
    file.notes = pickle[3].cast<std::vector<std::string>>();
    return {std::make_shared<const PointFile>(std::move(file)), pickle[0].cast<std::string>()};
}

py::tuple pickled(const PreparedRun& run) {
    return py::make_tuple(pickled(Input{run.file, run.spec.source}), wordsIn(run.spec),
                          wordsIn(run.named), run.leaveOut);
}

SharedRun runFrom(const py::tuple& pickle) {
    const Input piece = inputFrom(pickle[0]);
    SharedRun run = prepareRun(piece, specFrom(pickle[1].cast<Words>(), piece.source),
                               pickle[3].cast<std::vector<Index>>(), py::none());
    run->named = specFrom(pickle[2].cast<Words>(), piece.source);
    return run;
}

}  // namespace se::python
