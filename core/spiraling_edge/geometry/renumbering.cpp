#include "spiraling_edge/geometry/renumbering.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "spiraling_edge/base/prefetch.h"
#include "spiraling_edge/geometry/z_curve.h"

namespace se {

bool areScattered(const NeighborLists& lists) {
    constexpr std::size_t kManyPoints = 100'000;
    constexpr std::size_t kSamples = 1024;
    if (lists.size() < kManyPoints) return false;
    const std::size_t far = lists.size() / 64;
    std::size_t asked = 0;
    std::size_t scattered = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const auto p = static_cast<Index>(i * lists.size() / kSamples);
        const auto list = lists[p];
        if (list.empty()) continue;
        const std::size_t apart = p > list[0] ? p - list[0] : list[0] - p;
        ++asked;
        scattered += apart > far ? 1U : 0U;
    }
    return 2 * scattered > asked;
}

Numbering numberingAlongZCurve(std::span<const Vec3> position) {
    std::vector<Index> original = zCurveOrder(position);
    std::vector<Index> place = inverse(original);
    return {std::move(original), std::move(place)};
}

std::vector<Index> inverse(std::span<const Index> permutation) {
    std::vector<Index> result(permutation.size());
    for (std::size_t i = 0; i < permutation.size(); ++i)
        result[permutation[i]] = static_cast<Index>(i);
    return result;
}

NeighborLists renumbered(const NeighborLists& lists, const Numbering& numbering) {
    // Lists are scattered in memory: those needed soon are prefetched.
    constexpr std::size_t kSoon = 8;
    const std::vector<Index>& original = numbering.original;
    const auto ahead = [&](std::size_t i) { return original[std::min(i, original.size() - 1)]; };
    NeighborLists made;
    made.offset.reserve(lists.offset.size());
    made.ids.resize(lists.ids.size());
    auto end = made.ids.begin();
    for (std::size_t i = 0; i < original.size(); ++i) {
        prefetch(&lists.offset[ahead(i + 2 * kSoon)]);
        const auto soon = lists[ahead(i + kSoon)];
        prefetch(soon.data());
        prefetch(soon.data() + soon.size());
        const auto list = lists[original[i]];
        end = std::transform(list.begin(), list.end(), end,
                             [&](Index q) { return numbering.place[q]; });
        made.offset.push_back(static_cast<std::uint32_t>(end - made.ids.begin()));
    }
    return made;
}

OrderedPoints::OrderedPoints(std::span<const Vec3> position, const NeighborLists& lists)
    : position_(position), lists_(&lists) {
    renumberIfScattered();
}

OrderedPoints::OrderedPoints(std::span<const Vec3> position, NeighborLists&& lists)
    : ownLists_(std::move(lists)), position_(position), lists_(&ownLists_) {
    renumberIfScattered();
}

void OrderedPoints::renumberIfScattered() {
    if (!areScattered(*lists_)) return;
    numbering_ = numberingAlongZCurve(position_);
    ownPosition_ = permuted(position_, numbering_.original);
    position_ = ownPosition_;
    ownLists_ = se::renumbered(*lists_, numbering_);
    lists_ = &ownLists_;
}

std::vector<Vec3> OrderedPoints::renumbered(std::vector<Vec3> values) const {
    return numbering_.original.empty() ? std::move(values) : permuted(values, numbering_.original);
}

std::vector<Vec3> OrderedPoints::restored(std::vector<Vec3> values) const {
    return numbering_.place.empty() ? std::move(values) : permuted(values, numbering_.place);
}

}  // namespace se
