/// Points for the tests of the neighbor search, and lists found by comparing all pairs.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "spiraling_edge/prepare/prepare.h"

namespace se::test {

using Lists = std::vector<std::vector<Index>>;

inline Lists toVectors(const NeighborLists& lists) {
    Lists result;
    for (Index p = 0; p < lists.size(); ++p) result.emplace_back(lists[p].begin(), lists[p].end());
    return result;
}

/// Numbers in [0, 1) that are the same with every library.
class Numbers {
  public:
    double next() { return static_cast<double>(engine_() >> 8U) / 16777216.0; }
    Vec3 nextVector() {
        const double x = next();
        const double y = next();
        return {x, y, next()};
    }

  private:
    std::mt19937 engine_{7};
};

struct OraclePoints {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    std::vector<bool> usable;
};

inline OraclePoints makeRandom(std::size_t count) {
    OraclePoints points;
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i) {
        points.position.push_back(numbers.nextVector());
        points.normal.push_back(glm::normalize(numbers.nextVector() - Vec3(0.5)));
        points.usable.push_back(numbers.next() < 0.9);
    }
    return points;
}

/// An exact lattice: every distance occurs many times. Normals point up and down in stripes.
inline OraclePoints makeLattice(int side) {
    OraclePoints points;
    for (int i = 0; i < side * side * side; ++i) {
        points.position.emplace_back(i % side, i / side % side, i / side / side);
        points.normal.emplace_back(0, 0, i % 3 == 0 ? -1 : 1);
    }
    points.usable.assign(points.position.size(), true);
    return points;
}

inline NeighborOptions nearest(std::size_t k, bool dropOpposing) {
    return {KNearest{k}, dropOpposing, false};
}
inline NeighborOptions within(double radius, bool dropOpposing) {
    return {WithinRadius{radius}, dropOpposing, false};
}

/// The nearest of point p that agree, by comparing it with all others.
inline std::vector<Index> agreeingList(const OraclePoints& points, const NeighborOptions& options,
                                       Index p) {
    const auto squared = [&](Index q) {
        const Vec3 d = points.position[q] - points.position[p];
        return d.x * d.x + d.y * d.y + d.z * d.z;
    };
    std::vector<Index> list;
    for (Index q = 0; q < points.position.size(); ++q) {
        const bool counts = points.usable[p] && points.usable[q] &&
                            points.position[q] != points.position[p] && std::isfinite(squared(q));
        if (counts) list.push_back(q);
    }
    std::stable_sort(list.begin(), list.end(),
                     [&](Index a, Index b) { return squared(a) < squared(b); });
    const auto* radius = std::get_if<WithinRadius>(&options.reach);
    const std::size_t k = radius ? list.size() : std::get<KNearest>(options.reach).k;
    if (!radius && options.dropOpposingNormals) list.resize(std::min(list.size(), 8 * k + 64));
    std::erase_if(list, [&](Index q) {
        return (radius && squared(q) > radius->radius * radius->radius) ||
               (options.dropOpposingNormals && glm::dot(points.normal[p], points.normal[q]) <= 0.0);
    });
    list.resize(std::min(list.size(), k));
    return list;
}

/// The list of point p specified for findNeighbors(): where fewer than three agree, also those that
/// oppose and have as few.
inline std::vector<Index> bruteForceList(const OraclePoints& points, const NeighborOptions& options,
                                         Index p) {
    const auto* nearest = std::get_if<KNearest>(&options.reach);
    const std::size_t enough = nearest ? std::min<std::size_t>(3, nearest->k) : 3;
    const auto isShort = [&](Index q) { return agreeingList(points, options, q).size() < enough; };
    const std::vector<Index> own = agreeingList(points, options, p);
    if (!options.dropOpposingNormals || own.size() >= enough) return own;
    NeighborOptions all = options;
    all.dropOpposingNormals = false;
    std::vector<Index> list = agreeingList(points, all, p);
    const auto isOwn = [&](Index q) { return std::find(own.begin(), own.end(), q) != own.end(); };
    std::erase_if(list, [&](Index q) { return !isOwn(q) && !isShort(q); });
    for (const Index q : own) {
        if (std::find(list.begin(), list.end(), q) == list.end()) list.push_back(q);
    }
    return list;
}

/// The result specified for findNeighbors(), by comparing all pairs.
inline Lists bruteForce(const OraclePoints& points, const NeighborOptions& options) {
    Lists lists;
    for (Index p = 0; p < points.position.size(); ++p)
        lists.push_back(bruteForceList(points, options, p));
    return lists;
}

}  // namespace se::test
