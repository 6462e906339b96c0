/// Meshes of extreme size, brought to a moderate one: the checks take products of up to eight
/// lengths, which at 1e150 overflow and at 1e-150 vanish.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The points of a mesh, with all their lengths multiplied by one power of two where the mesh is
/// larger than 1e30 or smaller than 1e-30: without rounding, so that a check finds the same for any
/// size. Points of usual meshes are not copied. Refers to `points`, which must outlive it. Requires
/// corners below points.size(). O(t) for t triangles.
class ModerateSize {
  public:
    ModerateSize(const PointSet& points, std::span<const Triangle> triangles);

    /// The points, with normals, types and judge; lists and order as they were.
    const PointSet& points() const { return scaled_ ? *scaled_ : *given_; }
    /// A length of points(), in scene units.
    double length(double moderate) const { return std::ldexp(moderate, -power_); }
    /// An area of points(), in scene units squared.
    double area(double moderate) const { return std::ldexp(moderate, -2 * power_); }
    /// A place among points(), in scene units.
    Vec3 place(const Vec3& moderate) const;

  private:
    const PointSet* given_;
    int power_ = 0;  ///< Lengths are multiplied by 2 to this power.
    std::optional<PointSet> scaled_;
};

}  // namespace se
