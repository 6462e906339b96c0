// Between the options of an input and the fields that show them. A fix of the doctor is shown as
// the choices that it makes, and goes when a field is changed so that it makes another one.
#include "prepare_form.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "run/number_format.h"
#include "run/strings.h"
#include "spiraling_edge/base/text_scan.h"

namespace se::view {

namespace {

constexpr std::uint64_t kMaxNeighbors = 1000;
/// Default radius, which includes about as many points as the 12 nearest.
constexpr double kRadiusInSpacings = 2.1;

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

void PrepareForm::take(const InputSpec& spec, const Model& model) {
    *this = {};
    open = true;
    symmetric = spec.neighbors.symmetric;
    keepOpposing = spec.keepOpposing;
    keepNoise = spec.keepNoise;
    keepStrays = spec.keepStrays;
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
    if (fix == Fix::Symmetric) symmetric = true;
    if (fix == Fix::Walls) walls = WallChoice::From::Around;
    if (fix == Fix::Rim) rim = true;
    if (fix != Fix::NewLists) return;
    reach = Reach::Nearest;
    count = std::to_string(KNearest{}.k);
}

Status PrepareForm::setScanner(std::optional<Vec3>& at) const {
    at.reset();
    const auto isEmpty = [](const std::string& text) { return text.empty(); };
    if (std::all_of(scanner.begin(), scanner.end(), isEmpty)) return success();
    Vec3 read{};
    for (int i = 0; i < 3; ++i) {
        const auto number = numberFromText(scanner[static_cast<std::size_t>(i)]);
        if (!number) return Error{"Scanner: expected three numbers, or none."};
        read[i] = *number;
    }
    at = read;
    return success();
}

Status PrepareForm::setReach(NeighborOptions& neighbors) const {
    neighbors = {};
    neighbors.symmetric = symmetric;
    neighbors.recompute = reach != Reach::File;
    if (reach == Reach::Nearest) {
        const auto number = numberIn<std::uint64_t>(count);
        if (!number || *number == 0 || *number > kMaxNeighbors) {
            return Error{"Nearest: expected a whole number from 1 to 1000."};
        }
        neighbors.reach = KNearest{static_cast<std::size_t>(*number)};
    }
    if (reach == Reach::Radius || reach == Reach::Spacings) {
        const bool byRadius = reach == Reach::Radius;
        const double number = numberFromText(byRadius ? radius : spacings).value_or(0.0);
        if (!(number > 0.0))
            return Error{std::string(byRadius ? "Radius" : "Spacings") +
                         ": expected a number > 0."};
        if (byRadius) neighbors.reach = WithinRadius{number};
        if (!byRadius) neighbors.reach = WithinSpacings{number};
    }
    return success();
}

Result<InputSpec> PrepareForm::spec(InputSpec base) const {
    if (const Status set = setReach(base.neighbors); !set) return set.error();
    base.normals = normals;
    if (const Status set = setScanner(base.scanner); !set) return set.error();
    base.walls = {walls, {}};
    if (walls == WallChoice::From::Box) {
        const Result<WallBox> six = boxFromFields(box);
        if (!six) return six.error();
        base.walls.box = six.value();
    }
    base.keepOpposing = keepOpposing;
    base.keepNoise = keepNoise;
    base.keepStrays = keepStrays;
    base.rim = rim;
    // The choice made here replaces the one of a fix, unless they agree.
    std::erase_if(base.fixes, [this](const std::string& name) {
        PrepareForm fixed = *this;
        if (const DoctorCheck* check = findDoctorCheck(name)) fixed.show(check->fix);
        return fixed != *this;
    });
    return base;
}

}  // namespace se::view
