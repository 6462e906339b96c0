/// The shift of positions that are written as floats (STL): an origin with few digits near the
/// center of the mesh. It is the coarsest of a few powers of ten under which rounding to float
/// moves no corner by more than a thousandth of the mean edge, or the best of them. O(triangles).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "spiraling_edge/io/formats.h"

namespace se::io {
namespace {

/// Exponents of the smallest and largest step of a shift.
constexpr int kLeastExponent = -30;
constexpr int kHighestExponent = 30;

/// 10^|exponent|; only multiplications, so that it is the same on every machine.
double powerOfTen(int exponent) {
    double power = 1.0;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10.0;
    return power;
}

/// The multiple of 10^exponent nearest to `value`, never -0. Powers below 1 divide, so that the
/// result is the double nearest to the decimal number.
double rounded(double value, int exponent) {
    const double power = powerOfTen(exponent);
    const double result =
        exponent < 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return result == 0.0 ? 0.0 : result;
}

/// The least exponent whose power of ten is not below `length`.
int exponentOf(double length) {
    int exponent = kLeastExponent;
    const auto power = [](int e) { return e < 0 ? 1.0 / powerOfTen(e) : powerOfTen(e); };
    while (exponent < kHighestExponent && power(exponent) < length) ++exponent;
    return exponent;
}

/// The corners of the triangles: mean length of the edges, and the box.
struct Corners {
    double spacing = 0.0;
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};

    Corners(std::span<const Vec3> position, std::span<const Triangle> triangles) {
        double sum = 0.0;
        for (const Triangle& t : triangles) {
            const std::array<Vec3, 3> corner{position[t.a], position[t.b], position[t.c]};
            for (std::size_t i = 0; i < 3; ++i) {
                sum += glm::length(corner[(i + 1) % 3] - corner[i]);
                low = glm::min(low, corner[i]);
                high = glm::max(high, corner[i]);
            }
        }
        if (!triangles.empty()) spacing = sum / static_cast<double>(3 * triangles.size());
    }
    double extent() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

/// The largest error by rounding to float of a corner's coordinate relative to `shift`.
double worstRounding(std::span<const Vec3> position, std::span<const Triangle> triangles,
                     const Vec3& shift) {
    double worst = 0.0;
    for (const Triangle& t : triangles) {
        for (const Index corner : {t.a, t.b, t.c}) {
            const Vec3 place = position[corner] - shift;
            for (int i = 0; i < 3; ++i)
                worst = std::max(worst, std::abs(asFloat(place[i]) - place[i]));
        }
    }
    return worst;
}

}  // namespace

double asFloat(double value) {
    // volatile: GCC 12 vectorizes "to float and back" and drops it.
    volatile float narrow = static_cast<float>(value);
    return static_cast<double>(narrow);
}

std::optional<Vec3> floatShift(const PointFile& points, std::span<const Triangle> triangles) {
    constexpr double kSharpness = 1000.0;  // Parts of the spacing that must survive.
    constexpr int kMaxTries = 4;
    const Corners corners(points.position, triangles);
    const double allowed = corners.spacing / kSharpness;
    if (!(allowed > 0.0) || !std::isfinite(corners.spacing)) return std::nullopt;
    double best = worstRounding(points.position, triangles, Vec3(0.0));
    if (best <= allowed) return std::nullopt;
    std::optional<Vec3> shift;
    const Vec3 middle = 0.5 * (corners.low + corners.high);
    int exponent = exponentOf(corners.extent());
    for (int i = 0; i < kMaxTries && best > allowed; ++i, --exponent) {
        Vec3 tried;
        for (int axis = 0; axis < 3; ++axis) tried[axis] = rounded(middle[axis], exponent);
        const double left = worstRounding(points.position, triangles, tried);
        if (left >= best) continue;
        best = left;
        shift = tried;
    }
    return shift;
}

}  // namespace se::io
