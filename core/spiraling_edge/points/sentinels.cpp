#include "spiraling_edge/points/sentinels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "spiraling_edge/base/median.h"

namespace se {
namespace {

// ---- shared values: those of several points along one axis, below or above all others -----------

/// Points whose coordinate along an axis is the least of all, or the greatest.
struct SharedValue {
    Vec3::length_type axis = 0;
    double value = 0.0;
    std::vector<Index> points;  ///< Ascending.
    double gap = 0.0;           ///< To the nearest value of the other points,
    double range = 0.0;         ///< which reach this far.
};
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

/// The shared value of the points marked No; nothing where all have it. `sign`: 1 for the least, -1
/// for the greatest.
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

/// True if the gap to the value is wider than the others reach along any axis: no ground below them
/// is so far away.
bool isFarOff(std::span<const Vec3> position, std::span<const Aside> aside,
              const SharedValue& shared) {
    Vec3 low(kInfinite);
    Vec3 high(-kInfinite);
    for (const Index p : othersThan(position, aside, shared)) {
        low = glm::min(low, position[p]);
        high = glm::max(high, position[p]);
    }
    const Vec3 extent = high - low;
    return shared.gap > std::max({extent.x, extent.y, extent.z});
}

/// True if the others have no gap along the axis that is nearly as wide as that to the value: they
/// are no levels of one kind. O(points log points).
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

/// True if the coordinates of all points marked No are whole numbers, as of pixels.
bool areWhole(std::span<const Vec3> position, std::span<const Aside> aside) {
    for (std::size_t p = 0; p < position.size(); ++p) {
        if (aside[p] == Aside::No && glm::floor(position[p]) != position[p]) return false;
    }
    return true;
}

/// True if points with such a value lie scattered among the others, seen along the axis: in the
/// order of the file and in space. Those of a plane lie beside each other.
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

/// True if all points marked No are a raster, seen along the axis.
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

// ---- sentinels ----------------------------------------------------------------------------------

constexpr double kHuge = 1e30;  ///< No coordinate is so great.

/// True for 10,000, 100,000 and so on, which planes of a scene may have too.
bool isRound(double value) {
    const double size = std::abs(value);
    return size < kHuge && size == std::pow(10.0, std::round(std::log10(size)));
}

/// True if files have this value where there is none: 999, 9999 and so on, a power of ten from
/// 10,000, a power of two from 32,768, or one less than that, or any from 1e30; with either sign.
bool isNamedSentinel(double value) {
    constexpr double kLeastOfTen = 1e3;
    constexpr double kLeastOfTwo = 32768.0;
    const double size = std::abs(value);
    if (size >= kHuge) return true;
    if (!(size >= kLeastOfTen - 1.0) || size == kLeastOfTen) return false;
    for (const double power : {size, size + 1.0}) {
        int exponent = 0;
        if (power >= kLeastOfTwo && std::frexp(power, &exponent) == 0.5) return true;
        if (isRound(power)) return true;
    }
    return false;
}

/// The middle of the values of an axis, and how far they reach.
struct ValueRange {
    double middle = 0.0;
    double span = 0.0;
};

/// The range of nine in ten of the values, without named sentinels, unless most are. Changes their
/// order.
ValueRange valueRangeOf(std::vector<double>& values) {
    constexpr double kOutside = 0.05;
    const auto named = std::partition(values.begin(), values.end(),
                                      [](double value) { return !isNamedSentinel(value); });
    if (2 * (named - values.begin()) >= static_cast<std::ptrdiff_t>(values.size()))
        values.erase(named, values.end());
    if (values.empty()) return {};
    const double low = quantileOf(values, kOutside);
    const double high = quantileOf(values, 1.0 - kOutside);
    return {low + 0.5 * (high - low), high - low};
}

/// True for values that only stand for a missing one: 999, 9999 and so on, -32768 and -32767, any
/// from 1e30.
bool isNeverMeasured(double value) {
    constexpr double kLeastOfTwo = -32768.0;
    return isNamedSentinel(value) && !isRound(value) &&
           (isRound(std::abs(value) + 1.0) || value == kLeastOfTwo || value == kLeastOfTwo + 1.0 ||
            std::abs(value) >= kHuge);
}

/// True if a value that the points share stands for a missing one.
bool isMissing(std::span<const Vec3> position, const std::vector<Aside>& aside,
               const SharedValue& shared, std::size_t used) {
    constexpr double kApart = 0.25;  // Of the range of the others.
    constexpr double kFarApart = 2.0;
    const std::size_t count = shared.points.size();
    const bool few = count < kSentinelLimits.copies || 2 * count > used;
    // A level plane beside another one is none.
    if (few || !(shared.range > 0.0) || shared.gap < kApart * shared.range) return false;
    if (isNeverMeasured(shared.value)) return true;
    if (!isApart(position, aside, shared)) return false;
    constexpr double kMostScattered = 0.3;  // A floor has more.
    const bool farOff = isFarOff(position, aside, shared);
    const bool mayScatter =
        static_cast<double>(count) <= kMostScattered * static_cast<double>(used) &&
        (farOff || isNamedSentinel(shared.value));
    if (mayScatter && isScattered(position, aside, shared)) return true;
    // 0 as a camera has no depth.
    const bool mayBeRaster = farOff || shared.gap > kFarApart * shared.range ||
                             (shared.value == 0.0 && areWhole(position, aside));
    return mayBeRaster && isRaster(position, aside, shared);
}

/// Marks points with a coordinate that stands for a missing value along one axis, below or above
/// all others.
void markSharedValues(std::span<const Vec3> position, std::size_t used, std::vector<Aside>& aside) {
    constexpr int kMost = 3;  // Different ones, each on the far side of the next.
    for (Vec3::length_type axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            for (int found = 0; found < kMost; ++found) {
                const auto shared = sharedValueOf(position, aside, axis, sign);
                if (!shared || !isMissing(position, aside, *shared, used)) break;
                for (Index p = 0; p < position.size(); ++p) {
                    if (position[p][axis] == shared->value) aside[p] = Aside::Sentinel;
                }
            }
        }
    }
}

/// Marks points with a coordinate far off; not those of a round value that several share.
void markFarValues(std::span<const Vec3> position, std::vector<Aside>& aside) {
    constexpr std::size_t kSampled = 4096;
    const std::size_t step = std::max<std::size_t>(1, position.size() / kSampled);
    std::array<ValueRange, 3> ranges;
    double span = 0.0;
    for (Vec3::length_type axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t p = 0; p < position.size(); p += step) {
            if (aside[p] == Aside::No) values.push_back(position[p][axis]);
        }
        ValueRange& range = ranges[static_cast<std::size_t>(axis)];
        range = valueRangeOf(values);
        span = std::max(span, range.span);
    }
    if (!(span > 0.0)) return;
    std::vector<Index> unnamed;
    for (Index p = 0; p < position.size(); ++p) {
        if (aside[p] == Aside::NotFinite) continue;
        bool isFar = false;
        for (Vec3::length_type axis = 0; axis < 3; ++axis) {
            const double value = position[p][axis];
            const double off = std::abs(value - ranges[static_cast<std::size_t>(axis)].middle);
            if (isNamedSentinel(value) && !isRound(value) && off > kSentinelLimits.farNamed * span)
                aside[p] = Aside::Sentinel;
            isFar = isFar || off > kSentinelLimits.far * span;
        }
        if (isFar && aside[p] != Aside::Sentinel) unnamed.push_back(p);
    }
    if (unnamed.size() > kSentinelLimits.mostUnnamed) return;
    for (const Index p : unnamed) aside[p] = Aside::Sentinel;
}

/// The squares of the distances from p to the nearest points at other places, ascending, and the
/// nearest of these.
struct Nearest {
    std::array<double, 3> squares;
    Index point = kNone;
};
Nearest nearestOf(std::span<const Vec3> position, const std::vector<Aside>& aside, Index p) {
    Nearest nearest;
    nearest.squares.fill(std::numeric_limits<double>::infinity());
    for (Index q = 0; q < position.size(); ++q) {
        if (q == p || aside[q] != Aside::No) continue;
        const Vec3 d = position[p] - position[q];
        const double square = glm::dot(d, d);
        if (!(square < nearest.squares.back()) || position[p] == position[q]) continue;
        if (square < nearest.squares.front()) nearest.point = q;
        nearest.squares.back() = square;
        std::sort(nearest.squares.begin(), nearest.squares.end());
    }
    return nearest;
}

bool isFarPlace(std::span<const Vec3> position, const std::vector<Aside>& aside, Index p) {
    const Nearest here = nearestOf(position, aside, p);
    if (here.point == kNone) return false;
    const Nearest there = nearestOf(position, aside, here.point);
    return std::sqrt(here.squares.front()) >
           kSentinelLimits.farPlace * std::sqrt(there.squares.back());
}

/// The points to examine: those with the most copies.
std::vector<Index> sharedPlaces(std::span<const Vec3> position, const std::vector<Aside>& aside,
                                std::span<const Index> original) {
    constexpr std::size_t kMost = 8;
    std::vector<Index> copies(position.size(), 0);
    for (Index p = 0; p < position.size(); ++p) {
        if (aside[p] == Aside::Copy) ++copies[original[p]];
    }
    std::vector<Index> places;
    std::size_t single = 0;
    std::size_t shared = 0;
    for (Index p = 0; p < position.size(); ++p) {
        if (aside[p] != Aside::No) continue;
        ++(copies[p] == 0 ? single : shared);
        if (copies[p] + 1 >= kSentinelLimits.copies) places.push_back(p);
    }
    if (static_cast<double>(shared) >
        kSentinelLimits.mostShared * static_cast<double>(single + shared))
        return {};
    std::stable_sort(places.begin(), places.end(),
                     [&](Index a, Index b) { return copies[a] > copies[b]; });
    if (places.size() > kMost) places.resize(kMost);
    return places;
}

}  // namespace

void markSentinels(std::span<const Vec3> position, std::span<const Index> original,
                   std::vector<Aside>& aside) {
    assert(aside.size() == position.size() && original.size() == position.size());
    const auto used = static_cast<std::size_t>(std::count(aside.begin(), aside.end(), Aside::No));
    if (used < kSentinelLimits.leastPoints) return;
    markFarValues(position, aside);
    markSharedValues(position, used, aside);
    std::vector<Index> far;
    for (const Index p : sharedPlaces(position, aside, original)) {
        if (isFarPlace(position, aside, p)) far.push_back(p);
    }
    for (Index p = 0; p < position.size() && !far.empty(); ++p) {
        if (std::find(far.begin(), far.end(), original[p]) != far.end()) aside[p] = Aside::Sentinel;
    }
}

}  // namespace se
