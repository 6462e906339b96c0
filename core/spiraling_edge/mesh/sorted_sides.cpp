/// A counting sort by the lower point; the few sides of a point are then inserted in order. O(t)
/// for t triangles, but for points in many of them.
#include "spiraling_edge/mesh/sorted_sides.h"

#include <cassert>
#include <numeric>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/parallel.h"

namespace se {
namespace {

/// Fewer are not worth a thread.
constexpr std::size_t kLeastPoints = 16384;

bool precedes(const TriangleSide& x, const TriangleSide& y) {
    return x.high != y.high ? x.high < y.high : x.triangle < y.triangle;
}

/// Fits TriangleSide::triangle. The mask only avoids a warning about narrowing.
constexpr Index kTriangleBits = 0x7fffffffU;

/// Calls visit(side) for each side, by ascending triangle.
template <typename Visit>
void forEachSide(std::span<const Triangle> triangles, Visit&& visit) {
    for (Index i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}})
            visit(TriangleSide{std::min(u, v), std::max(u, v), i & kTriangleBits, u < v ? 1U : 0U});
    }
}

}  // namespace

std::vector<TriangleSide> sortedSides(std::span<const Triangle> triangles, unsigned threads) {
    assert(triangles.size() <= kNone / 3);
    Index last = 0;
    forEachSide(triangles, [&](const TriangleSide& side) { last = std::max(last, side.low); });
    const std::size_t points = std::size_t{last} + 1;
    // Every thread passes over all sides, but takes only those of its points.
    const auto forEachPiece = [&](auto&& work) {
        forRanges(points, threads, kLeastPoints, [&](std::size_t from, std::size_t to) {
            work([from, to](const TriangleSide& side) { return side.low >= from && side.low < to; },
                 from, to);
        });
    };
    std::vector<Index> place(points + 1, 0);  // Of the next side of each point.
    forEachPiece([&](auto&& isMine, std::size_t, std::size_t) {
        forEachSide(triangles, [&](const TriangleSide& side) {
            if (isMine(side)) ++place[side.low + std::size_t{1}];
        });
    });
    std::partial_sum(place.begin(), place.end(), place.begin());
    std::vector<TriangleSide> sides(3 * triangles.size());
    forEachPiece([&](auto&& isMine, std::size_t from, std::size_t to) {
        std::size_t begin = place[from];
        forEachSide(triangles, [&](const TriangleSide& side) {
            if (isMine(side)) sides[place[side.low]++] = side;
        });
        for (std::size_t p = from; p < to; ++p) {
            // Each place has moved on to the end of its point.
            const std::size_t end = place[p];
            std::sort(sides.data() + begin, sides.data() + end, precedes);
            begin = end;
        }
    });
    return sides;
}

std::vector<Index> nonManifoldPoints(std::span<const Triangle> triangles,
                                     std::span<const TriangleSide> sides, std::size_t points) {
    // A corner is one triangle at one of its points; corners at a point are joined across edges.
    const auto cornerOf = [&](Index triangle, Index point) {
        const Triangle& t = triangles[triangle];
        const Index k = t.a == point ? 0U : (t.b == point ? 1U : 2U);
        return 3 * triangle + k;
    };
    DisjointSets corners(3 * triangles.size());
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (!sides[i].sameEdge(sides[i - 1])) continue;
        for (const Index point : {sides[i].low, sides[i].high}) {
            corners.unite(cornerOf(sides[i - 1].triangle, point),
                          cornerOf(sides[i].triangle, point));
        }
    }
    std::vector<Index> fans(points, 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const auto first = static_cast<Index>(3 * i);
        if (corners.find(first) == first) ++fans[t.a];
        if (corners.find(first + 1) == first + 1) ++fans[t.b];
        if (corners.find(first + 2) == first + 2) ++fans[t.c];
    }
    std::vector<Index> found;
    for (std::size_t p = 0; p < points; ++p) {
        if (fans[p] > 1) found.push_back(static_cast<Index>(p));
    }
    return found;
}

}  // namespace se
