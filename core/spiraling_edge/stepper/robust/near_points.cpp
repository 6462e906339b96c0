#include "spiraling_edge/stepper/robust/near_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace se {

NearBall::NearBall(const PointSet& points, Index p) : center(points.position[p]), radius(0.0) {
    double farthestSq = 0.0;
    for (const Index q : points.neighbors[p]) {
        const Vec3 d = points.position[q] - center;
        farthestSq = std::max(farthestSq, glm::dot(d, d));
    }
    radius = std::sqrt(farthestSq);
}

namespace {

std::vector<bool> finitePoints(const PointSet& points) {
    std::vector<bool> finite(points.size());
    for (Index p = 0; p < points.size(); ++p) finite[p] = isFinite(points.position[p]);
    return finite;
}

}  // namespace

NearPoints::NearPoints(const PointSet& points)
    : points_(points), blocks_(points.position, finitePoints(points)), found_(points.size()) {}

std::uint32_t NearPoints::store(std::vector<Index> ball) const {
    constexpr std::size_t kMostStored = 64;
    if (ball.size() > kMostStored) return kMany;
    const std::lock_guard lock(storing_);
    stored_.push_back(std::move(ball));
    return static_cast<std::uint32_t>(kStored + stored_.size() - 1);
}

std::uint32_t NearPoints::findOut(Index p) const {
    std::vector<Index> ball;
    visitInBlocks(p, [&](Index q) { ball.push_back(q); });
    const auto ids = points_.neighbors[p];
    const bool holdsLast =
        ids.empty() || std::find(ball.begin(), ball.end(), ids.back()) != ball.end();
    const auto list = holdsLast ? ids : ids.first(ids.size() - 1);
    // The same points, if each is in both.
    const auto isListed = [&](Index q) {
        return q == p || std::find(list.begin(), list.end(), q) != list.end();
    };
    const bool isList =
        ball.size() == list.size() + 1 && std::all_of(ball.begin(), ball.end(), isListed);
    const std::uint32_t found =
        isList ? (holdsLast ? kList : kListButLast) : store(std::move(ball));
    found_[p].store(found, std::memory_order_release);
    return found;
}

}  // namespace se
