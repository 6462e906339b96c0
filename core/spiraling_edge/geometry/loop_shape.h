/// The shape in space of an edge ring that stopped growing, or of any other closed chain of points.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Least width of an opening in edges of its ring. A narrower ring is a seam that did not close:
/// where the spacing changes, neighbors leave wide gaps, too.
inline constexpr double kNarrowestOpening = 2.5;

struct LoopShape {
    Index length = 0;
    double perimeter = 0.0;
    double area = 0.0;  ///< In projection along the direction in which it is largest.
    /// True if it turns counterclockwise in projection along the normals of its points, as around a
    /// patch of the surface. Around a hole it turns clockwise, since the hole lies in the free
    /// sectors of its points.
    bool turnsRoundPatch = false;

    /// The side of the square, or the diameter of the circle, of the same perimeter and area.
    double width() const { return perimeter > 0.0 ? 4.0 * area / perimeter : 0.0; }
    /// The width in edges of the ring: 1 for a square of four edges, n / pi for a round one of n.
    double widthInEdges() const {
        return perimeter > 0.0 ? width() * static_cast<double>(length) / perimeter : 0.0;
    }
};

/// The length of a vector, also where its square is beyond the range of a double.
inline double lengthAtAnySize(const Vec3& v) {
    constexpr double kLargest = 1e300;
    constexpr double kSmallest = 1e-290;
    const double square = glm::dot(v, v);
    if (square > kSmallest && square < kLargest) return std::sqrt(square);
    const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(most > 0.0 && most <= std::numeric_limits<double>::max())) return most;
    const int power = std::ilogb(most);
    const Vec3 scaled(std::ldexp(v.x, -power), std::ldexp(v.y, -power), std::ldexp(v.z, -power));
    return std::ldexp(std::sqrt(glm::dot(scaled, scaled)), power);
}

/// Sums up a loop point by point.
class ShapeSum {
  public:
    /// Adds the step from a point with its normal to the next point, both relative to a point of
    /// the loop.
    void add(const Vec3& from, const Vec3& normal, const Vec3& to) {
        ++shape_.length;
        normal_ += normal;
        area_ += 0.5 * glm::cross(from, to);
        shape_.perimeter += std::sqrt(glm::dot(to - from, to - from));
    }
    LoopShape shape() const {
        LoopShape shape = shape_;
        shape.area = lengthAtAnySize(area_);
        shape.turnsRoundPatch = glm::dot(area_, normal_) > 0.0;
        return shape;
    }

  private:
    LoopShape shape_;
    Vec3 area_{0.0}, normal_{0.0};
};

/// The shape of the closed loop through these points in this order. Requires at least one.
inline LoopShape shapeOfLoop(std::span<const Vec3> position, std::span<const Vec3> normal,
                             std::span<const Index> loop) {
    assert(!loop.empty());
    const Vec3 origin = position[loop.front()];
    ShapeSum sum;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index following = loop[i + 1 < loop.size() ? i + 1 : 0];
        sum.add(position[loop[i]] - origin, normal[loop[i]], position[following] - origin);
    }
    return sum.shape();
}

}  // namespace se
