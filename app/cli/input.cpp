#include "input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>
#include <utility>

#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/gzip.h"
#include "spiraling_edge/sampling/volume.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/what_if_check.h"
#include "teach/lesson_runs.h"
#include "teach/spec_json.h"

namespace se::cli {
namespace {

Field readVolumeField(const std::string& input, const std::optional<double>& isovalue,
                      const ByteLimit& limit) {
    const auto volume = std::make_shared<const Volume>(
        require(readVolume(std::filesystem::path(input), limit), ExitCode::Input));
    const std::optional<double> iso = isovalue ? isovalue : volume->isovalue;
    if (!iso) {
        const auto [least, most] = std::minmax_element(volume->value.begin(), volume->value.end());
        refuse("{}: has no isovalue; give --iso V, from {} to {}", input, *least, *most);
    }
    return fieldOf(volume, *iso);
}

}  // namespace

RunSpec specOf(const SpecChange& given, RunSpec spec) {
    require(applyChange(given, spec), ExitCode::Usage);
    return spec;
}

PointFile readInput(const std::string& input, const ByteLimit& limit) {
    if (isVolumePath(input))
        throw Failure(ExitCode::Input,
                      "{}: is a volume; `spiraling-edge sample {} -n N -o POINTS.ply` samples "
                      "points on a surface in it",
                      input, shellPath(input));
    if (input.starts_with("sample:"))
        throw Failure(ExitCode::Input,
                      "{}: works in the viewer only; `spiraling-edge sample` writes such points to "
                      "a file first",
                      input);
    if (isScene(input)) return require(teach::buildScene(input), ExitCode::Input);
    return require(isStandardInput(input)
                       ? readStandardInput(limit, unpackGzip)
                       : readPoints(std::filesystem::path(input), limit, unpackGzip),
                   ExitCode::Input);
}

std::size_t countOfType(const PointFile& file, bool (*isSo)(std::uint8_t type)) {
    return static_cast<std::size_t>(std::count_if(file.type.begin(), file.type.end(), isSo));
}

InputPiece readPiece(const RunSpec& spec) {
    InputPiece read{readInput(spec.source, ByteLimit{spec.maxBytes}), spec.piece};
    read.inFile = read.file.position.size();
    read.file = require(cutPiece(std::move(read.file), spec.piece, nameOfInput(spec.source)),
                        ExitCode::Usage, "--crop: ");
    read.kept = read.file.position.size();
    return read;
}

Params paramsFrom(const RunSpec& spec) { return require(paramsOf(spec), ExitCode::Usage); }

PrepareOptions prepareOptionsFrom(const RunSpec& spec, const Params& params,
                                  const PointFile& file) {
    return require(prepareOptionsOf(spec, params, file), ExitCode::Usage, "--scanner: ");
}

void requireNoStart(const GivenStart& start, const std::string& what) {
    if (start.empty()) return;
    refuse("{}: the run begins with given triangles, which name points by numbers", what);
}

void InputArguments::addTo(CLI::App& app) {
    addTo(app, {SpecGroup::Reading, SpecGroup::Rules, SpecGroup::Lists, SpecGroup::Derived});
    addOption(app, "--start", "FILE", startFile_,
              "Begin with the triangles and edge rings of this JSON file "
              "(docs/file-formats.md)");
    app.footer(rulesHelp());
}

void InputArguments::addTo(CLI::App& app, std::initializer_list<SpecGroup> groups) {
    app.add_option("IN", input_, "File with points, - or scene:ID")->required();
    options_.addTo(app, groups);
}

const RunSpec& InputArguments::spec() const {
    if (spec_) return *spec_;
    const SpecChange given = options_.given();
    for (const FieldValue& each : given) {
        if (each.field->type == SpecType::Rule && isFormerRule(each.text))
            printNote(fmt::format("--rule {}: this rule is gone, and changes nothing\n",
                                  printable(each.text)));
    }
    RunSpec spec = specOf(given);
    spec.source = input_;
    if (!startFile_.empty())
        spec.start = require(teach::readStartFile(startFile_), ExitCode::Input);
    return spec_.emplace(std::move(spec));
}

void InputArguments::requirePossible(const PointSet& points, const Params& params) const {
    for (const char* key : {"crop", "thin"}) {
        if (options_.has(key)) requireNoStart(params.start, std::string("--") + key);
    }
    require(requireStart(points, params.start), ExitCode::Input,
            (startFile_.empty() ? nameOfInput(input_) : startFile_) + ": ");
    require(requireWhatIfs(points, params), ExitCode::Usage, "--what-if ");
}

PointFile InputArguments::read(const ProgressLine& line) const {
    InputPiece read = readPiece(spec());
    const std::string kept = keptSentence(read);
    if (line.isWanted() && !kept.empty())
        printNote(fmt::format("{}: kept {}\n", printable(input_), kept));
    return std::move(read.file);
}

PreparedInput InputArguments::prepare(PointFile file, const RunSpec& spec,
                                      ProgressLine& line) const {
    Params params = paramsFrom(spec);
    const PrepareOptions options = prepareOptionsFrom(spec, params, file);
    Prepared prepared = runWithProgress("preparing", input_, line, [&](const Progress& progress) {
        return se::prepare(file, options, progress);
    });
    requirePossible(prepared.points, params);
    file.normal = prepared.points.normal;
    file.type = prepared.points.type;
    return {applyFixes(file).file, std::move(prepared.points), std::move(params)};
}

Field readSurface(const std::string& input, const std::optional<double>& isovalue,
                  const ByteLimit& limit) {
    if (isovalue && !std::isfinite(*isovalue)) refuse("--iso: must be a finite number");
    if (isVolumePath(input)) return readVolumeField(input, isovalue, limit);
    const Shape* shape = findShape(input);
    if (shape == nullptr) {
        throw Failure(
            ExitCode::Input,
            "{} neither a shape nor a volume ({}); `spiraling-edge sample --list` lists the shapes",
            input, wordList(volumeExtensions(), ""));
    }
    Field field = fieldOf(*shape);
    if (isovalue) field.isovalue = *isovalue;
    return field;
}

void cutBy(const WallBox& box, const std::string& input, Field& field) {
    const bool within = glm::clamp(box.low, field.low, field.high) == box.low &&
                        glm::clamp(box.high, field.low, field.high) == box.high;
    if (isVolumePath(input) && !within) {
        refuse("--box: {} ends at {},{},{} and {},{},{}", input, field.low.x, field.low.y,
               field.low.z, field.high.x, field.high.y, field.high.z);
    }
    field = inBox(std::move(field), box.low, box.high);
}

std::string surfaceOf(const Figure& figure, const std::string& volumes) {
    if (figure.volume.empty()) {
        const std::string_view name = figure.sample.substr(figure.sample.find(':') + 1);
        return std::string(name.substr(0, name.find(',')));
    }
    if (volumes.empty()) return {};
    return (std::filesystem::path(volumes) / figure.volume).string();
}

PointFile samplePoints(const Field& field, const SamplerOptions& options, const std::string& input,
                       ProgressLine& line) {
    return runWithProgress("sampling", input, line, [&](const Progress& progress) {
        return sample(field, options, progress);
    });
}

}  // namespace se::cli
