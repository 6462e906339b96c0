/// A surface for particles: projection onto it, the target density there, and the search for it:
/// its crossings with the edges of a lattice over the box, and its curves on the walls. The search
/// finds every part that separates two corners of a cell. Shared by the parts of the sampler.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/sampling/field.h"

namespace se::sampling {

/// Area per particle in a lattice of equilateral triangles, in squares of the spacing.
inline constexpr double kHexagonal = 0.86602540378443865;

/// Axes along which a particle may not move: bits 1, 2 and 4, as in TypeBits.
using HeldAxes = unsigned;
/// The held axes of a particle on the walls of `type`.
constexpr HeldAxes heldBy(std::uint8_t type) { return (type | type >> 3U) & 7U; }

inline double lengthOf(const Vec3& v) { return std::sqrt(glm::dot(v, v)); }
inline Vec3 without(Vec3 v, HeldAxes held) {
    for (int axis = 0; axis < 3; ++axis) {
        if ((held >> static_cast<unsigned>(axis) & 1U) != 0) v[axis] = 0.0;
    }
    return v;
}

/// A field together with the target density on its surface.
class Surface {
  public:
    /// `curvature` as in SamplerOptions.
    Surface(Field field, double curvature);

    const Field& field() const { return field_; }
    double value(const Vec3& x) const { return field_.value(x) - field_.isovalue; }
    /// Edges of a cell of the lattice in the search for the surface.
    Vec3 cell() const { return (field_.high - field_.low) / Vec3(field_.cells); }
    bool inside(const Vec3& x) const;

    /// The place on the surface along the gradient, accurate to `tolerance` times `reach`; nothing
    /// if there is none within `reach` and the box.
    std::optional<Vec3> settle(const Vec3& x, HeldAxes held, double reach,
                               double tolerance = 1e-13) const;

    /// Turn of the unit normal per length: the root of the sum of the squares of both principal
    /// curvatures.
    double curvature(const Vec3& x) const;
    /// Sets the mean that relativeSpacing() refers to.
    void setMeanCurvature(double mean) { meanCurvature_ = mean; }
    bool followsCurvature() const { return influence_ > 0.0; }
    /// Target spacing relative to that on flat parts: 1 without influence of the curvature, never
    /// below a fifth.
    double relativeSpacing(const Vec3& x) const;

  private:
    Field field_;
    double influence_;
    double meanCurvature_ = 1.0;
};

/// A place on the surface, and the area that it represents: the sum of the areas is an unbiased
/// estimate of the whole. Along an axis, lines `a` apart in both directions meet a patch of area A
/// whose unit normal has the component n A |n| / a^2 times; weighted with |n| a^2 and summed over
/// the three axes, that gives A (n_x^2 + n_y^2 + n_z^2) = A.
struct Crossing {
    Vec3 position;
    double area;
};

/// Fails if `progress` cancels.
Result<std::vector<Crossing>> findCrossings(const Surface& surface, unsigned threads,
                                            const Progress& progress);

/// A curve of the surface on one wall: places in order, the first repeated at the end if it is
/// closed. An open one begins and ends at corners, on two walls.
struct WallCurve {
    std::uint8_t face = kInterior;  ///< TypeBits of the wall.
    std::vector<Vec3> line;
    bool closed() const { return line.front() == line.back(); }
};
std::vector<WallCurve> findWallCurves(const Surface& surface);

}  // namespace se::sampling
