/// The points near a point, for the searches of the repairs.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <glm/geometric.hpp>
#include <mutex>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/point_blocks.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// A ball about a point, as far as the farthest in its list.
struct NearBall {
    NearBall(const PointSet& points, Index p);

    Vec3 center;
    double radius;
};

/// The points in the balls of points. Those on another sheet are among them, which are in no list
/// here. The first search about a point goes through all blocks near it; later ones take O(points
/// found). For most points these are the point and its list, so that nothing is stored.
class NearPoints {
  public:
    /// The points must outlive it.
    explicit NearPoints(const PointSet& points);

    /// Calls visit(q) for each point in the ball of `p`, in any order. May be called from several
    /// threads.
    template <typename Visit>
    void visitBall(Index p, Visit&& visit) const {
        const std::uint32_t known = found_[p].load(std::memory_order_acquire);
        const std::uint32_t found = known == kUnknown ? findOut(p) : known;
        if (found == kMany) return visitInBlocks(p, visit);
        if (found >= kStored) {
            for (const Index q : stored(found - kStored)) visit(q);
            return;
        }
        const auto ids = points_.neighbors[p];
        visit(p);
        for (const Index q : found == kList ? ids : ids.first(ids.size() - 1)) visit(q);
    }

  private:
    // What is in the ball of a point:
    static constexpr std::uint32_t kUnknown = 0;
    static constexpr std::uint32_t kMany = 1;         ///< Points that are not worth storing.
    static constexpr std::uint32_t kList = 2;         ///< The point and its list.
    static constexpr std::uint32_t kListButLast = 3;  ///< As the radius was rounded down.
    static constexpr std::uint32_t kStored = 4;       ///< From here on: a position in `stored_`.

    /// visitBall() without what is known.
    template <typename Visit>
    void visitInBlocks(Index p, Visit&& visit) const {
        const NearBall ball(points_, p);
        blocks_.forPointsWithin(ball.center, ball.radius * ball.radius, visit);
    }
    std::uint32_t findOut(Index p) const;
    std::uint32_t store(std::vector<Index> ball) const;
    std::span<const Index> stored(std::uint32_t place) const {
        const std::lock_guard lock(storing_);
        return stored_[place];
    }

    const PointSet& points_;
    PointBlocks blocks_;
    mutable std::vector<std::atomic<std::uint32_t>> found_;
    mutable std::deque<std::vector<Index>> stored_;  ///< Elements stay in place.
    mutable std::mutex storing_;
};

}  // namespace se
