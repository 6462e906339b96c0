// Options of a run, and points prepared by them.
#include <map>
#include <stdexcept>
#include <string_view>

#include "bindings.h"
#include "calls.h"
#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se::python {
namespace {

/// `text`: the value, or empty.
[[noreturn]] void refuse(const std::string& key, const std::string& text,
                         const std::string& reason) {
    const std::string name = key == "switches" ? "rule" : key;
    throw std::invalid_argument(name + (text.empty() ? "" : " " + text) + ": " + reason);
}

}  // namespace

RunSpec withOptions(RunSpec spec, const Options& options) {
    for (const auto& [key, text] : options) {
        const SpecField* const field = findSpecField(key);
        if (field == nullptr || field->option.empty()) refuse(key, "", "no such option of a run");
    }
    std::map<std::string_view, std::string> seen;  // the option of each kind that excludes others
    for (const SpecField& field : specFields()) {
        if (findSpecField(field.key) != &field) continue;  // another word of the same key
        for (const auto& [key, text] : options) {
            if (field.key != key) continue;
            const auto [other, isFirst] = seen.try_emplace(field.excludes, key);
            if (!field.excludes.empty() && !isFirst)
                refuse(key, "", "not together with " + other->second);
            if (const Status set = setField(field, spec, text); !set)
                refuse(key, text, set.error().message);
        }
    }
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
