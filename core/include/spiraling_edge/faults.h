/// What is wrong with a mesh, triangle by triangle: class and place of every fault.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "spiraling_edge/point_set.h"

namespace se {

/// The classes of faults. A mesh without any is called sound.
enum class FaultKind : std::uint8_t {
    NonManifoldEdge,   ///< An edge of three or more triangles.
    InconsistentEdge,  ///< An edge passed twice in the same direction.
    Degenerate,        ///< A corner twice, or no area.
    Flipped,           ///< Against the sum of the normals of its corners.
    Intersecting,      ///< Two triangles share more than their common corners.
    Folded,            ///< Two triangles at a common edge lie nearly on one another.
};
inline constexpr std::size_t kFaultKinds = 6;
/// "non_manifold_edge", ...
std::string_view faultName(FaultKind kind);

/// One fault. `other` is kNone for faults of a single triangle.
struct Fault {
    FaultKind kind;
    Index triangle;
    Index other;
    friend bool operator==(const Fault&, const Fault&) = default;
};

/// Two triangles at an edge count as folded if the angle between them is below this: the cosine of
/// the angle between their normals is below -cos(10 degrees).
inline constexpr double kFoldCosine = -0.984807753012208;

/// After this many intersecting pairs the search for more ends: a hopelessly tangled mesh has
/// billions.
inline constexpr std::size_t kMostIntersections = 1000000;

/// All faults, ordered by kind, triangle and other. Intersections are exact (floating-point filter,
/// then exact arithmetic). Boundary edges are no faults: see MeshReport. Requires corners below
/// points.size() and finite positions of used points. About O(t) for t triangles of similar size,
/// however often one is repeated.
std::vector<Fault> findFaults(const PointSet& points, std::span<const Triangle> triangles);

/// How many there are of each kind.
std::array<std::size_t, kFaultKinds> countFaults(std::span<const Fault> faults);

}  // namespace se
