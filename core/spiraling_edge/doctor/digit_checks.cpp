/// The check for digits that were lost: coordinates far from the origin that were rounded to
/// floats, or to few decimal digits, in steps as wide as the points are apart. O(points).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "spiraling_edge/doctor/checks.h"

namespace se {
namespace {

/// The step of floats of this size.
double floatStep(double size) { return std::ldexp(1.0, std::ilogb(size) - 23); }

/// The wider of the steps of floats and of up to seven decimal digits, if all values of an axis are
/// multiples of it; 0 if of neither. `size`: of the largest value.
double stepOf(const ExaminedFile& examined, Vec3::length_type axis, double size) {
    const std::vector<Vec3>& position = examined.file.position;
    const auto areMultiples = [&](double step) {
        constexpr double kRounding = 1e-6;
        for (Index p = 0; p < examined.size(); ++p) {
            const double steps = position[p][axis] / step;
            if (examined.present()[p] && !(std::abs(steps - std::round(steps)) < kRounding))
                return false;
        }
        return true;
    };
    // Below a power of two the step is half as wide.
    const double whole = floatStep(size);
    const double floats = areMultiples(whole)         ? whole
                          : areMultiples(0.5 * whole) ? 0.5 * whole
                                                      : 0.0;
    constexpr int kDigits = 7;
    const int first = static_cast<int>(std::floor(std::log10(size)));
    for (int digits = 1; digits <= kDigits; ++digits) {
        const double each = std::pow(10.0, first + 1 - digits);
        if (areMultiples(each)) return std::max(floats, each);
    }
    return floats;
}

/// The wide steps of each axis; 0 where there are none.
using Steps = std::array<double, 3>;

/// The least distance between different values of each axis, if that is at least `least`; else 0.
Steps gridOf(const ExaminedFile& examined, double least) {
    Steps steps{};
    for (Vec3::length_type axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (Index p = 0; p < examined.size(); ++p) {
            if (examined.present()[p]) values.push_back(examined.file.position[p][axis]);
        }
        std::sort(values.begin(), values.end());
        double gap = std::numeric_limits<double>::max();
        for (std::size_t i = 1; i < values.size(); ++i) {
            if (values[i] > values[i - 1]) gap = std::min(gap, values[i] - values[i - 1]);
        }
        if (gap >= least && gap < std::numeric_limits<double>::max())
            steps[static_cast<std::size_t>(axis)] = gap;
    }
    return steps;
}

/// True if the points fill a grid of these steps: no two in one cell, and the nearest in the next.
/// Points rounded in one axis alone have no steps along the others.
bool isRegular(const ExaminedFile& examined, const Steps& steps) {
    constexpr double kNext = 1.5;
    const auto cellOf = [&](Index p) {
        std::array<double, 3> cell{};
        for (Vec3::length_type axis = 0; axis < 3; ++axis) {
            const double step = steps[static_cast<std::size_t>(axis)];
            if (step > 0.0)
                cell[static_cast<std::size_t>(axis)] =
                    std::round(examined.file.position[p][axis] / step);
        }
        return cell;
    };
    std::set<std::array<double, 3>> cells;
    std::vector<double> distances;
    for (Index p = 0; p < examined.size(); ++p) {
        if (!examined.present()[p] || examined.nearest()[p].empty()) continue;
        const auto here = cellOf(p);
        if (!cells.insert(here).second) return false;
        double nearest = std::numeric_limits<double>::max();
        for (const Index q : examined.nearest()[p]) {
            const auto there = cellOf(q);
            nearest = std::min(
                nearest, std::hypot(here[0] - there[0], here[1] - there[1], here[2] - there[2]));
        }
        distances.push_back(nearest);
    }
    return !distances.empty() && medianOf(distances) < kNext;
}

/// Steps above this share of the spacing are wide: rounding moves points by 0.3 steps, and what
/// narrower ones do is little noise.
constexpr double kWide = 0.2;

/// The steps of axes far from the origin that are wide beside the spacing; 0 for all others.
Steps wideSteps(const ExaminedFile& examined) {
    constexpr double kFar = 20.0;  // Times the longest extent.
    const InputFacts& facts = examined.intake.judge->facts;
    const Vec3 extent = facts.extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    Steps steps{};
    for (Vec3::length_type axis = 0; axis < 3; ++axis) {
        const double size = std::max(std::abs(facts.low[axis]), std::abs(facts.high[axis]));
        if (!(size > kFar * longest) || !(extent[axis] > 0.0)) continue;
        const double step = stepOf(examined, axis, size);
        if (step > kWide * examined.middleSpacing) steps[static_cast<std::size_t>(axis)] = step;
    }
    return steps;
}

}  // namespace

std::optional<Finding> findLostDigits(const ExaminedFile& examined) {
    if (examined.units || !(examined.middleSpacing > 0.0)) return std::nullopt;
    const Steps steps = wideSteps(examined);
    if (steps == Steps{}) return std::nullopt;
    if (isRegular(examined, gridOf(examined, kWide * examined.middleSpacing))) return std::nullopt;
    std::string text;
    for (std::size_t axis = 0; axis < steps.size(); ++axis) {
        if (steps[axis] == 0.0) continue;
        text += text.empty() ? "" : ", and ";
        text += std::string(1, "xyz"[axis]) + " keeps steps of " + shortNumber(steps[axis]);
    }
    Finding finding = findingOf(
        examined, Severity::Warning,
        text + ": digits were lost; the spacing is " + shortNumber(examined.middleSpacing));
    const auto widest = std::max_element(steps.begin(), steps.end());
    Vec3 step(0.0);
    step[static_cast<Vec3::length_type>(widest - steps.begin())] = 0.5 * *widest;
    // A point was anywhere within half a step to either side.
    finding.lines = evidenceAt(examined, [&](Index p) {
        const Vec3& x = examined.file.position[p];
        return std::optional(EvidenceLine{x - step, x + step});
    });
    return finding;
}

}  // namespace se
