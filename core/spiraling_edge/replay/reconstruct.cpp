/// A run over points along a Z-curve takes the same steps with fewer cache misses: half the time
/// for large sets in random order. Results are translated back; the renumbering costs O(points +
/// list entries).
#include "spiraling_edge/replay/reconstruct.h"

#include <algorithm>

#include "spiraling_edge/base/prefetch.h"
#include "spiraling_edge/geometry/z_curve.h"

namespace se {
namespace {

/// Below this the data of a run fit the caches, and renumbering costs more than it saves.
constexpr std::size_t kManyPoints = 100'000;

/// True if most of a thousand sample points are far in memory from their nearest neighbor.
bool areScattered(const PointSet& points) {
    constexpr std::size_t kSamples = 1024;
    const std::size_t far = points.size() / 64;
    std::size_t asked = 0;
    std::size_t scattered = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const auto p = static_cast<Index>(i * points.size() / kSamples);
        const auto list = points.neighbors[p];
        if (list.empty()) continue;
        const std::size_t apart = p > list[0] ? p - list[0] : list[0] - p;
        ++asked;
        scattered += apart > far ? 1U : 0U;
    }
    return 2 * scattered > asked;
}

std::vector<Index> inverse(const std::vector<Index>& permutation) {
    std::vector<Index> result(permutation.size());
    for (std::size_t i = 0; i < permutation.size(); ++i) {
        result[permutation[i]] = static_cast<Index>(i);
    }
    return result;
}

template <typename T>
std::vector<T> permuted(const std::vector<T>& values, const std::vector<Index>& original) {
    std::vector<T> result;
    result.reserve(values.size());
    for (const Index i : original) result.push_back(values[i]);
    return result;
}

void restore(std::vector<Triangle>& triangles, const std::vector<Index>& original) {
    for (Triangle& t : triangles) t = {original[t.a], original[t.b], original[t.c]};
}

/// The lists of the points in their new order, and by their new indices.
NeighborLists renumbered(const NeighborLists& lists, const std::vector<Index>& original,
                         const std::vector<Index>& place) {
    // Lists are scattered in memory: those needed soon are prefetched.
    constexpr std::size_t kSoon = 8;
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
        end = std::transform(list.begin(), list.end(), end, [&](Index q) { return place[q]; });
        made.offset.push_back(static_cast<std::uint32_t>(end - made.ids.begin()));
    }
    return made;
}

/// The gaps of the points in their new order, and by their new indices.
std::vector<RimGap> renumbered(const std::vector<RimGap>& rim, const std::vector<Index>& original,
                               const std::vector<Index>& place) {
    std::vector<RimGap> made(rim.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        const RimGap& gap = rim[original[i]];
        if (gap.known()) made[i] = {place[gap.from], place[gap.to]};
    }
    return made;
}

}  // namespace

Renumbered renumberAlongZCurve(const PointSet& points) {
    Renumbered result;
    result.original = zCurveOrder(points.position);
    const std::vector<Index>& original = result.original;
    const std::vector<Index> place = inverse(original);
    PointSet& made = result.points;
    made.position = permuted(points.position, original);
    made.normal = permuted(points.normal, original);
    made.type = permuted(points.type, original);
    made.neighbors = renumbered(points.neighbors, original, place);
    made.rim = renumbered(points.rim, original, place);
    made.order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) made.order.push_back(place[points.inOrder(i)]);
    return result;
}

void restoreIndices(const Renumbered& renumbered, State& state) {
    const std::vector<Index>& original = renumbered.original;
    state.status = permuted(state.status, inverse(original));
    restore(state.triangles, original);
    std::vector<Triangle> mesh = state.repair.triangles.take();
    restore(mesh, original);
    state.repair.triangles = std::move(mesh);
    state.repair.nearOf = nullptr;
    for (Index& p : state.done) p = original[p];
    for (Alert& alert : state.alerts) {
        if (alert.point != kNone) alert.point = original[alert.point];
    }
}

Reconstruction reconstruct(const PointSet& points, const Params& params,
                           const StopCondition& stop) {
    const auto run = [&](const PointSet& set) {
        Stepper stepper(set, params);
        const StopReason reason = stop ? stepper.runUntil(stop) : stepper.run();
        return Reconstruction{stepper.takeState(), reason};
    };
    // What-ifs name points by their index.
    const bool asIs = !params.whatIf.empty() || points.size() < kManyPoints;
    if (asIs || !areScattered(points)) return run(points);
    const Renumbered renumbered = renumberAlongZCurve(points);
    Reconstruction result = run(renumbered.points);
    restoreIndices(renumbered, result.state);
    return result;
}

}  // namespace se
