#include "sample_spec.h"

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <memory>
#include <vector>

#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"
#include "strings.h"

namespace se::view {

namespace {

/// Parses one `key=value`. Empty: there is no such key; false: the value is wrong.
std::optional<bool> takePart(std::string_view key, std::string_view value, SampleSpec& spec) {
    const auto number = numberIn<double>(value);
    const auto whole = numberIn<std::uint64_t>(value);
    if (key == "n") {
        spec.count = static_cast<std::size_t>(whole.value_or(0));
        return whole && *whole > 0 && *whole <= kMaxParticles;
    }
    if (key == "spacing") {
        spec.spacing = number.value_or(0.0);
        return spec.spacing > 0.0;
    }
    if (key == "seed") {
        spec.seed = whole.value_or(1);
        return whole.has_value();
    }
    if (key == "iso") {
        spec.isovalue = number;
        return number.has_value();
    }
    if (key == "curvature") {
        spec.curvature = number.value_or(0.0);
        return number && *number >= 0.0 && *number <= 100.0;
    }
    if (key == "steps") {
        const auto all = static_cast<std::uint64_t>(Sampler::allSteps());
        spec.steps = static_cast<int>(whole.value_or(0));
        return whole && *whole > 0 && *whole <= all;
    }
    if (key != "box") return std::nullopt;
    spec.box = boxFromText(value, ':');
    return spec.box.has_value();
}

Result<Field> volumeField(const SampleSpec& spec) {
    Result<Volume> read = readVolume(std::filesystem::path(spec.surface), ByteLimit{spec.maxBytes});
    if (!read) return read.error();
    const auto volume = std::make_shared<const Volume>(std::move(read.value()));
    const std::optional<double> iso = spec.isovalue ? spec.isovalue : volume->isovalue;
    if (!iso) {
        const auto [least, most] = std::minmax_element(volume->value.begin(), volume->value.end());
        return Error{spec.surface + ": has no isovalue; give one, from " + exact(*least) + " to " +
                     exact(*most) + "."};
    }
    return fieldOf(volume, *iso);
}

Result<Field> shapeField(const SampleSpec& spec) {
    const se::Shape* shape = findShape(spec.surface);
    if (shape == nullptr) {
        std::vector<std::string_view> known;
        for (const se::Shape& each : shapes()) known.push_back(each.id);
        return Error{inQuotes(spec.surface) + " is neither a volume (" +
                     wordList(volumeExtensions(), "") +
                     ") nor a shape. Shapes are: " + wordList(known, "") + "."};
    }
    Field field = fieldOf(*shape);
    if (spec.isovalue) field.isovalue = *spec.isovalue;
    return field;
}

}  // namespace

bool operator==(const SampleSpec& a, const SampleSpec& b) {
    return sampleSource(a) == sampleSource(b);
}

SamplerOptions SampleSpec::sampler() const {
    return {.count = count, .spacing = spacing, .seed = seed, .curvature = curvature};
}

std::string sampleSource(const SampleSpec& spec) {
    std::string text = std::string(kSamplePrefix) + spec.surface;
    if (spec.count > 0) text += ",n=" + std::to_string(spec.count);
    if (spec.count == 0) text += ",spacing=" + exact(spec.spacing);
    if (spec.isovalue) text += ",iso=" + exact(*spec.isovalue);
    if (spec.seed != 1) text += ",seed=" + std::to_string(spec.seed);
    if (spec.curvature > 0.0) text += ",curvature=" + exact(spec.curvature);
    if (spec.box) text += ",box=" + boxText(*spec.box, ':');
    if (spec.steps > 0) text += ",steps=" + std::to_string(spec.steps);
    return text;
}

Result<SampleSpec> sampleFromSource(std::string_view source) {
    const std::string name(source);
    if (!isSample(source)) return Error{name + ": expected sample:SHAPE,n=N or sample:VOLUME,n=N."};
    source.remove_prefix(kSamplePrefix.size());
    SampleSpec spec;
    // From the end: there may be commas in a path.
    while (true) {
        const std::size_t comma = source.rfind(',');
        const std::string_view part =
            comma == std::string_view::npos ? std::string_view{} : source.substr(comma + 1);
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos) break;
        const auto taken = takePart(part.substr(0, equals), part.substr(equals + 1), spec);
        if (!taken) {
            if (isVolumePath(part)) break;
            return Error{name + ": " + inQuotes(part) +
                         ": expected n, spacing, iso, seed, curvature, box or steps."};
        }
        if (!*taken) {
            std::string text = name;
            text.append(": \"").append(part).append("\" is out of range");
            if (part.starts_with("n="))
                text.append("; n is from 1 to ").append(std::to_string(kMaxParticles));
            return Error{text.append(".")};
        }
        source = source.substr(0, comma);
    }
    spec.surface = source;
    if (spec.surface.empty()) return Error{name + ": names neither a shape nor a volume."};
    if ((spec.count > 0) == (spec.spacing > 0.0)) {
        return Error{name +
                     ": give either the number of points, n=N, or their spacing, spacing=S."};
    }
    return spec;
}

std::string sampleCommand(const SampleSpec& spec) {
    return sampleCommand(spec, sampleStem(spec, spec.count) + ".ply");
}

std::string sampleCommand(const SampleSpec& spec, std::string_view output) {
    if (spec.steps > 0) return {};
    std::string text = "spiraling-edge sample " + shellPath(spec.surface);
    text +=
        spec.count > 0 ? " -n " + std::to_string(spec.count) : " --spacing " + exact(spec.spacing);
    // Joined by =, since a value with a minus sign would be parsed as an option.
    if (spec.isovalue) text += " --iso=" + exact(*spec.isovalue);
    if (spec.seed != 1) text += " --seed " + std::to_string(spec.seed);
    if (spec.curvature > 0.0) text += " --curvature " + exact(spec.curvature);
    if (spec.box) text += " --box=" + boxText(*spec.box, ',');
    return text + " -o " + shellPath(output);
}

std::string sampleTitle(const SampleSpec& spec, std::size_t count) {
    return std::filesystem::path(spec.surface).stem().string() + ", " + grouped(count) + " points";
}

std::string sampleStem(const SampleSpec& spec, std::size_t count) {
    const std::string name = std::filesystem::path(spec.surface).stem().string();
    return count > 0 ? name + "-" + std::to_string(count) : name;
}

Result<Field> surfaceOf(const SampleSpec& spec) {
    Result<Field> field = isVolumePath(spec.surface) ? volumeField(spec) : shapeField(spec);
    if (!field || !spec.box) return field;
    const Field& whole = field.value();
    const auto outside = [&](const Vec3& corner) {
        return glm::clamp(corner, whole.low, whole.high) != corner;
    };
    if (isVolumePath(spec.surface) && (outside(spec.box->low) || outside(spec.box->high))) {
        return Error{"The box leaves the volume, which fills " +
                     boxText({whole.low, whole.high}, ' ') + "."};
    }
    return inBox(whole, spec.box->low, spec.box->high);
}

Result<PointFile> samplePoints(const SampleSpec& spec, const Progress& progress) {
    const Result<Field> field = surfaceOf(spec);
    if (!field) return field.error();
    if (spec.steps == 0) return sample(field.value(), spec.sampler(), progress);
    Result<Sampler> begun = Sampler::begin(field.value(), spec.sampler(), progress);
    if (!begun) return begun.error();
    Sampler& sampler = begun.value();
    while (sampler.steps() < spec.steps) {
        const double done = sampler.steps();
        const auto goOn = [&](double share) {
            return !progress || progress((done + share) / spec.steps);
        };
        if (!sampler.step(goOn)) return Error{"sampling was cancelled"};
    }
    return sampler.points();
}

}  // namespace se::view
