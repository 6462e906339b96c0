/// A k-d tree of points, to find those within a distance of a place whatever their spacing.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <mutex>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// A balanced k-d tree (Bentley 1975): each part of the points is divided at the median of its
/// longest side. A part is divided when it is first searched, since most meshes need searches in a
/// few places only: the whole tree takes O(n log n), one place O(n). Points with a coordinate that
/// is not finite are left out.
class PointTree {
  public:
    explicit PointTree(std::span<const Vec3> position) : axis_(position.size()) {
        node_.reserve(position.size());
        for (Index p = 0; p < position.size(); ++p) {
            const Vec3& x = position[p];
            if (std::isfinite(x.x + x.y + x.z)) node_.push_back({x, p});
        }
    }

    /// Calls `visit` with each point that is at most this far away, in an order that depends on the
    /// positions alone. May be called from several threads.
    template <typename Visit>
    void within(const Vec3& place, double distance, Visit&& visit) const {
        search(0, node_.size(), place, distance, visit);
    }

  private:
    /// A point of a part; the middle one of a part divides it.
    struct Node {
        Vec3 place;
        Index point;
    };
    /// The side of a part that its middle point divides, in the place of that point.
    enum class Axis : std::int8_t { Undivided, X, Y, Z };

    /// Parts of at most this many points are not divided.
    static constexpr std::size_t kLeaf = 8;

    /// Divides the part unless that is done. Returns its axis: 0, 1 or 2.
    int divided(std::size_t begin, std::size_t end) const {
        std::atomic<Axis>& axis = axis_[begin + (end - begin) / 2];
        if (axis.load(std::memory_order_acquire) == Axis::Undivided) {
            const std::lock_guard lock(dividing_);
            if (axis.load(std::memory_order_relaxed) == Axis::Undivided) {
                axis.store(divide(begin, end), std::memory_order_release);
            }
        }
        return static_cast<int>(axis.load(std::memory_order_relaxed)) - 1;
    }

    Axis divide(std::size_t begin, std::size_t end) const {
        Vec3 low = node_[begin].place;
        Vec3 high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = glm::min(low, node_[i].place);
            high = glm::max(high, node_[i].place);
        }
        const Vec3 side = high - low;
        const int axis = side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
        const auto at = [&](std::size_t i) {
            return node_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(begin + (end - begin) / 2), at(end),
                         [&](const Node& a, const Node& b) {
                             const double x = a.place[axis];
                             const double y = b.place[axis];
                             return x < y || (x == y && a.point < b.point);
                         });
        return static_cast<Axis>(axis + 1);
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
        const int axis = divided(begin, end);
        const double offset = place[axis] - node_[middle].place[axis];
        if (offset <= distance) search(begin, middle, place, distance, visit);
        test(node_[middle]);
        if (offset >= -distance) search(middle + 1, end, place, distance, visit);
    }

    /// The finite points, together where they are searched. A part that is undivided is changed
    /// only by who holds the lock, and read only once it is divided or too small for that.
    mutable std::vector<Node> node_;
    mutable std::vector<std::atomic<Axis>> axis_;
    mutable std::mutex dividing_;
};

}  // namespace se
