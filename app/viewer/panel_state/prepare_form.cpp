// Between the options of an input and the fields that show them. A fix of the doctor is shown as
// the choices that it makes, and goes when a field is changed so that it makes another one.
#include "prepare_form.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "run/number_format.h"
#include "run/strings.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se::view {

namespace {

/// Default radius, which includes about as many points as the 12 nearest.
constexpr double kRadiusInSpacings = 2.1;

/// The rules that set neighbors or points aside.
constexpr std::array kKeepingRules{"opposing", "noise", "strays"};

bool isOff(const RunSpec& spec, const char* rule) {
    return valueOf(spec, *findRuleSetting(rule)) == 0.0;
}

/// Digits of a suggested value.
double rounded(double value) { return numberFromText(formatted("%.4g", value)).value_or(value); }

/// The fewest digits that are closer than a tenth of the tolerance of a wall.
std::string proposed(double value, const WallBox& box) {
    const Vec3 sides = box.high - box.low;
    const double off = 0.1 * box.tolerance * std::max({sides.x, sides.y, sides.z});
    for (int digits = 4; digits < 17; ++digits) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        const double read = numberFromText(text).value_or(value + 2.0 * off);
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

void PrepareForm::take(const RunSpec& spec, const Model& model) {
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
    for (const std::string& name : spec.fixes) {
        if (const DoctorCheck* check = findDoctorCheck(name)) show(check->fix);
    }
}

void PrepareForm::show(Fix fix) {
    if (fix == Fix::Orient) normals = NormalSource::Oriented;
    if (fix == Fix::Derive) normals = NormalSource::Derived;
    if (fix == Fix::Symmetric) symmetric = true;
    if (fix == Fix::Walls) walls = WallChoice::From::Around;
    if (fix == Fix::Rim) rim = true;
    if (fix != Fix::NewLists) return;
    reach = Reach::Nearest;
    count = std::to_string(KNearest{}.k);
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
        std::string name(field->key);
        name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
        return Error{name + ": " + set.error().message + "."};
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
    std::erase_if(base.fixes, [this](const std::string& name) {
        PrepareForm fixed = *this;
        if (const DoctorCheck* check = findDoctorCheck(name)) fixed.show(check->fix);
        return fixed != *this;
    });
    return base;
}

}  // namespace se::view
