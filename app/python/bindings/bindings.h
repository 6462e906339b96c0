/// Points and prepared runs as Python holds them: immutable, and shared with the arrays over them.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "spiraling_edge/stepper/state.h"

namespace se::python {

/// A record of the package: the class of that name in __init__.py, made of its fields.
template <typename... Fields>
pybind11::object record(const char* name, Fields&&... fields) {
    const auto package = pybind11::module_::import("spiraling_edge");
    return package.attr(name)(std::forward<Fields>(fields)...);
}

/// Points as they were read or given, and their source: a path, scene:ID, or empty.
struct Input {
    std::shared_ptr<const PointFile> file;
    std::string source;
};

/// Options of the command line as its words, "--neighbors=16" and "--symmetric".
using Words = std::vector<std::string>;

/// Throws std::invalid_argument with the sentence of the first word that is wrong.
SpecChange changeFrom(const Words& words);
/// The run of a source by options. Throws as changeFrom().
RunSpec specFrom(const Words& words, const std::string& source);
/// The params of a spec. Throws std::invalid_argument.
Params paramsFrom(const RunSpec& spec);

/// Points that are ready for a run, and how they were made so.
struct PreparedRun {
    std::shared_ptr<const PointFile> file;  ///< As taken: the piece of the input.
    std::shared_ptr<const PointSet> points;
    PrepareReport report;
    RunSpec spec;
    RunSpec named;  ///< Of the user, by which meshes are judged; `spec` may be better (best()).
    std::vector<Index> leaveOut;  ///< Points that were set aside to make the mesh better.
};
using SharedRun = std::shared_ptr<PreparedRun>;

/// The piece of the input that a spec names. Throws std::invalid_argument if that is empty.
Input pieceFrom(const Input& input, const RunSpec& spec);
/// Prepares the points of a piece by a spec, those at `leaveOut` set aside. Throws InputError,
/// Cancelled, and std::invalid_argument where possibleParams() does.
SharedRun prepareRun(const Input& piece, const RunSpec& spec, const std::vector<Index>& leaveOut,
                     const pybind11::object& progress);
/// The params of a run. Throws InputError if it cannot begin at its start, std::invalid_argument if
/// a what-if has no effect.
Params possibleParams(const PreparedRun& run);
/// The judge of meshes of a run, by what the user has set. Throws InputError where judgeOfRun()
/// fails.
std::shared_ptr<const MeshJudge> judgeOf(const PreparedRun& run, const Progress& progress);

/// The record Event of a decision.
pybind11::object eventRecord(const Event& event);
/// The record Reading of a decision; None if it compared nothing.
pybind11::object readingOrNone(const std::optional<Reading>& reading);
/// The record Prepared of prepared points.
pybind11::object preparedRecord(const SharedRun& run);

/// Adds Input and PreparedRun, and the functions over them.
void bindMeshes(pybind11::module_& module);
/// Adds Cursor and Stepper, and why().
void bindStepping(pybind11::module_& module);

/// The contents of a pickle of points.
pybind11::tuple pickled(const Input& input);
/// The contents of a pickle of prepared points: these as they were taken, and the options.
pybind11::tuple pickled(const PreparedRun& run);
/// The points of a pickle.
Input inputFrom(const pybind11::tuple& pickle);
/// The prepared points of a pickle, prepared again. Throws as prepareRun().
SharedRun runFrom(const pybind11::tuple& pickle);

}  // namespace se::python
