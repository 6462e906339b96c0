/// A k-d tree of points, to find those within a distance of a place whatever their spacing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// A balanced k-d tree (Bentley 1975): each part of the points is divided at the median of its
/// longest side. Points with a coordinate that is not finite are left out.
class PointTree {
  public:
    using Positions = std::span<const Vec3>;

    /// O(n log n).
    explicit PointTree(Positions position) {
        for (Index p = 0; p < position.size(); ++p) {
            const Vec3& x = position[p];
            if (std::isfinite(x.x + x.y + x.z)) order_.push_back(p);
        }
        axis_.resize(order_.size());
        divide(position, 0, order_.size());
        place_.reserve(order_.size());
        for (const Index p : order_) place_.push_back(position[p]);
    }

    /// Calls `visit` with each point that is at most this far away, in an order that depends on the
    /// positions alone.
    template <typename Visit>
    void within(const Vec3& place, double distance, Visit&& visit) const {
        search(0, order_.size(), place, distance, visit);
    }

  private:
    /// Parts of at most this many points are not divided.
    static constexpr std::size_t kLeaf = 8;

    void divide(Positions position, std::size_t begin, std::size_t end) {
        if (end - begin <= kLeaf) return;
        Vec3 low = position[order_[begin]];
        Vec3 high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = glm::min(low, position[order_[i]]);
            high = glm::max(high, position[order_[i]]);
        }
        const Vec3 side = high - low;
        const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) {
            return order_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
            const double x = position[a][axis];
            const double y = position[b][axis];
            return x < y || (x == y && a < b);
        });
        axis_[middle] = static_cast<std::uint8_t>(axis);
        divide(position, begin, middle);
        divide(position, middle + 1, end);
    }

    template <typename Visit>
    void search(std::size_t begin, std::size_t end, const Vec3& place, double distance,
                Visit& visit) const {
        const auto test = [&](std::size_t i) {
            const Vec3 d = place_[i] - place;
            if (glm::dot(d, d) <= distance * distance) visit(order_[i]);
        };
        if (end - begin <= kLeaf) {
            for (std::size_t i = begin; i < end; ++i) test(i);
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        const int axis = axis_[middle];
        const double offset = place[axis] - place_[middle][axis];
        if (offset <= distance) search(begin, middle, place, distance, visit);
        test(middle);
        if (offset >= -distance) search(middle + 1, end, place, distance, visit);
    }

    std::vector<Index> order_;        ///< The finite points; the middle one of a part divides it.
    std::vector<Vec3> place_;         ///< Their positions, together where they are searched.
    std::vector<std::uint8_t> axis_;  ///< Of the middle of a part: the axis that it divides.
};

}  // namespace se
