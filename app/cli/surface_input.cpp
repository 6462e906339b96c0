#include "surface_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

#include "exit_code.h"
#include "input.h"
#include "progress.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::cli {
namespace {

Field readVolumeField(const std::string& input, const std::optional<double>& isovalue,
                      const ByteLimit& limit) {
    const auto volume = std::make_shared<const Volume>(
        require(readVolume(std::filesystem::path(input), limit), ExitCode::Input));
    const std::optional<double> iso = isovalue ? isovalue : volume->isovalue;
    if (!iso) {
        const auto [least, most] = std::minmax_element(volume->value.begin(), volume->value.end());
        throw Failure(ExitCode::Usage, "{}: has no isovalue; give --iso V, from {} to {}", input,
                      *least, *most);
    }
    return fieldOf(volume, *iso);
}

}  // namespace

Field readSurface(const std::string& input, const std::optional<double>& isovalue,
                  const ByteLimit& limit) {
    if (isovalue && !std::isfinite(*isovalue))
        throw Failure(ExitCode::Usage, "--iso: must be a finite number");
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
        throw Failure(ExitCode::Usage, "--box: {} ends at {},{},{} and {},{},{}", input,
                      field.low.x, field.low.y, field.low.z, field.high.x, field.high.y,
                      field.high.z);
    }
    field = inBox(std::move(field), box.low, box.high);
}

PointFile samplePoints(const Field& field, const SamplerOptions& options, const std::string& input,
                       ProgressLine& line) {
    return runWithProgress("sampling", input, line, [&](const Progress& progress) {
        return sample(field, options, progress);
    });
}

}  // namespace se::cli
