// Options of a run, and points prepared by them.
#include <algorithm>
#include <stdexcept>

#include "bindings.h"
#include "calls.h"
#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se::python {
namespace {

/// True if a row of the table takes this option: of several rows of a key the one with its word.
bool takes(const SpecField& field, const std::pair<std::string, std::string>& option) {
    const bool isWord = field.type == SpecType::Word && !field.flag.empty();
    return !field.option.empty() && field.key == option.first &&
           (!isWord || field.flag == option.second);
}

}  // namespace

RunSpec withOptions(RunSpec spec, const Options& options) {
    for (const auto& option : options) {
        const SpecField* const field = findSpecField(option.first);
        if (field == nullptr || field->option.empty())
            throw std::invalid_argument(option.first + ": no such option of a run");
        RunSpec trial;
        if (const Status set = setField(*field, trial, option.second); !set)
            throw std::invalid_argument(option.first + " " + option.second + ": " +
                                        set.error().message);
    }
    SpecChange change;
    for (const SpecField& field : specFields()) {
        for (const auto& option : options) {
            if (!takes(field, option)) continue;
            for (const FieldValue& each : change) {
                if (!field.excludes.empty() && each.field->excludes == field.excludes)
                    throw std::invalid_argument(option.first + ": not together with " +
                                                std::string(each.field->key));
            }
            change.push_back({&field, option.second});
        }
    }
    require<std::invalid_argument>(applyChange(change, spec));
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
                     const pybind11::object& progress) {
    const PointFile& file = *piece.file;
    if (file.position.empty()) throw InputError("There are no points to triangulate.");
    const Params params = paramsFrom(spec);
    PrepareOptions options = require<std::invalid_argument>(prepareOptionsOf(spec, params, file));
    options.leaveOut = leaveOut;
    Prepared prepared = require<InputError>(
        longCall(progress, [&](const Progress& goOn) { return prepare(file, options, goOn); }));
    auto points = std::make_shared<const PointSet>(std::move(prepared.points));
    auto run = std::make_shared<PreparedRun>(
        PreparedRun{piece.file, std::move(points), prepared.report, spec, spec});
    possibleParams(*run);
    return run;
}

Params possibleParams(const PreparedRun& run) {
    Params params = paramsFrom(run.spec);
    require<InputError>(requireStart(*run.points, params.start));
    require<std::invalid_argument>(requireWhatIfs(*run.points, params));
    return params;
}

}  // namespace se::python
