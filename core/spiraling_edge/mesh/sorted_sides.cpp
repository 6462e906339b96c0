/// A counting sort by the lower point; the few sides of a point are then inserted in order. O(t)
/// for t triangles, but for points in many of them.
#include "spiraling_edge/mesh/sorted_sides.h"

#include <numeric>
#include <tuple>

#include "spiraling_edge/base/disjoint_sets.h"

namespace se {
namespace {

bool precedes(const TriangleSide& x, const TriangleSide& y) {
    return std::tie(x.high, x.triangle) < std::tie(y.high, y.triangle);
}

/// Calls visit(side) for each side, by ascending triangle.
template <typename Visit>
void forEachSide(std::span<const Triangle> triangles, Visit&& visit) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}})
            visit(TriangleSide{std::min(u, v), std::max(u, v), static_cast<Index>(i), u < v});
    }
}

}  // namespace

std::vector<TriangleSide> sortedSides(std::span<const Triangle> triangles) {
    Index last = 0;
    forEachSide(triangles, [&](const TriangleSide& side) { last = std::max(last, side.low); });
    std::vector<Index> place(std::size_t{last} + 2, 0);  // Of the next side of each point.
    forEachSide(triangles, [&](const TriangleSide& side) { ++place[side.low + std::size_t{1}]; });
    std::partial_sum(place.begin(), place.end(), place.begin());
    std::vector<TriangleSide> sides(3 * triangles.size());
    forEachSide(triangles, [&](const TriangleSide& side) { sides[place[side.low]++] = side; });
    auto begin = sides.begin();
    while (begin != sides.end()) {
        // Each place has moved on to the end of its point.
        const auto end = sides.begin() + place[begin->low];
        std::sort(begin, end, precedes);
        begin = end;
    }
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
