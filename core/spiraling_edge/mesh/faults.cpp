/// Faults by sorted sides: edge faults come from the sides of all triangles sorted by edge; for
/// pairs see fault_pairs.cpp.
#include "spiraling_edge/mesh/faults.h"

#include <algorithm>
#include <cassert>
#include <mutex>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/mesh/fault_pairs.h"
#include "spiraling_edge/mesh/sorted_sides.h"

namespace se {
namespace {

/// Fewer triangles, or sides, are not worth a thread.
constexpr std::size_t kItemsPerThread = 16384;

/// Calls find(from, to, found) for consecutive pieces of `count` items, in threads, and appends
/// what it finds to `all`.
template <typename Find>
void gatherFaults(std::size_t count, unsigned threads, std::vector<Fault>& all, Find&& find) {
    std::mutex access;
    forRanges(count, threads, kItemsPerThread, [&](std::size_t from, std::size_t to) {
        std::vector<Fault> found;
        find(from, to, found);
        const std::lock_guard<std::mutex> lock(access);
        all.insert(all.end(), found.begin(), found.end());
    });
}

/// The faults of an edge. `usable`: per triangle, 1 if it has an area.
void findEdgeFaults(std::span<const TriangleSide> edge, const PointSet& points,
                    std::span<const Triangle> triangles, std::span<const std::uint8_t> usable,
                    std::vector<Fault>& found) {
    const auto add = [&](FaultKind kind, Index a, Index b) {
        found.push_back({kind, std::min(a, b), std::max(a, b)});
    };
    for (std::size_t i = 1; i < edge.size(); ++i) {
        if (edge.size() > 2) add(FaultKind::NonManifoldEdge, edge[0].triangle, edge[i].triangle);
        if (edge[i].ascending == edge[i - 1].ascending)
            add(FaultKind::InconsistentEdge, edge[i - 1].triangle, edge[i].triangle);
    }
    if (edge.size() != 2 || edge[0].ascending == edge[1].ascending) return;
    const Index a = edge[0].triangle;
    const Index b = edge[1].triangle;
    if (usable[a] != 0 && usable[b] != 0 && folded(points, triangles[a], triangles[b]))
        add(FaultKind::Folded, a, b);
}

FaultSearch searchMesh(const PointSet& points, std::span<const Triangle> triangles,
                       std::span<const TriangleSide> sides, unsigned threads, bool withPairs) {
    std::vector<std::uint8_t> usable(triangles.size(), 1);  // Bytes, for several threads.
    std::vector<Fault> all;
    gatherFaults(triangles.size(), threads, all,
                 [&](std::size_t from, std::size_t to, std::vector<Fault>& found) {
                     for (auto i = static_cast<Index>(from); i < to; ++i) {
                         if (isDegenerate(points, triangles[i])) {
                             usable[i] = 0;
                             found.push_back({FaultKind::Degenerate, i, kNone});
                         } else if (isFlipped(points, triangles[i])) {
                             found.push_back({FaultKind::Flipped, i, kNone});
                         }
                     }
                 });
    gatherFaults(sides.size(), threads, all,
                 [&](std::size_t from, std::size_t to, std::vector<Fault>& found) {
                     forEachEdge(sidesOfRange(sides, from, to),
                                 [&](std::span<const TriangleSide> edge) {
                                     findEdgeFaults(edge, points, triangles, usable, found);
                                 });
                 });
    FaultSearch result{{}, false, 0};
    if (withPairs) {
        result =
            searchPairs(points, triangles, usable, PairLimits::ofMesh(triangles.size()), threads);
    }
    result.faults.insert(result.faults.end(), all.begin(), all.end());
    sortUnique(result.faults);
    return result;
}

}  // namespace

FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles) {
    return searchFaults(points, triangles, sortedSides(triangles));
}

FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles,
                         std::span<const TriangleSide> sides, unsigned threads) {
    assert(cornersBelow(triangles, points.size()) && haveFinitePositions(points, triangles));
    return searchMesh(points, triangles, sides, threads, true);
}

std::vector<Fault> findFaults(const PointSet& points, std::span<const Triangle> triangles) {
    return searchFaults(points, triangles).faults;
}

FaultSearch searchLocalFaults(const PointSet& points, std::span<const Triangle> triangles,
                              std::span<const TriangleSide> sides) {
    return searchMesh(points, triangles, sides, 0, false);
}

std::array<std::size_t, kFaultKinds> countFaults(std::span<const Fault> faults) {
    std::array<std::size_t, kFaultKinds> counts{};
    for (const Fault& fault : faults) ++counts[static_cast<std::size_t>(fault.kind)];
    return counts;
}

}  // namespace se
