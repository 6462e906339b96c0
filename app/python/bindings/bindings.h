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

/// Points as they were read or given, and their source: a path, scene:ID, or empty.
struct Input {
    std::shared_ptr<const PointFile> file;
    std::string source;
};

/// Keys of the table of fields (spec_fields.h) and texts, in any order.
using Options = std::vector<std::pair<std::string, std::string>>;

/// `spec` with options. Throws std::invalid_argument with the sentence of the first that is wrong.
RunSpec withOptions(RunSpec spec, const Options& options);
/// The params of a spec. Throws std::invalid_argument.
Params paramsFrom(const RunSpec& spec);
/// The piece of the input that a spec names. Throws std::invalid_argument if that is empty.
Input pieceFrom(const Input& input, const RunSpec& spec);

/// Points that are ready for a run, and how they were made so.
struct PreparedRun {
    std::shared_ptr<const PointFile> file;  ///< As taken: the piece of the input.
    std::shared_ptr<const PointSet> points;
    PrepareReport report;
    RunSpec spec;
    RunSpec named;  ///< Of the user, by which meshes are judged; `spec` may be better (best()).
};
using SharedRun = std::shared_ptr<PreparedRun>;

/// Prepares the points of a piece by a spec, those at `leaveOut` set aside. Throws InputError,
/// Cancelled, and std::invalid_argument where possibleParams() does.
SharedRun prepareRun(const Input& piece, const RunSpec& spec, const std::vector<Index>& leaveOut,
                     const pybind11::object& progress);
/// The params of a run. Throws InputError if it cannot begin at its start, std::invalid_argument if
/// a what-if has no effect.
Params possibleParams(const PreparedRun& run);

/// Quantity, unit, value, threshold and margin of a decision; empty if it compared nothing.
pybind11::dict readingDict(const std::optional<Reading>& reading);
/// The counts of a run by name.
pybind11::dict countersDict(const Counters& counters);

/// Adds Event.
void bindEvents(pybind11::module_& module);
/// Adds Input, PreparedRun and MadeMesh, and the functions over them.
void bindMeshes(pybind11::module_& module);
/// Adds Cursor and Stepper, and why().
void bindStepping(pybind11::module_& module);

}  // namespace se::python
