/// A triangle's own planes, by which most pairs of triangles are found to have no conflict.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "spiraling_edge/geometry/second_layer.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// The planes on the edges of a triangle, which lean outward from upright by 22.5 degrees, and its
/// own plane. If all corners of another triangle are beyond one of the edges, the two share no more
/// than common corners. Nor is one a layer over the other: layers are seen along the sum of their
/// normals, which are within 45 degrees of each other. A search finds the sides of each point once,
/// for all triangles at it.
class EdgePlanes {
  public:
    /// Bits of sidesOf().
    enum Side : std::uint8_t {
        kBeyondEdge = 7,  ///< Clearly beyond an edge, or an end of it: a bit for each edge.
        kAbove = 8,       ///< Clearly above the triangle, or a corner of it.
        kBelow = 16,      ///< Clearly below the triangle, or a corner of it.
    };

    EdgePlanes(const PointSet& points, const ShapedTriangle& t)
        : points_(&points), corner_(t.triangle), at_(points.position[t.triangle.a]) {
        const Vec3& b = points.position[t.triangle.b];
        const Vec3& c = points.position[t.triangle.c];
        const double size = t.shape.reach;
        const double length = glm::length(t.shape.normal);
        // Of a triangle almost without area the planes are unknown, and no side is clear.
        if (!(length > kNarrow * size * size)) return;
        up_ = t.shape.normal / length;
        outward_ = {glm::normalize(glm::cross(b - at_, up_)),
                    glm::normalize(glm::cross(c - b, up_)),
                    glm::normalize(glm::cross(at_ - c, up_))};
        second_ = glm::dot(outward_[1], b - at_);
        margin_ = kMargin * size;
    }

    /// The sides on which a point is.
    std::uint8_t sidesOf(Index p) const {
        if (p == corner_.a) return 1 | 4 | kAbove | kBelow;
        if (p == corner_.b) return 1 | 2 | kAbove | kBelow;
        if (p == corner_.c) return 2 | 4 | kAbove | kBelow;
        const Vec3 place = points_->position[p] - at_;
        const double height = glm::dot(up_, place);
        const double least = kLean * std::abs(height) + margin_;
        return static_cast<std::uint8_t>((glm::dot(outward_[0], place) > least ? 1 : 0) |
                                         (glm::dot(outward_[1], place) - second_ > least ? 2 : 0) |
                                         (glm::dot(outward_[2], place) > least ? 4 : 0) |
                                         (height > margin_ ? kAbove : 0) |
                                         (height < -margin_ ? kBelow : 0));
    }

    /// True if two triangles clearly have no conflict: `common` are the sides that all corners of
    /// the other are on.
    static bool tellApart(unsigned common, const LayerShape& mine, const LayerShape& other) {
        if ((common & kBeyondEdge) != 0) return true;
        return isOffPlane(common) && !areParallel(mine, other);
    }
    /// True if the corners of the other that are not common lie on one side of the triangle.
    static bool isOffPlane(unsigned common) {
        // All three are common corners if they are on both sides.
        const unsigned off = common & (kAbove | kBelow);
        return off == kAbove || off == kBelow;
    }

  private:
    /// More than the tangent of 22.5 degrees, 0.41422.
    static constexpr double kLean = 0.415;
    /// Far above the rounding of the planes, which grows as a triangle gets narrow.
    static constexpr double kMargin = 1e-7;
    static constexpr double kNarrow = 1e-4;

    const PointSet* points_;
    Triangle corner_;
    Vec3 at_;
    Vec3 up_{};
    std::array<Vec3, 3> outward_{};
    double second_ = 0.0;  ///< Of the middle edge's plane, which does not hold the first corner.
    double margin_ = 0.0;
};

}  // namespace se
