#include "prepare_form.h"

#include <cstdio>

#include "run/exact_text.h"

namespace se::view {

namespace {

constexpr std::uint64_t kMostNeighbors = 1000;
/// Where nobody says another one, a radius holds about as many as the 12 nearest.
constexpr double kRadiusInSpacings = 2.1;

/// Four digits are enough for a proposal.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return numberFromText(text).value_or(value);
}

}  // namespace

void PrepareForm::take(const InputSpec& spec, const Model& model) {
    *this = {};
    open = true;
    symmetric = spec.neighbors.symmetric;
    keepOpposing = spec.keepOpposing;
    keepNoise = spec.keepNoise;
    rim = spec.rim;
    normals = spec.normals;
    walls = spec.walls.from;
    box = boxFields(walls == WallChoice::From::Box ? spec.walls.box
                                                   : boxAround(model.points.position));
    radius = exact(rounded(kRadiusInSpacings * double{model.spacing} / model.scale));
    if (const auto* nearest = std::get_if<KNearest>(&spec.neighbors.reach)) {
        count = std::to_string(nearest->k);
        if (spec.neighbors.recompute) reach = Reach::Nearest;
    } else {
        radius = exact(std::get<WithinRadius>(spec.neighbors.reach).radius);
        if (spec.neighbors.recompute) reach = Reach::Radius;
    }
}

Result<InputSpec> PrepareForm::spec(InputSpec base) const {
    base.neighbors = {};
    base.neighbors.symmetric = symmetric;
    base.neighbors.recompute = reach != Reach::File;
    if (reach == Reach::Nearest) {
        const auto number = wholeFromText(count);
        if (!number || *number == 0 || *number > kMostNeighbors) {
            return Error{"Nearest: expected a whole number from 1 to 1000."};
        }
        base.neighbors.reach = KNearest{static_cast<std::size_t>(*number)};
    }
    if (reach == Reach::Radius) {
        const auto number = numberFromText(radius);
        if (!number || !(*number > 0.0)) return Error{"Radius: expected a number above 0."};
        base.neighbors.reach = WithinRadius{*number};
    }
    base.normals = normals;
    base.walls = {walls, {}};
    if (walls == WallChoice::From::Box) {
        const Result<WallBox> six = boxFromFields(box);
        if (!six) return six.error();
        base.walls.box = six.value();
    }
    base.keepOpposing = keepOpposing;
    base.keepNoise = keepNoise;
    base.rim = rim;
    return base;
}

}  // namespace se::view
