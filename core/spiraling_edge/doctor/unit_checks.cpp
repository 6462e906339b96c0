/// Axes with different units: the points are a surface only if the axes are scaled. Factors are
/// looked for among a few: meters per degree, and a thousandth. O(points), but for a search for the
/// nearest with equal spans, and one per candidate, where one axis is much longer than both others.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "spiraling_edge/doctor/checks.h"

namespace se {
namespace {

/// Surfaces have 60 % and more, points in other units than the lists expect nearly none.
constexpr double kSurface = 0.5;
constexpr double kNoSurface = 0.1;

/// Share of places that are planar, of about two thousand; 0 without points.
double planarShare(std::span<const Vec3> position, const std::vector<bool>& present,
                   const NeighborLists& nearest) {
    constexpr std::size_t kPlaces = 2000;
    const auto count = static_cast<std::size_t>(std::count(present.begin(), present.end(), true));
    const std::size_t step = std::max<std::size_t>(1, count / kPlaces);
    std::vector<bool> tried(present.size(), false);
    std::size_t next = 0;
    for (std::size_t p = 0; p < present.size(); ++p) tried[p] = present[p] && next++ % step == 0;
    const std::vector<Vec3> any(position.size(), Vec3(0.0, 0.0, 1.0));
    const NormalFit fit = fitOf({position, any, tried, nearest});
    if (fit.normals == 0) return 0.0;
    return static_cast<double>(fit.places) / static_cast<double>(fit.normals);
}

/// How evenly points are spread over a surface: the mean ratio of the distances to the nearest and
/// to the last of the list. Factors that stretch it make this less; 0 without points.
double evenness(std::span<const Vec3> position, const NeighborLists& nearest) {
    double sum = 0.0;
    std::size_t count = 0;
    for (Index p = 0; p < position.size(); ++p) {
        const std::span<const Index> list = nearest[p];
        if (list.empty()) continue;
        const double last = distanceSquared(position[p], position[list.back()]);
        if (!(last > 0.0)) continue;
        sum += std::sqrt(distanceSquared(position[p], position[list.front()]) / last);
        ++count;
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

ScaledSurface scaledSurface(const ExaminedFile& examined, const Vec3& factors) {
    const Vec3 low = examined.intake.judge->facts.low;
    std::vector<Vec3> position = examined.file.position;
    for (Vec3& x : position) x = (x - low) * factors;
    auto nearest = nearestPoints(position, examined.present(), KNearest{}.k);
    if (!nearest) return {};
    const double planar = planarShare(position, examined.present(), nearest.value());
    const double even = evenness(position, nearest.value());
    return {planar, even, std::move(nearest.value())};
}

/// The longest extent in units of the second longest; 0 of a flat box.
double longestByNext(const Vec3& extent) {
    std::array<double, 3> sorted{extent.x, extent.y, extent.z};
    std::sort(sorted.begin(), sorted.end());
    return sorted[0] > 0.0 ? sorted[2] / sorted[1] : 0.0;
}

/// Meters per degree of longitude, and of latitude, at this latitude; rounded.
std::pair<double, double> metersPerDegree(double latitude) {
    constexpr double kAlongEquator = 111320.0;
    constexpr double kAlongMeridian = 111132.0;
    const double cosine = std::cos(latitude * std::numbers::pi / 180.0);
    return {std::round(kAlongEquator * cosine), kAlongMeridian};
}

/// x and y as degrees, if they can be, in each of both orders: longitude first.
std::vector<UnitScale> degreeScalesOf(const InputFacts& facts) {
    std::vector<UnitScale> orders;
    const auto isWithin = [&](int axis, double most) {
        return facts.low[axis] >= -most && facts.high[axis] <= most;
    };
    const auto add = [&](int longitude, int latitude, const char* words, const char* ifSo) {
        const double middle = 0.5 * (facts.low[latitude] + facts.high[latitude]);
        const auto [east, north] = metersPerDegree(middle);
        if (!isWithin(longitude, 180.0) || !isWithin(latitude, 90.0) || east < 1.0) return;
        UnitScale scale{Vec3(1.0), words, ifSo};
        scale.factors[longitude] = east;
        scale.factors[latitude] = north;
        orders.push_back(scale);
    };
    add(0, 1, "x and y as degrees of longitude and latitude, in meters",
        "x is the longitude in degrees");
    add(1, 0, "x and y as degrees of latitude and longitude, in meters",
        "x is the latitude in degrees");
    return orders;
}

/// The longest axis as thousandths: millimeters beside meters, or meters beside kilometers.
UnitScale thousandthOf(int longest) {
    constexpr std::array kWords{"x as thousandths of the unit of y and z",
                                "y as thousandths of the unit of x and z",
                                "z as thousandths of the unit of x and y"};
    UnitScale scale{Vec3(1.0), kWords[static_cast<std::size_t>(longest)],
                    "they are kilometers beside meters"};
    scale.factors[longest] = 0.001;
    return scale;
}

/// More of the ratios of distances is told from less by this factor.
constexpr double kMoreEven = 1.05;

/// The first of two conversions that both make a surface, with the other one as the alternative.
UnitScale orElse(UnitScale first, const UnitScale& second) {
    first.otherwise.append(first.otherwise.empty() ? "if " : "; if ")
        .append(second.ifSo)
        .append(": --scale-by ")
        .append(plainNumbers(second.factors));
    return first;
}

/// Of two orders that both make a surface the one by which the points are spread more evenly. Where
/// they do not tell, as on a grid of degrees, the longitude is first, as in most files.
UnitScale likelierOrder(const ExaminedFile& examined, const UnitScale& first,
                        const UnitScale& second) {
    const double north = std::max(first.factors.y, second.factors.x);
    const double square = scaledSurface(examined, Vec3(north, north, 1.0)).even;
    if (second.surface.even > kMoreEven * std::max(first.surface.even, square)) return second;
    const bool told = first.surface.even > kMoreEven * std::max(second.surface.even, square);
    return told ? first : orElse(first, second);
}

/// Of degrees and kilometers that both make a surface the one that spreads the points more evenly.
/// Where they do not tell, on gentle hills, kilometers if one of the axes has 0, as local
/// coordinates do.
UnitScale likelierUnit(const ExaminedFile& examined, const UnitScale& degrees,
                       const UnitScale& kilometers) {
    if (degrees.surface.even > kMoreEven * kilometers.surface.even) return degrees;
    if (kilometers.surface.even > kMoreEven * degrees.surface.even) return kilometers;
    const InputFacts& facts = examined.intake.judge->facts;
    const auto hasZero = [&](int axis) {
        return facts.low[axis] <= 0.0 && facts.high[axis] >= 0.0;
    };
    return hasZero(0) || hasZero(1) ? orElse(kilometers, degrees) : orElse(degrees, kilometers);
}

/// Of a few conversions the one that makes the best surface, if any does.
std::optional<UnitScale> scaleOf(const ExaminedFile& examined) {
    // Scaled to nothing along the longest axis any points are planar, but not more even.
    constexpr double kGain = 1.2;
    const double before = evenness(examined.file.position, examined.nearest());
    const auto judge = [&](UnitScale& scale) {
        scale.surface = scaledSurface(examined, scale.factors);
        return scale.surface.planar >= kSurface && scale.surface.even >= kGain * before;
    };
    const InputFacts& facts = examined.intake.judge->facts;
    const Vec3 extent = facts.extent();
    const int longest = extent.x > std::max(extent.y, extent.z) ? 0 : extent.y > extent.z ? 1 : 2;
    std::vector<UnitScale> degrees =
        longest == 2 ? degreeScalesOf(facts) : std::vector<UnitScale>{};
    std::erase_if(degrees, [&](UnitScale& each) { return !judge(each); });
    UnitScale thousandth = thousandthOf(longest);
    const bool thousandthFits = judge(thousandth);
    if (!degrees.empty()) {
        const UnitScale likelier =
            degrees.size() == 1 ? degrees.front() : likelierOrder(examined, degrees[0], degrees[1]);
        return thousandthFits ? likelierUnit(examined, likelier, thousandth) : likelier;
    }
    if (thousandthFits) return thousandth;
    return std::nullopt;
}

}  // namespace

std::optional<MixedUnits> mixedUnitsOf(const ExaminedFile& examined) {
    MixedUnits units{examined.intake.judge->facts.extent()};
    constexpr double kLong = 10.0;
    constexpr double kVeryLong = 100.0;
    const double longest = longestByNext(units.extent);
    if (longest < kLong) return std::nullopt;
    units.planar = planarShare(examined.file.position, examined.present(), examined.nearest());
    if (units.planar > kNoSurface) return std::nullopt;
    ScaledSurface equal = scaledSurface(examined, 1.0 / units.extent);
    units.planarScaled = equal.planar;
    units.scale = scaleOf(examined);
    if (!units.scale && (longest < kVeryLong || equal.planar < kSurface)) return std::nullopt;
    units.scaled = std::move(units.scale ? units.scale->surface.nearest : equal.nearest);
    return units;
}

std::optional<Finding> findExtremeSize(const ExaminedFile& examined) {
    // Between 1 / kMost and kMost, `robust` makes the same meshes at every size.
    constexpr double kMost = 1e30;
    const Vec3 extent = examined.intake.judge->facts.extent();
    const double size = std::max({extent.x, extent.y, extent.z});
    if (!(size > 0.0) || (size <= kMost && size >= 1.0 / kMost)) return std::nullopt;
    Finding finding = findingOf(examined, Severity::Note,
                                "the points span " + shortNumber(size) +
                                    ": meshes of robust may have more faults than at a usual size");
    finding.scale = Vec3(std::ldexp(1.0, -std::ilogb(size)));
    return finding;
}

std::optional<Finding> findMixedUnits(const ExaminedFile& examined) {
    if (!examined.units) return std::nullopt;
    const auto percent = [](double share) { return shortNumber(100.0 * share) + " %"; };
    const Vec3& extent = examined.units->extent;
    Finding finding =
        findingOf(examined, Severity::Error,
                  "x, y and z have different units: they span " + shortNumber(extent.x) + ", " +
                      shortNumber(extent.y) + " and " + shortNumber(extent.z) + "; " +
                      percent(examined.units->planar) + " of the places are planar, and " +
                      percent(examined.units->planarScaled) + " with equal spans");
    finding.lines = alongLists(examined, examined.nearest());
    // These lines are short: lists hold points of one height, from all over the surface. Those with
    // equal units show what lists should hold.
    for (EvidenceLine line : alongLists(examined, examined.units->scaled)) {
        line.asItShouldBe = true;
        finding.lines.push_back(line);
    }
    const std::optional<UnitScale>& scale = examined.units->scale;
    if (!scale) return finding;
    finding.scale = scale->factors;
    finding.text += std::string(kWithFactors) + std::string(scale->words) + ", " +
                    percent(scale->surface.planar) + " are";
    if (!scale->otherwise.empty()) finding.text += " (" + scale->otherwise + ")";
    return finding;
}

}  // namespace se
