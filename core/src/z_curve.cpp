#include "z_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace se {
namespace {

constexpr unsigned kBits = 21;  // per axis; three fit into 63 bits
constexpr std::uint64_t kLast = ~std::uint64_t{0};

bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Puts two zeros between each two of the lowest 21 bits.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32U) & 0x001f00000000ffffU;
    x = (x | x << 16U) & 0x001f0000ff0000ffU;
    x = (x | x << 8U) & 0x100f00f00f00f00fU;
    x = (x | x << 4U) & 0x10c30c30c30c30c3U;
    return (x | x << 2U) & 0x1249249249249249U;
}

struct Coded {
    std::uint64_t code;
    Index point;
};

std::vector<Coded> codesOf(std::span<const Vec3> position) {
    Vec3 low(std::numeric_limits<double>::max());
    Vec3 high(std::numeric_limits<double>::lowest());
    for (const Vec3& p : position) {
        if (!isFinite(p)) continue;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // Halves, so that a box from lowest to max does not overflow; a step is a little wider than
    // the side's 2^21st part, so that the far end stays within.
    const Vec3 half = 0.5 * high - 0.5 * low;
    const double side = std::max({half.x, half.y, half.z, std::numeric_limits<double>::min()});
    constexpr double kSteps = (1U << kBits) - 1U;
    std::vector<Coded> coded(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
        std::uint64_t code = kLast;
        if (isFinite(position[i])) {
            const Vec3 place = (0.5 * position[i] - 0.5 * low) / side * kSteps;
            const auto step = [](double x) { return spread(static_cast<std::uint64_t>(x)); };
            code = step(place.x) | step(place.y) << 1U | step(place.z) << 2U;
        }
        coded[i] = {code, static_cast<Index>(i)};
    }
    return coded;
}

/// Stable sort by code, a few bits at a time from the lowest.
void radixSort(std::vector<Coded>& coded) {
    constexpr unsigned kDigit = 11;
    constexpr std::size_t kBuckets = std::size_t{1} << kDigit;
    std::vector<Coded> other(coded.size());
    for (unsigned shift = 0; shift < 64; shift += kDigit) {
        const auto digit = [shift](const Coded& c) { return (c.code >> shift) & (kBuckets - 1); };
        std::array<std::size_t, kBuckets + 1> begin{};
        for (const Coded& c : coded) ++begin[digit(c) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        for (const Coded& c : coded) other[begin[digit(c)]++] = c;
        coded.swap(other);
    }
}

}  // namespace

std::vector<Index> zCurveOrder(std::span<const Vec3> position) {
    std::vector<Coded> coded = codesOf(position);
    radixSort(coded);
    std::vector<Index> order(coded.size());
    std::transform(coded.begin(), coded.end(), order.begin(),
                   [](const Coded& c) { return c.point; });
    return order;
}

}  // namespace se
