/// Sorting of a few neighbors without branches that depend on them.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <span>

#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

/// Maximum number of neighbors that rankSort() takes.
inline constexpr std::size_t kMaxRanked = 64;

/// Copies neighbors to `to`, each to the place that is the number of nearer ones, counted by
/// comparing all pairs of rounded distances. Those with equal ones lie side by side.
template <std::size_t Width>
void placeByRank(std::span<const Neighbor> from, double scale, Neighbor* to) {
    std::array<float, Width> key;
    for (std::size_t i = 0; i < from.size(); ++i)
        key[i] = static_cast<float>(from[i].distanceSquared * scale);
    std::fill(key.begin() + static_cast<std::ptrdiff_t>(from.size()), key.end(), 0.0F);
    std::array<std::int32_t, Width> rank{};
    for (std::size_t j = 0; j < from.size(); ++j) {
        const float nearer = key[j];
        for (std::size_t i = 0; i < Width; ++i) rank[i] += nearer < key[i] ? 1 : 0;
    }
    std::uint64_t taken = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        auto place = static_cast<std::size_t>(rank[i]);
        while ((taken >> place & 1U) != 0) ++place;
        taken |= std::uint64_t{1} << place;
        to[place] = from[i];
    }
}

/// Copies neighbors to `to` in the order of lists. Requires at most kMaxRanked of them, at
/// distances whose squares are at most `bound`.
inline void rankSort(std::span<const Neighbor> from, double bound, Neighbor* to) {
    assert(from.size() <= kMaxRanked);
    // No key is infinite or not a number; where keys vanish, the pass below does all the work.
    const double scale = 1.0 / std::max(bound, std::numeric_limits<double>::min());
    if (from.size() <= 16) {
        placeByRank<16>(from, scale, to);
    } else if (from.size() <= 24) {
        placeByRank<24>(from, scale, to);
    } else if (from.size() <= 32) {
        placeByRank<32>(from, scale, to);
    } else {
        placeByRank<kMaxRanked>(from, scale, to);
    }
    // Rounding kept the order, but for neighbors that it made equal.
    for (std::size_t i = 1; i < from.size(); ++i) {
        const Neighbor moved = to[i];
        std::size_t place = i;
        for (; place > 0 && moved < to[place - 1]; --place) to[place] = to[place - 1];
        to[place] = moved;
    }
}

}  // namespace se
