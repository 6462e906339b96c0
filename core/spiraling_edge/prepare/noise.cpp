/// Thinning by a greedy choice: each point gets the mean plane of its patch; points near the middle
/// of the noise are chosen first, and each sets aside the listed points over and under it. O(points
/// log points + list entries).
#include "spiraling_edge/prepare/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "spiraling_edge/base/median.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/base/two_heaps.h"

namespace se {
namespace {

/// Least distance of points that are kept, in widths of the noise.
constexpr double kApartSpacings = 2.0;
/// Height over or under a point within which another counts as the same place of the surface, in
/// widths.
constexpr double kReach = 6.0;
/// Number of neighbors: farther ones lie higher wherever the surface bends.
constexpr std::size_t kNearest = 12;
/// Heights are of two sheets if their distance explains this share of the variance, and is at least
/// this many spacings; a sheet has at least kOfSheet of the points. Of nearer sheets the lists of a
/// point hold as many points of either.
constexpr double kSheetsShare = 0.85;
constexpr double kSheetsApart = 1.0;
constexpr std::size_t kOfSheet = 4;

/// Least number of points per thread.
constexpr std::size_t kPatchesPerThread = 2048;

NoisePatch patchOf(std::span<const Vec3> position, std::span<const Vec3> normal,
                   std::span<const Index> list, Index p) {
    NoisePatch patch;
    Vec3 middle = position[p];
    Vec3 sum = normal[p];
    for (const Index x : list) {
        middle += position[x];
        sum += normal[x];
    }
    const double count = 1.0 + static_cast<double>(list.size());
    middle /= count;
    const double length = glm::length(sum);
    patch.normal = length > 0.0 ? sum / length : normal[p];
    double squares = 0.0;
    const auto heightOf = [&](Index x) { return glm::dot(position[x] - middle, patch.normal); };
    for (const Index x : list) squares += heightOf(x) * heightOf(x);
    patch.height = std::abs(heightOf(p));
    patch.width = std::sqrt((squares + patch.height * patch.height) / count);
    return patch;
}

/// Root mean square of the heights of a list over the tangent plane of p, in spacings; of sheets
/// that are apart, of those on the sheet of p.
double heightInSpacings(std::span<const Vec3> position, const Vec3& normal,
                        std::span<const Index> list, Index p, Sheets sheets) {
    std::array<double, kNearest + 1> heights{};  // The last one is that of p.
    for (std::size_t i = 0; i < list.size(); ++i)
        heights[i] = glm::dot(position[list[i]] - position[p], normal);
    std::span<double> own(heights.data(), list.size() + 1);
    const double spacing = glm::distance(position[sixthOf(list)], position[p]);
    const TwoHeaps heaps = sheets == Sheets::Apart ? twoHeapsOf(own) : TwoHeaps{};
    if (heaps.share >= kSheetsShare && heaps.apart >= kSheetsApart * spacing) {
        const bool onLower = heaps.cut > 0.0;
        const std::size_t count = onLower ? heaps.lower : own.size() - heaps.lower;
        if (count >= kOfSheet) own = onLower ? own.first(count) : own.last(count);
    }
    double squares = 0.0;
    for (const double height : own) squares += height * height;
    return std::sqrt(squares / static_cast<double>(own.size() - 1)) / spacing;
}

}  // namespace

double noiseAlongNormals(std::span<const Vec3> position, std::span<const Vec3> normal,
                         const NeighborLists& neighbors, Sheets sheets, unsigned threads) {
    constexpr double kNoList = -1.0;
    std::vector<double> ratios(position.size(), kNoList);
    forEachItem(position.size(), threads, kPatchesPerThread, [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        const auto list = neighbors[p].first(std::min(kNearest, neighbors[p].size()));
        if (!list.empty()) ratios[i] = heightInSpacings(position, normal[p], list, p, sheets);
    });
    std::erase(ratios, kNoList);
    return ratios.empty() ? 0.0 : medianOf(ratios);
}

std::vector<NoisePatch> noisePatches(std::span<const Vec3> position, std::span<const Vec3> normal,
                                     const NeighborLists& lists, const std::vector<bool>& usable,
                                     unsigned threads) {
    std::vector<NoisePatch> patches(position.size());
    forEachItem(position.size(), threads, kPatchesPerThread, [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        if (usable[p]) patches[p] = patchOf(position, normal, lists[p], p);
    });
    return patches;
}

std::size_t setNoiseAside(std::span<const Vec3> position, std::span<const NoisePatch> patches,
                          const NeighborLists& lists, std::vector<bool>& usable) {
    std::vector<Index> order;
    for (Index p = 0; p < position.size(); ++p) {
        if (usable[p]) order.push_back(p);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return patches[a].height < patches[b].height; });
    std::size_t aside = 0;
    std::vector<bool> chosen(position.size(), false);
    for (const Index p : order) {
        if (!usable[p]) continue;
        chosen[p] = true;
        const NoisePatch& here = patches[p];
        const double apart = kApartSpacings * here.width;
        for (const Index x : lists[p]) {
            if (!usable[x] || chosen[x]) continue;
            const Vec3 offset = position[x] - position[p];
            const double height = glm::dot(offset, here.normal);
            const double alongSq = glm::dot(offset, offset) - height * height;
            if (alongSq >= apart * apart || std::abs(height) > kReach * here.width) continue;
            usable[x] = false;
            ++aside;
        }
    }
    return aside;
}

}  // namespace se
