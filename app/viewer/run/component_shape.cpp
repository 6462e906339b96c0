#include "component_shape.h"

#include <algorithm>

#include "spiraling_edge/base/disjoint_sets.h"

namespace se::view {

namespace {

constexpr std::uint64_t edgeKey(Index from, Index to) { return std::uint64_t{from} << 32U | to; }

/// Number of distinct values.
std::size_t countDifferent(std::vector<Index>& points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points.size();
}

/// Pieces of the rim: points joined by its edges belong to one piece.
std::size_t countLoops(std::span<const std::array<Index, 2>> rim) {
    std::vector<Index> points;
    for (const auto& edge : rim) points.insert(points.end(), {edge[0], edge[1]});
    std::size_t loops = countDifferent(points);
    DisjointSets pieces(points.size());
    const auto placeOf = [&](Index point) {
        const auto found = std::lower_bound(points.begin(), points.end(), point);
        return static_cast<Index>(found - points.begin());
    };
    for (const auto& [from, to] : rim) {
        if (pieces.unite(placeOf(from), placeOf(to))) --loops;
    }
    return loops;
}

}  // namespace

ComponentShape shapeOf(const Model& model, std::span<const Triangle> triangles, std::size_t begin) {
    ComponentShape shape;
    shape.begin = begin;
    shape.end = begin + triangles.size();
    glm::dvec3 sum(0.0);
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * triangles.size());
    std::vector<Index> corners;
    corners.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        sum += glm::dvec3(model.place[t.a]);
        edges.insert(edges.end(), {edgeKey(t.a, t.b), edgeKey(t.b, t.c), edgeKey(t.c, t.a)});
        corners.insert(corners.end(), {t.a, t.b, t.c});
    }
    if (!triangles.empty()) shape.middle = sum / static_cast<double>(triangles.size());
    std::sort(edges.begin(), edges.end());
    for (const std::uint64_t edge : edges) {
        const auto from = static_cast<Index>(edge >> 32U);
        const auto to = static_cast<Index>(edge);
        if (!std::binary_search(edges.begin(), edges.end(), edgeKey(to, from))) {
            shape.rim.push_back({from, to});
        }
    }
    shape.points = countDifferent(corners);
    shape.loops = countLoops(shape.rim);
    return shape;
}

const ComponentShape* shapeAt(std::span<const ComponentShape> shapes, std::uint32_t pivot) {
    const auto found = std::lower_bound(
        shapes.begin(), shapes.end(), pivot,
        [](const ComponentShape& shape, std::uint32_t wanted) { return shape.pivot < wanted; });
    return found != shapes.end() && found->pivot == pivot ? &*found : nullptr;
}

}  // namespace se::view
