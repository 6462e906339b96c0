/// The part of a surface that particles may be on: bringing them back to it, and how dense they
/// should stand there. Shared by the parts of the sampler.
#pragma once

#include <array>
#include <optional>

#include "spiraling_edge/sampling/field.h"

namespace se::sampling {

/// Area that a particle covers where they stand in equilateral triangles, in squares of the
/// spacing.
inline constexpr double kHexagonal = 0.86602540378443865;

/// Axes along which a particle may not move: bits 1, 2 and 4, as in TypeBits.
using HeldAxes = unsigned;
/// Of a particle on the walls of `type`.
constexpr HeldAxes heldBy(std::uint8_t type) { return (type | type >> 3U) & 7U; }

inline double lengthOf(const Vec3& v) { return std::sqrt(glm::dot(v, v)); }
inline Vec3 without(Vec3 v, HeldAxes held) {
    for (int axis = 0; axis < 3; ++axis) {
        if ((held >> static_cast<unsigned>(axis) & 1U) != 0) v[axis] = 0.0;
    }
    return v;
}

/// A field together with the density that is wanted on its surface.
class Surface {
  public:
    /// `curvature` as in SamplerOptions.
    Surface(Field field, double curvature);

    const Field& field() const { return field_; }
    double value(const Vec3& x) const { return field_.value(x) - field_.isovalue; }
    /// Edges of a cell of the lattice in which the surface is looked for.
    Vec3 cell() const { return (field_.high - field_.low) / Vec3(field_.cells); }
    bool inside(const Vec3& x) const;

    /// The place on the surface along the gradient, if there is one within `reach` and the box,
    /// to `tolerance` times `reach`.
    std::optional<Vec3> settle(const Vec3& x, HeldAxes held, double reach,
                               double tolerance = 1e-13) const;

    /// How much the unit normal turns per length: root of the sum of the squares of both principal
    /// curvatures.
    double curvature(const Vec3& x) const;
    /// From now on spacing() is relative to this mean.
    void setMeanCurvature(double mean) { meanCurvature_ = mean; }
    bool followsCurvature() const { return influence_ > 0.0; }
    /// Wanted spacing in units of that where the surface is flat: 1 without influence of the
    /// curvature, never below a fifth.
    double relativeSpacing(const Vec3& x) const;

  private:
    Field field_;
    double influence_;
    double meanCurvature_ = 1.0;
};

}  // namespace se::sampling
