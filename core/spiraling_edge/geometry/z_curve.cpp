/// Coordinates in 2^10 steps per axis are interleaved to a 30-bit code; for a Gray-code curve, its
/// rank among such codes is taken. Codes are packed with the index into 64 bits and sorted by a
/// radix sort in three passes. O(points).
#include "spiraling_edge/geometry/z_curve.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>

#include "spiraling_edge/points/wall_types.h"

namespace se {
namespace {

/// Steps per axis: 2^10. A surface passes through some 3 million of the cells, which is fine enough
/// for tens of millions of points.
constexpr unsigned kBits = 10;
constexpr std::uint64_t kNowhere = (std::uint64_t{1} << 3 * kBits) - 1;

/// Puts two zeros between each two of the lowest 10 bits.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 16U) & 0x030000ffU;
    x = (x | x << 8U) & 0x0300f00fU;
    x = (x | x << 4U) & 0x030c30c3U;
    return (x | x << 2U) & 0x09249249U;
}

/// The code of a point's place on the curve in the upper half, its index in the lower.
using Coded = std::uint64_t;

/// The place of a code of 30 bits among all Gray codes, turned so that kNowhere stays the last.
std::uint64_t rankOfGray(std::uint64_t code) {
    code ^= kNowhere >> 1U;
    for (unsigned shift = 1; shift < 3 * kBits; shift *= 2) code ^= code >> shift;
    return code;
}

/// `placeOf`: the place on the curve of a point's code on the Z-curve.
template <typename PlaceOf>
std::vector<Coded> codesOf(std::span<const Vec3> position, const PlaceOf& placeOf) {
    const WallBox box = boxAround(position);
    // Halves, so that a box from lowest to max does not overflow; the last step of an axis is left
    // to positions that are not finite.
    const Vec3 half = 0.5 * box.high - 0.5 * box.low;
    const double side = std::max({half.x, half.y, half.z, std::numeric_limits<double>::min()});
    constexpr double kSteps = (1U << kBits) - 2U;
    std::vector<Coded> coded(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
        std::uint64_t code = kNowhere;
        if (isFinite(position[i])) {
            const Vec3 place = (0.5 * position[i] - 0.5 * box.low) / side * kSteps;
            const auto step = [](double x) { return spread(static_cast<std::uint64_t>(x)); };
            code = placeOf(step(place.x) | step(place.y) << 1U | step(place.z) << 2U);
        }
        coded[i] = code << 32U | i;
    }
    return coded;
}

/// Stable sort by code, a third of it at a time from the lowest.
void radixSort(std::vector<Coded>& coded) {
    constexpr std::size_t kBuckets = std::size_t{1} << kBits;
    std::vector<Coded> other(coded.size());
    for (unsigned shift = 32; shift < 32 + 3 * kBits; shift += kBits) {
        const auto digit = [shift](Coded c) { return (c >> shift) & (kBuckets - 1); };
        std::array<std::size_t, kBuckets + 1> begin{};
        for (const Coded c : coded) ++begin[digit(c) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        for (const Coded c : coded) other[begin[digit(c)]++] = c;
        coded.swap(other);
    }
}

std::vector<Index> inOrder(std::vector<Coded> coded) {
    radixSort(coded);
    std::vector<Index> order(coded.size());
    std::transform(coded.begin(), coded.end(), order.begin(),
                   [](Coded c) { return static_cast<Index>(c & 0xffffffffU); });
    return order;
}

}  // namespace

std::vector<Index> zCurveOrder(std::span<const Vec3> position) {
    return inOrder(codesOf(position, [](std::uint64_t code) { return code; }));
}

std::vector<Index> grayCurveOrder(std::span<const Vec3> position) {
    return inOrder(codesOf(position, rankOfGray));
}

}  // namespace se
