/// Normals of a file beside its positions: whether they fit the surface, and agree on its sides.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {

/// Points, their normals as given, and the points about each.
struct GivenNormals {
    std::span<const Vec3> position;
    std::span<const Vec3> normal;      ///< Unit length; zero where there is no direction.
    const std::vector<bool>& present;  ///< False for points to leave out: no list holds them.
    const NeighborLists& nearest;      ///< The 12 nearest, with any normals.

    Index size() const { return static_cast<Index>(position.size()); }
    bool hasNormal(Index p) const { return present[p] && normal[p] != Vec3(0.0); }
};

/// The normals of a file at unit length; zero where there is no direction.
std::vector<Vec3> unitNormals(std::vector<Vec3> normal);

/// Gives each point that has copies the mean direction of its own normal and those of its copies
/// that differ: in a mesh with hard edges, a corner has a vertex with a normal for each of its
/// faces. Where they cancel out, its own stays. Returns the number of points whose normal became a
/// mean; 0 without normals. O(points).
std::size_t averageOverCopies(const PlacedPoints& placed, std::vector<Vec3>& normal);

/// Thresholds of normalsFit(), measured on half of the shared sets and judged on the others
/// (docs/doctor.md).
struct FitLimits {
    /// A place is planar if the least variance of a point and its 12 nearest is under this share of
    /// the sum of the three, and the middle one over `width` of the greatest: no line; and if they
    /// go all the way round, with no gap over 90 degrees.
    double thickness = 0.02;
    double width = 0.04;
    double medianCosine = 0.96126169593831886;  ///< 16 degrees: the greatest median angle.
    double nearCosine = 0.86602540378443865;    ///< 30 degrees, which
    double nearShare = 0.9;                     ///< this share must be within.
    /// With fewer planar places, or a lesser share of them, nothing is known, and the normals count
    /// as fitting.
    std::size_t leastPlaces = 8;
    double leastShare = 0.1;
    /// Planes of so coarse a surface are off it here and there: with fewer places only a median
    /// beyond 40 degrees counts.
    std::size_t fewPlaces = 24;
    double fewCosine = 0.76604444311897803;
};
inline constexpr FitLimits kFitLimits{};

/// Angles between given normals and the planes of their surroundings, at planar places, whatever
/// their sides.
struct NormalFit {
    std::size_t normals = 0;  ///< Points with a direction.
    std::size_t places = 0;   ///< Of these, at planar places.
    double medianCosine = 1.0;
    double leastTenth = 1.0;   ///< Cosine that a tenth of the places stays below,
    double mostTenth = 1.0;    ///< and that a tenth exceeds.
    std::size_t near = 0;      ///< Places within 30 degrees of the plane,
    std::vector<Index> off{};  ///< and the others, ascending.
};
/// Measures the normals. `threads` as in NeighborOptions; the result is the same for any.
NormalFit fitOf(const GivenNormals& given, unsigned threads = 0);
/// True if normals are those of the surface, up to their sides: kFitLimits. False if no point has a
/// direction.
bool normalsFit(const NormalFit& fit);

/// Connected components of points, and the points whose normals contradict the rest.
struct Sides {
    std::vector<Index> component;  ///< The name of each point's component; kNone without a normal.
    std::vector<bool> flipped;     ///< Against the rest of the component.
};
/// The sides of given normals. Patches of points whose normals agree, in one sheet, contradict each
/// other where the sheet goes on with the opposite normal; the smaller of two is flipped. So is a
/// single point against nearly all beside it.
Sides sidesOf(const GivenNormals& given);

}  // namespace se
