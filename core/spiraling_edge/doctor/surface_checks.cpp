/// Checks of the points as a surface: noise, and two layers of one surface, as two scans that were
/// not well registered leave. Each point's list, and the lists of that list, are fitted by a
/// quadric (surface_fit.h). The heights over the small patch are the noise. Those over the wide one
/// are spread as noise is, or stand in two heaps: TwoHeaps::share tells, averaged by the median
/// over the patch. Thresholds are measured: docs/doctor.md. O(points times patch).
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/doctor/surface_fit.h"
#include "spiraling_edge/prepare/normals.h"

namespace se {
namespace {

constexpr std::size_t kFitsPerThread = 1024;
/// With fewer points, patches go around a bend of the surface: heights over a fit may be its shape.
constexpr std::size_t kFewPoints = 150;

/// True if q may be in one sheet with p: thin parts are two surfaces, not two layers of one.
bool onSameSide(const ExaminedFile& examined, Index p, Index q) {
    if (!examined.normalsNear || !examined.hasSide(p) || !examined.hasSide(q)) return true;
    return !normalsOppose(examined.normal()[p], examined.normal()[q], kRightAngle);
}

/// The point and its list.
void smallPatch(const ExaminedFile& examined, Index p, std::vector<Index>& patch) {
    patch.assign(1, p);
    for (const Index q : examined.nearest()[p]) {
        if (onSameSide(examined, p, q)) patch.push_back(q);
    }
}

/// The small patch, and the lists of its points.
void widePatch(const ExaminedFile& examined, Index p, std::vector<Index>& patch) {
    smallPatch(examined, p, patch);
    const std::size_t small = patch.size();
    for (std::size_t i = 1; i < small; ++i) {
        for (const Index q : examined.nearest()[patch[i]]) {
            if (onSameSide(examined, p, q)) patch.push_back(q);
        }
    }
    std::sort(patch.begin() + 1, patch.end());
    patch.erase(std::unique(patch.begin() + 1, patch.end()), patch.end());
    // The frame of the fit stands at the first point: p once, in front.
    const auto again = std::lower_bound(patch.begin() + 1, patch.end(), p);
    if (again != patch.end() && *again == p) patch.erase(again);
}

/// Heights so low, in spacings, are those of a surface that bends.
constexpr double kBends = 0.05;

/// TwoHeaps::share about each point: the median over its wide patch, where heights are not low.
std::vector<double> shareAroundAll(const ExaminedFile& examined) {
    std::vector<double> around(examined.size(), 0.0);
    forRanges(examined.size(), 0, kFitsPerThread, [&](std::size_t from, std::size_t to) {
        std::vector<Index> patch;
        std::vector<double> values;
        for (std::size_t i = from; i < to; ++i) {
            const auto p = static_cast<Index>(i);
            if (examined.roughness[p].wide <= kBends) continue;
            widePatch(examined, p, patch);
            values.clear();
            for (const Index q : patch) {
                const Roughness& each = examined.roughness[q];
                if (each.wide > kBends) values.push_back(each.heaps.share);
            }
            around[i] = medianOf(values);
        }
    });
    return around;
}

/// The median of a value of the roughness at these points.
template <typename Value>
double medianAt(const ExaminedFile& examined, const std::vector<Index>& points, Value&& value) {
    std::vector<double> values(points.size());
    std::transform(points.begin(), points.end(), values.begin(),
                   [&](Index p) { return value(examined.roughness[p]); });
    return medianOf(values);
}

/// "0.26 spacings (0.0114)": also in the file's units.
std::string spacingsText(const ExaminedFile& examined, double spacings) {
    return shortNumber(spacings) + " spacings (" + shortNumber(spacings * examined.middleSpacing) +
           ")";
}

/// Distance of the points that are left, in heights of the surface.
constexpr double kThicknessesApart = 4.5;

/// "the rest are 4.5 times the height of the noise apart"
std::string surplusReason(const std::string& height) {
    return "the rest are " + shortNumber(kThicknessesApart) + " times " + height + " apart";
}

/// The points but for those that lie over or under points of a larger sheet. A sheet is linked by
/// heights under half the distance of the layers; noise may link both, and then all points stay.
std::vector<Index> ofLargerSheet(const ExaminedFile& examined, double apart,
                                 std::vector<Index> points) {
    constexpr std::size_t kLinks = 6;  // Farther ones are over it where the surface bends.
    const std::span<const Vec3> position = examined.file.position;
    std::vector<Vec3> normal(examined.size(), Vec3(0.0));
    std::vector<Index> patch;
    for (const Index p : points) {
        widePatch(examined, p, patch);
        normal[p] = planeNormalAt(position, p, std::span(patch).subspan(1));
    }
    const auto isOver = [&](Index p, Index q) {
        return std::abs(glm::dot(position[q] - position[p], normal[p])) >=
               0.5 * apart * examined.middleSpacing;
    };
    DisjointSets sheets(examined.size());
    for (const Index p : points) {
        const std::span<const Index> list = examined.nearest()[p];
        for (const Index q : list.first(std::min(kLinks, list.size()))) {
            if (!isOver(p, q) && !isOver(q, p)) sheets.unite(p, q);
        }
    }
    std::vector<std::size_t> size(examined.size(), 0);
    for (const Index p : points) ++size[sheets.find(p)];
    const auto rankOf = [&](Index p) { return std::pair(size[sheets.find(p)], sheets.find(p)); };
    std::erase_if(points, [&](Index p) {
        widePatch(examined, p, patch);
        return std::any_of(patch.begin(), patch.end(),
                           [&](Index q) { return isOver(p, q) && rankOf(q) > rankOf(p); });
    });
    return points;
}

/// Of these points those to leave out, so that the rest are 4.5 times as far apart as the surface
/// is thick: above that the rules find its triangles (docs/doctor.md). Of two layers with a gap
/// between them the smaller one is left out.
std::vector<Index> surplusOf(const ExaminedFile& examined, const std::vector<Index>& points,
                             double height) {
    const std::vector<Index> sheet =
        examined.layers ? ofLargerSheet(examined, examined.layers->apart, points) : points;
    std::vector<Index> surplus =
        thinnedOut(examined, sheet, kThicknessesApart * height * examined.middleSpacing);
    std::set_difference(points.begin(), points.end(), sheet.begin(), sheet.end(),
                        std::back_inserter(surplus));
    std::sort(surplus.begin(), surplus.end());
    return surplus;
}

/// The points of a region in which these lie: all, if they are more than half; else they and their
/// lists.
std::vector<Index> regionOf(const ExaminedFile& examined, const std::vector<Index>& points) {
    if (2 * points.size() > examined.presentCount) return examined.presentPoints();
    std::vector<bool> within(examined.size(), false);
    for (const Index p : points) {
        within[p] = true;
        for (const Index q : examined.nearest()[p]) within[q] = true;
    }
    return pointsWhere(examined.size(), [&](Index p) { return within[p]; });
}

}  // namespace

std::vector<Roughness> roughnessOf(const ExaminedFile& examined) {
    std::vector<Roughness> result(examined.size());
    forRanges(examined.size(), 0, kFitsPerThread, [&](std::size_t from, std::size_t to) {
        std::vector<Index> patch;
        for (std::size_t i = from; i < to; ++i) {
            const auto p = static_cast<Index>(i);
            if (!examined.present()[p] || examined.spacing[p] == 0.0) continue;
            smallPatch(examined, p, patch);
            if (const auto small = deviationFromQuadric(examined.file.position, patch))
                result[p].narrow = *small / examined.spacing[p];
            widePatch(examined, p, patch);
            const auto wide = heapsOverQuadric(examined.file.position, patch);
            if (!wide) continue;
            result[p].wide = wide->deviation / examined.spacing[p];
            result[p].heaps = wide->heaps;
            result[p].heaps.apart /= examined.spacing[p];
            result[p].heaps.within /= examined.spacing[p];
        }
    });
    return result;
}

std::optional<Layers> layersOf(const ExaminedFile& examined) {
    // Single surfaces with noise of any kind, and clean sets, stay below nearly everywhere.
    constexpr double kTwoHeaps = 0.835;
    constexpr std::size_t kLeastShare = 10;  // One in ten.
    constexpr double kDrawn = 0.79;
    if (examined.presentCount < kFewPoints) return std::nullopt;
    const std::vector<double> around = shareAroundAll(examined);
    const auto isCertain = [](double share) { return share > kTwoHeaps; };
    if (countWhere(around, isCertain) * kLeastShare <
        std::max<std::size_t>(examined.presentCount, 1))
        return std::nullopt;
    Layers layers;
    layers.points = pointsWhere(examined.size(), [&](Index p) { return around[p] > kDrawn; });
    const auto median = [&](auto&& value) { return medianAt(examined, layers.points, value); };
    // Layers stand over each other everywhere, thin parts and creases only in wide patches.
    constexpr double kEverywhere = 0.75;
    if (median([](const Roughness& each) { return each.narrow; }) <
        kEverywhere * median([](const Roughness& each) { return each.wide; }))
        return std::nullopt;
    layers.apart = median([](const Roughness& each) { return each.heaps.apart; });
    layers.noise = median([](const Roughness& each) { return each.heaps.within; });
    return layers;
}

std::optional<Finding> findTwoLayers(const ExaminedFile& examined) {
    const std::optional<Layers>& layers = examined.layers;
    if (!layers) return std::nullopt;
    std::vector<Index> surplus =
        surplusOf(examined, regionOf(examined, layers->points), layers->height());
    std::optional<Finding> finding =
        findingAt(layers->points, Severity::Warning,
                  "in two layers, about " + spacingsText(examined, layers->apart) + " apart");
    if (!finding) return finding;
    finding->surplus = std::move(surplus);
    finding->dropReason = surplusReason("the thickness of the layers");
    return finding;
}

std::optional<Finding> findNoise(const ExaminedFile& examined) {
    // Finely sampled surfaces stay below 0.08 spacings, coarse ones with creases below 0.11.
    constexpr double kNoticed = 0.12;
    // From here on triangles slope so much that the order of points about a point is chance.
    constexpr double kStrong = 0.3;
    std::vector<double> heights;
    for (const Roughness& each : examined.roughness) {
        if (each.narrow >= 0.0) heights.push_back(each.narrow);
    }
    if (heights.empty()) return std::nullopt;
    const std::optional<Layers>& layers = examined.layers;
    const double noise = layers ? layers->noise : medianOf(heights);
    if (noise < kNoticed) return std::nullopt;
    auto points = pointsWhere(examined.size(),
                              [&](Index p) { return examined.roughness[p].narrow >= kNoticed; });
    const std::size_t count = points.size();
    auto surplus = surplusOf(examined, regionOf(examined, layers ? layers->points : points),
                             layers ? layers->height() : noise);
    return Finding{
        nullptr,
        noise < kStrong || examined.presentCount < kFewPoints ? Severity::Note : Severity::Warning,
        count,
        std::move(points),
        "noise of " + spacingsText(examined, noise) + " along the normals, at " +
            counted(count, "point"),
        std::move(surplus),
        surplusReason(layers ? "the thickness of the layers" : "the height of the noise")};
}

}  // namespace se
