#include "component_shape.h"

#include <algorithm>

namespace se::view {

namespace {

constexpr std::uint64_t edgeKey(Index from, Index to) { return std::uint64_t{from} << 32U | to; }

}  // namespace

ComponentShape shapeOf(const Model& model, std::span<const Triangle> triangles, std::size_t begin) {
    ComponentShape shape;
    shape.begin = begin;
    shape.end = begin + triangles.size();
    glm::dvec3 sum(0.0);
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        sum += glm::dvec3(model.place[t.a]);
        edges.insert(edges.end(), {edgeKey(t.a, t.b), edgeKey(t.b, t.c), edgeKey(t.c, t.a)});
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
    return shape;
}

const ComponentShape* shapeAt(std::span<const ComponentShape> shapes, std::uint32_t pivot) {
    const auto found = std::lower_bound(
        shapes.begin(), shapes.end(), pivot,
        [](const ComponentShape& shape, std::uint32_t wanted) { return shape.pivot < wanted; });
    return found != shapes.end() && found->pivot == pivot ? &*found : nullptr;
}

}  // namespace se::view
