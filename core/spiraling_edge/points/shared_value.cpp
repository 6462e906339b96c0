/// O(points), with a factor of up to 64 for the distances of samples.
#include "spiraling_edge/points/shared_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "spiraling_edge/base/median.h"

namespace se {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The other two axes.
std::array<Vec3::length_type, 2> across(Vec3::length_type axis) {
    return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

/// Along the axis, the distances of a point to the nearest usable one, and to the nearest that
/// shares its value.
struct SeenAlong {
    double any = kInfinite;
    double same = kInfinite;
};
SeenAlong seenAlong(std::span<const Vec3> position, std::span<const Aside> aside,
                    Vec3::length_type axis, Index p) {
    const auto [u, v] = across(axis);
    SeenAlong seen;
    for (Index q = 0; q < position.size(); ++q) {
        if (aside[q] != Aside::No || q == p) continue;
        const double distance =
            std::hypot(position[q][u] - position[p][u], position[q][v] - position[p][v]);
        seen.any = std::min(seen.any, distance);
        if (position[q][axis] == position[p][axis]) seen.same = std::min(seen.same, distance);
    }
    return seen;
}

/// About this many of the points, spread over their order.
std::vector<Index> samplesOf(const std::vector<Index>& points) {
    constexpr std::size_t kSamples = 32;
    const std::size_t step = std::max<std::size_t>(1, points.size() / kSamples);
    std::vector<Index> samples;
    for (std::size_t i = 0; i < points.size(); i += step) samples.push_back(points[i]);
    return samples;
}

std::vector<Index> othersThan(std::span<const Vec3> position, std::span<const Aside> aside,
                              const SharedValue& shared) {
    std::vector<Index> others;
    for (Index p = 0; p < position.size(); ++p) {
        if (aside[p] == Aside::No && position[p][shared.axis] != shared.value) others.push_back(p);
    }
    return others;
}

/// The middle and the spread of points along an axis.
struct Spread {
    double mean = 0.0;
    double deviation = 0.0;
};
Spread spreadOf(std::span<const Vec3> position, const std::vector<Index>& points,
                Vec3::length_type axis) {
    const auto count = static_cast<double>(points.size());
    Spread spread;
    for (const Index p : points) spread.mean += position[p][axis] / count;
    double square = 0.0;
    for (const Index p : points) {
        const double off = position[p][axis] - spread.mean;
        square += off * off / count;
    }
    spread.deviation = std::sqrt(square);
    return spread;
}

/// True if the points can be some of the others, taken by chance. Of a few only a wide spread tells
/// something: the feet of a table stand at its corners.
bool areSpreadAlike(std::span<const Vec3> position, const std::vector<Index>& points,
                    const std::vector<Index>& others, Vec3::length_type axis) {
    constexpr std::size_t kFew = 8;
    constexpr double kAside = 0.5;
    constexpr double kNarrow = 0.6;
    constexpr double kWide = 1.4;  // The corners of a square have 1.7.
    const bool few = points.size() < kFew;
    const auto axes = across(axis);
    return std::all_of(axes.begin(), axes.end(), [&](Vec3::length_type each) {
        const Spread some = spreadOf(position, points, each);
        const Spread all = spreadOf(position, others, each);
        const bool narrow = std::abs(some.mean - all.mean) > kAside * all.deviation ||
                            some.deviation < kNarrow * all.deviation;
        return some.deviation <= kWide * all.deviation && (few || !narrow);
    });
}

}  // namespace

std::optional<SharedValue> sharedValueOf(std::span<const Vec3> position,
                                         std::span<const Aside> aside, Vec3::length_type axis,
                                         double sign) {
    SharedValue shared{axis, kInfinite, {}};
    double next = kInfinite;
    double last = -kInfinite;
    for (Index p = 0; p < position.size(); ++p) {
        if (aside[p] != Aside::No) continue;
        const double value = sign * position[p][axis];
        last = std::max(last, value);
        if (value < shared.value) {
            next = shared.value;
            shared.value = value;
            shared.points.clear();
        }
        if (value == shared.value) {
            shared.points.push_back(p);
        } else {
            next = std::min(next, value);
        }
    }
    if (next == kInfinite) return std::nullopt;
    shared.gap = next - shared.value;
    shared.range = last - next;
    shared.value *= sign;
    return shared;
}

bool isApart(std::span<const Vec3> position, std::span<const Aside> aside,
             const SharedValue& shared) {
    constexpr double kWide = 3.0;
    std::vector<double> values;
    for (const Index p : othersThan(position, aside, shared))
        values.push_back(position[p][shared.axis]);
    std::sort(values.begin(), values.end());
    double widest = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i)
        widest = std::max(widest, values[i] - values[i - 1]);
    return shared.gap > kWide * widest;
}

bool areWhole(std::span<const Vec3> position, std::span<const Aside> aside) {
    for (std::size_t p = 0; p < position.size(); ++p) {
        if (aside[p] == Aside::No && glm::floor(position[p]) != position[p]) return false;
    }
    return true;
}

bool isScattered(std::span<const Vec3> position, std::span<const Aside> aside,
                 const SharedValue& shared) {
    std::size_t runs = 0;
    for (std::size_t i = 0; i < shared.points.size(); ++i)
        runs += i == 0 || shared.points[i] != shared.points[i - 1] + 1 ? 1U : 0U;
    if (2 * runs < shared.points.size()) return false;
    if (!areSpreadAlike(position, shared.points, othersThan(position, aside, shared), shared.axis))
        return false;
    constexpr double kApart = 1.5;
    std::vector<double> any;
    std::vector<double> same;
    for (const Index p : samplesOf(shared.points)) {
        const SeenAlong seen = seenAlong(position, aside, shared.axis, p);
        any.push_back(seen.any);
        same.push_back(seen.same);
    }
    return medianOf(same) > kApart * medianOf(any);
}

bool isRaster(std::span<const Vec3> position, std::span<const Aside> aside,
              const SharedValue& shared) {
    constexpr double kEven = 0.01;
    constexpr double kMost = 0.8;
    std::vector<double> nearest;
    for (const auto& points : {shared.points, othersThan(position, aside, shared)}) {
        for (const Index p : samplesOf(points))
            nearest.push_back(seenAlong(position, aside, shared.axis, p).any);
    }
    const double step = medianOf(nearest);
    const auto even = std::count_if(nearest.begin(), nearest.end(), [&](double distance) {
        return std::abs(distance - step) <= kEven * step;
    });
    return step > 0.0 && static_cast<double>(even) >= kMost * static_cast<double>(nearest.size());
}

}  // namespace se
