#include "growth_page.h"

#include "run/number_format.h"
#include "run/strings.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/field.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

std::optional<double> typedNumber(const std::string& text) { return numberFromText(trimmed(text)); }

Result<SampleSpec> surfaceIn(const GrowthForm& form) {
    SampleSpec spec;
    const bool volume = form.from == GrowthSource::Volume;
    spec.surface = volume ? trimmed(form.volume) : form.shape;
    if (volume && !isVolumePath(spec.surface)) {
        const std::string file = "a file " + wordList(volumeExtensions(), "or") + ".";
        return Error{spec.surface.empty() ? "Choose a volume: " + file
                                          : spec.surface + " is not a volume: expected " + file};
    }
    if (!trimmed(form.isovalue).empty()) {
        spec.isovalue = typedNumber(form.isovalue);
        if (!spec.isovalue) return Error{"Isovalue: expected a number, or nothing."};
    }
    if (!form.cut) return spec;
    const Result<WallBox> box = boxFromFields(form.box);
    if (!box) return box.error();
    spec.box = box.value();
    return spec;
}

}  // namespace

BoxFields boxFields(const WallBox& box) {
    return {exact(box.low.x),  exact(box.low.y),  exact(box.low.z),
            exact(box.high.x), exact(box.high.y), exact(box.high.z)};
}

Result<WallBox> boxFromFields(const BoxFields& fields) {
    std::string text;
    for (const std::string& each : fields) text += (text.empty() ? "" : ",") + trimmed(each);
    const std::optional<WallBox> box = boxFromText(text, ',');
    if (box) return *box;
    return Error{"Box: expected six numbers, each of the first line below that of the second."};
}

Result<SampleSpec> GrowthForm::spec() const {
    Result<SampleSpec> surface = surfaceIn(*this);
    if (!surface) return surface;
    SampleSpec spec = surface.value();
    if (bySpacing) {
        spec.spacing = typedNumber(spacing).value_or(0.0);
        if (!(spec.spacing > 0.0)) return Error{"Spacing: expected a number > 0."};
    } else {
        const auto number = numberIn<std::uint64_t>(trimmed(count));
        if (!number || *number == 0 || *number > kMaxParticles) {
            return Error{"Points: expected a whole number from 1 to " +
                         std::to_string(kMaxParticles) + "."};
        }
        spec.count = static_cast<std::size_t>(*number);
    }
    const auto chosenSeed = numberIn<std::uint64_t>(trimmed(seed));
    if (!chosenSeed) return Error{"Seed: expected a whole number."};
    spec.seed = *chosenSeed;
    const auto bend = typedNumber(curvature);
    if (!bend || *bend < 0.0 || *bend > 100.0) {
        return Error{"Curvature: expected a number from 0 to 100."};
    }
    spec.curvature = *bend;
    return spec;
}

void GrowthForm::take(const SampleSpec& spec) {
    from = isVolumePath(spec.surface) ? GrowthSource::Volume : GrowthSource::Shape;
    (from == GrowthSource::Volume ? volume : shape) = spec.surface;
    isovalue = spec.isovalue ? exact(*spec.isovalue) : std::string{};
    bySpacing = spec.count == 0;
    if (spec.count > 0) count = std::to_string(spec.count);
    if (spec.spacing > 0.0) spacing = exact(spec.spacing);
    seed = std::to_string(spec.seed);
    curvature = exact(spec.curvature);
    cut = spec.box.has_value();
    if (spec.box) box = boxFields(*spec.box);
}

void GrowthForm::choose(std::string_view id) {
    from = GrowthSource::Shape;
    shape = id;
    isovalue.clear();
    cut = false;
}

void GrowthForm::chooseVolume(const std::string& path) {
    from = GrowthSource::Volume;
    volume = path;
    isovalue.clear();
    cut = false;
}

void GrowthForm::cutByOwnBox() {
    cut = true;
    const se::Shape* own = from == GrowthSource::Shape ? findShape(shape) : nullptr;
    if (own != nullptr) box = boxFields({own->low, own->high});
}

}  // namespace se::view
