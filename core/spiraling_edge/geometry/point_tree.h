/// A k-d tree of points, to find those within a distance of a place whatever their spacing.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// A balanced k-d tree (Bentley 1975): each part of the points is divided at the median of its
/// longest side. Points with a coordinate that is not finite are left out.
class PointTree {
  public:
    /// O(n log n).
    explicit PointTree(std::span<const Vec3> position) {
        node_.reserve(position.size());
        for (Index p = 0; p < position.size(); ++p) {
            const Vec3& x = position[p];
            if (std::isfinite(x.x + x.y + x.z)) node_.push_back({x, p});
        }
        divide(0, node_.size());
    }

    /// Calls `visit` with each point that is at most this far away, in an order that depends on the
    /// positions alone.
    template <typename Visit>
    void within(const Vec3& place, double distance, Visit&& visit) const {
        search(0, node_.size(), place, distance, visit);
    }

  private:
    /// A point of a part; the middle one of a part divides it.
    struct Node {
        Vec3 place;
        Index point;
        int axis = 0;  ///< That the middle one divides.
    };

    /// Parts of at most this many points are not divided.
    static constexpr std::size_t kLeaf = 8;

    void divide(std::size_t begin, std::size_t end) {
        if (end - begin <= kLeaf) return;
        Vec3 low = node_[begin].place;
        Vec3 high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = glm::min(low, node_[i].place);
            high = glm::max(high, node_[i].place);
        }
        const Vec3 side = high - low;
        const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) {
            return node_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(middle), at(end), [&](const Node& a, const Node& b) {
            const double x = a.place[axis];
            const double y = b.place[axis];
            return x < y || (x == y && a.point < b.point);
        });
        node_[middle].axis = axis;
        divide(begin, middle);
        divide(middle + 1, end);
    }

    template <typename Visit>
    void search(std::size_t begin, std::size_t end, const Vec3& place, double distance,
                Visit& visit) const {
        const auto test = [&](const Node& node) {
            const Vec3 d = node.place - place;
            if (glm::dot(d, d) <= distance * distance) visit(node.point);
        };
        if (end - begin <= kLeaf) {
            for (std::size_t i = begin; i < end; ++i) test(node_[i]);
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        const int axis = node_[middle].axis;
        const double offset = place[axis] - node_[middle].place[axis];
        if (offset <= distance) search(begin, middle, place, distance, visit);
        test(node_[middle]);
        if (offset >= -distance) search(middle + 1, end, place, distance, visit);
    }

    std::vector<Node> node_;  ///< The finite points, together where they are searched.
};

}  // namespace se
