#include "spiraling_edge/mesh/boundary_loop.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

#include "spiraling_edge/base/disjoint_sets.h"

namespace se {
namespace {

/// A free sector wider than 120 degrees: the surface ends at the point.
constexpr double kEndCosine = -0.5;

bool isMost(std::size_t count, std::size_t all) { return 3 * count > 2 * all; }

/// True if the sector without triangles at a boundary point is wider than 120 degrees, seen along
/// its normal. It runs counterclockwise from the side that arrives to the one that leaves.
bool endsAt(const PointSet& points, const LoopSide& arriving, const LoopSide& leaving) {
    const Index p = leaving.from;
    const Vec3& normal = points.normal[p];
    const auto flat = [&](Index q) {
        const Vec3 d = points.position[q] - points.position[p];
        return d - glm::dot(d, normal) / glm::dot(normal, normal) * normal;
    };
    const Vec3 u = flat(arriving.from);
    const Vec3 v = flat(leaving.to);
    if (glm::dot(glm::cross(u, v), normal) < 0.0) return true;  // over 180 degrees
    return glm::dot(u, v) < kEndCosine * glm::length(u) * glm::length(v);
}

/// True if the surface ends at most points of the loop. A point that it passes twice is not
/// counted.
bool endsAtMost(const PointSet& points, std::span<const LoopSide> loop) {
    std::map<Index, std::vector<LoopSide>> arriving;
    std::map<Index, std::vector<LoopSide>> leaving;
    for (const LoopSide& side : loop) {
        leaving[side.from].push_back(side);
        arriving[side.to].push_back(side);
    }
    std::size_t ends = 0;
    for (const auto& [p, sides] : leaving) {
        const auto before = arriving.find(p);
        if (sides.size() != 1 || before == arriving.end() || before->second.size() != 1) continue;
        ends += endsAt(points, before->second.front(), sides.front()) ? 1U : 0U;
    }
    return isMost(ends, loop.size());
}

}  // namespace

std::vector<std::vector<TriangleSide>> connectedParts(const std::vector<TriangleSide>& border,
                                                      std::size_t points) {
    DisjointSets joined(points);
    for (const TriangleSide& side : border) joined.unite(side.low, side.high);
    std::map<Index, std::vector<TriangleSide>> parts;  // by least point
    for (const TriangleSide& side : border) parts[joined.find(side.low)].push_back(side);
    std::vector<std::vector<TriangleSide>> found;
    found.reserve(parts.size());
    for (auto& [least, sides] : parts) found.push_back(std::move(sides));
    return found;
}

std::vector<LoopSide> loopSidesOf(std::span<const TriangleSide> sides) {
    std::vector<LoopSide> loop;
    loop.reserve(sides.size());
    for (const TriangleSide& side : sides)
        loop.push_back(side.ascending ? LoopSide{side.low, side.high}
                                      : LoopSide{side.high, side.low});
    return loop;
}

LoopShape shapeOf(const PointSet& points, std::span<const LoopSide> loop) {
    assert(!loop.empty());
    const Vec3 origin = points.position[loop.front().from];
    ShapeSum sum;
    for (const LoopSide& side : loop) {
        sum.add(points.position[side.from] - origin, points.normal[side.from],
                points.position[side.to] - origin);
    }
    return sum.shape();
}

namespace {

/// True if most points of the loop have such a type, and no two others follow each other: a single
/// one bulges past the chord.
bool runsAlong(const PointSet& points, std::span<const LoopSide> loop, bool (*test)(std::uint8_t)) {
    const auto passes = [&](Index p) { return test(points.type[p]); };
    std::size_t count = 0;
    for (const LoopSide& side : loop) {
        if (!passes(side.from) && !passes(side.to)) return false;
        count += passes(side.from) ? 1U : 0U;
    }
    return isMost(count, loop.size());
}

}  // namespace

bool runsAlongWalls(const PointSet& points, std::span<const LoopSide> loop) {
    return runsAlong(points, loop, isOnWall);
}

bool isOpening(const PointSet& points, std::span<const LoopSide> loop, const LoopShape& shape) {
    const bool known = std::all_of(loop.begin(), loop.end(), [&](const LoopSide& side) {
        return points.normal[side.from] != Vec3(0.0);
    });
    if (!known || runsAlong(points, loop, isBoundary)) return true;
    return shape.widthInEdges() >= kNarrowestOpening && endsAtMost(points, loop);
}

}  // namespace se
