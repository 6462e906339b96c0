#include "forms.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "run/strings.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/sampling/field.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

std::optional<double> typedNumber(const std::string& text) {
    return numberIn<double>(trimmed(text));
}

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

BoxFields boxFields(const WallBox& box) {
    return {exact(box.low.x),  exact(box.low.y),  exact(box.low.z),
            exact(box.high.x), exact(box.high.y), exact(box.high.z)};
}

}  // namespace

Result<WallBox> boxFromFields(const BoxFields& fields) {
    const auto plain = [](const std::string& each) { return trimmed(each); };
    const std::optional<WallBox> box = boxFromText(joined(fields, ",", plain), ',');
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

// Between the options of an input and the fields that show them. A fix of the doctor is shown as
// the choices that it makes, and goes when a field is changed so that it makes another one.

namespace {

/// Default radius, which includes about as many points as the 12 nearest.
constexpr double kRadiusInSpacings = 2.1;

/// The rules that set neighbors or points aside.
constexpr std::array kKeepingRules{"opposing", "noise", "strays"};

bool isOff(const RunSpec& spec, const char* rule) {
    return valueOf(spec, *findRuleSetting(rule)) == 0.0;
}

/// Digits of a suggested value.
double rounded(double value) { return numberIn<double>(formatted("%.4g", value)).value_or(value); }

/// The fewest digits that are closer than a tenth of the tolerance of a wall.
std::string proposed(double value, const WallBox& box) {
    const Vec3 sides = box.high - box.low;
    const double off = 0.1 * box.tolerance * std::max({sides.x, sides.y, sides.z});
    for (int digits = 4; digits < 17; ++digits) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        const double read = numberIn<double>(text).value_or(value + 2.0 * off);
        if (std::abs(read - value) <= off) return exact(read);
    }
    return exact(value);
}

BoxFields proposedFields(const WallBox& box) {
    BoxFields fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const Vec3& corner = i < 3 ? box.low : box.high;
        fields[i] = proposed(corner[static_cast<int>(i % 3)], box);
    }
    return fields;
}

}  // namespace

void PrepareForm::take(const RunSpec& opened, const Model& model) {
    const RunSpec spec = withFixesAsOptions(opened);
    *this = {};
    open = true;
    symmetric = spec.neighbors.symmetric;
    keepOpposing = isOff(spec, kKeepingRules[0]);
    keepNoise = isOff(spec, kKeepingRules[1]);
    keepStrays = isOff(spec, kKeepingRules[2]);
    kept = {keepOpposing, keepNoise, keepStrays};
    rim = spec.rim;
    normals = spec.normals;
    for (int i = 0; spec.scanner && i < 3; ++i)
        scanner[static_cast<std::size_t>(i)] = exact((*spec.scanner)[i]);
    walls = spec.walls.from;
    box = walls == WallChoice::From::Box ? boxFields(spec.walls.box)
                                         : proposedFields(boxAround(model.points.position));
    radius = exact(rounded(kRadiusInSpacings * double{model.spacing} / model.scale));
    const NeighborOptions& lists = spec.neighbors;
    if (const auto* nearest = std::get_if<KNearest>(&lists.reach)) {
        count = std::to_string(nearest->k);
        if (lists.recompute) reach = Reach::Nearest;
    } else if (const auto* within = std::get_if<WithinSpacings>(&lists.reach)) {
        spacings = exact(within->spacings);
        if (lists.recompute) reach = Reach::Spacings;
    } else {
        radius = exact(std::get<WithinRadius>(lists.reach).radius);
        if (lists.recompute) reach = Reach::Radius;
    }
}

SpecChange PrepareForm::values() const {
    SpecChange values;
    const auto set = [&values](std::string_view key, const std::string& text) {
        values.push_back({findSpecField(key), text});
    };
    if (reach == Reach::Nearest) set("neighbors", count);
    if (reach == Reach::Radius) set("radius", radius);
    if (reach == Reach::Spacings) set("reach", spacings);
    if (symmetric) set("symmetric", "on");
    if (normals == NormalSource::Oriented) set("normals", "oriented");
    if (normals == NormalSource::Derived) set("normals", "derived");
    const std::string at = scanner[0] + "," + scanner[1] + "," + scanner[2];
    if (at != ",,") set("scanner", at);
    if (walls == WallChoice::From::Around) set("box", "auto");
    if (rim) set("rim", "on");
    return values;
}

Result<RunSpec> PrepareForm::spec(RunSpec base) const {
    base.neighbors = {};
    base.normals = NormalSource::AsGiven;
    base.scanner.reset();
    base.walls = {};
    base.rim = false;
    for (const auto& [field, text] : values()) {
        const Status set = setField(*field, base, text);
        if (set) continue;
        return Error{capitalized(std::string(field->key)) + ": " + set.error().message + "."};
    }
    if (walls == WallChoice::From::Box) {
        const Result<WallBox> six = boxFromFields(box);
        if (!six) return six.error();
        base.walls = {walls, six.value()};
    }
    const std::array<bool, 3> keeps{keepOpposing, keepNoise, keepStrays};
    for (std::size_t i = 0; i < keeps.size(); ++i) {
        if (keeps[i] == kept[i]) continue;
        base = withRule(std::move(base), kKeepingRules[i], keeps[i] ? 0.0 : 1.0);
    }
    // The choice made here replaces the one of a fix, unless they agree.
    std::erase_if(base.fixes, [made = base](const std::string& name) {
        const DoctorCheck* check = findDoctorCheck(name);
        return check != nullptr && changed(made, changeOf(check->fix)) != made;
    });
    return base;
}

}  // namespace se::view
