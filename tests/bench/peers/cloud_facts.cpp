#include "cloud_facts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <stdexcept>

#include "spiraling_edge/prepare/prepare.h"

namespace se::peers {
namespace {

/// The root of p's tree, with path halving.
Index rootOf(std::vector<Index>& parent, Index p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
}

bool opposesNormals(const PointFile& points, const Triangle& t) {
    const Vec3& a = points.position[t.a];
    const Vec3 area = glm::cross(points.position[t.b] - a, points.position[t.c] - a);
    return glm::dot(area, points.normal[t.a] + points.normal[t.b] + points.normal[t.c]) < 0.0;
}

}  // namespace

NeighborLists nearestLists(const PointFile& points, std::size_t count) {
    NeighborOptions options;
    options.reach = KNearest{count};
    options.dropOpposingNormals = false;
    const std::vector<bool> usable(points.position.size(), true);
    auto lists = findNeighbors(points.position, {}, usable, options);
    if (!lists) throw std::runtime_error(lists.error().message);
    return std::move(lists.value());
}

double meanSpacing(const PointFile& points) {
    const NeighborLists nearest = nearestLists(points, 1);
    double sum = 0.0;
    std::size_t count = 0;
    for (Index p = 0; p < nearest.size(); ++p) {
        if (nearest[p].empty()) continue;
        sum += glm::length(points.position[nearest[p][0]] - points.position[p]);
        ++count;
    }
    if (count == 0) throw std::runtime_error("no two points at different places");
    return sum / static_cast<double>(count);
}

Vec3 extent(const PointFile& points) {
    Vec3 low = points.position.front();
    Vec3 high = low;
    for (const Vec3& p : points.position) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return high - low;
}

void orientEach(const PointFile& points, std::vector<Triangle>& triangles) {
    for (Triangle& t : triangles)
        if (opposesNormals(points, t)) std::swap(t.b, t.c);
}

void orientPieces(const PointFile& points, std::vector<Triangle>& triangles) {
    std::vector<Index> parent(points.position.size());
    std::iota(parent.begin(), parent.end(), Index{0});
    for (const Triangle& t : triangles) {
        parent[rootOf(parent, t.b)] = rootOf(parent, t.a);
        parent[rootOf(parent, t.c)] = rootOf(parent, t.a);
    }
    std::vector<long long> votes(parent.size(), 0);
    for (const Triangle& t : triangles)
        votes[rootOf(parent, t.a)] += opposesNormals(points, t) ? -1 : 1;
    for (Triangle& t : triangles)
        if (votes[rootOf(parent, t.a)] < 0) std::swap(t.b, t.c);
}

}  // namespace se::peers
