/// Faults of the triangles of a mesh: class and place of each.
#pragma once

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

struct TriangleSide;  // sorted_sides.h

/// The classes of faults of triangles; whether a mesh is sound also depends on its loops, pieces
/// and points: inspection.h.
enum class FaultKind : std::uint8_t {
    NonManifoldEdge,   ///< An edge of three or more triangles.
    InconsistentEdge,  ///< An edge passed twice in the same direction.
    Degenerate,        ///< A corner twice, no area, or a needle.
    Flipped,           ///< Against the sum of the normals of its corners.
    Intersecting,      ///< Two triangles share more than their common corners.
    Folded,            ///< Two triangles at a common edge lie nearly on one another.
    SecondLayer,       ///< A triangle over another one that faces the same way.
};
inline constexpr std::size_t kFaultKinds = 7;

/// One fault. `other` is kNone for faults of a single triangle.
struct Fault {
    FaultKind kind;
    Index triangle;
    Index other;
    /// By kind, then by triangle.
    friend auto operator<=>(const Fault&, const Fault&) = default;
};

/// Maximum number of intersecting pairs, and of second layers: a hopelessly tangled mesh has
/// billions.
inline constexpr std::size_t kMaxPairs = 1000000;
/// Limit of the work of the search for pairs, in pairs of triangles visited: a fixed amount, plus
/// kPairWorkPerTriangle for each triangle. A pair whose boxes meet, unless it clearly lies side by
/// side, counts kPairTestWork units; in one plane, where only exact arithmetic decides, 2048 units
/// beyond 16 such pairs for each triangle. Meshes that are surfaces take some hundred units per
/// triangle.
inline constexpr std::uint64_t kPairWork = 50'000'000;
inline constexpr std::uint64_t kPairWorkPerTriangle = 4096;
inline constexpr std::uint64_t kPairTestWork = 32;

/// The faults of a mesh that were found within the limits of the search.
struct FaultSearch {
    std::vector<Fault> faults;  ///< Ordered by kind, triangle and other.
    /// False: the search for pairs ended early, and there may be more intersections and second
    /// layers; the other kinds are complete.
    bool complete = true;
    std::uint64_t work = 0;  ///< Work of the search for pairs, in the units above.
};

/// All faults. Intersections are exact (floating-point filter, then exact arithmetic); the search
/// for pairs ends early after kMaxPairs of a kind, or after the work named above: about two seconds
/// for a tangled mesh of some thousand triangles. Boundary edges are no faults: see MeshReport.
/// Requires corners below points.size() and finite positions of used points. Deterministic. About
/// O(t) for t triangles of similar size, however often one is repeated.
FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles);

/// As above, with the sides of the triangles at hand, on `threads` threads. 0: as many as the
/// machine has; the result is the same for any number.
FaultSearch searchFaults(const PointSet& points, std::span<const Triangle> triangles,
                         std::span<const TriangleSide> sides, unsigned threads = 0);

/// The faults that searchFaults() finds, with its limits.
std::vector<Fault> findFaults(const PointSet& points, std::span<const Triangle> triangles);

/// All faults but intersections and second layers, which take most of the time; `complete` is
/// false.
FaultSearch searchLocalFaults(const PointSet& points, std::span<const Triangle> triangles,
                              std::span<const TriangleSide> sides);

/// The number of faults of each kind.
std::array<std::size_t, kFaultKinds> countFaults(std::span<const Fault> faults);

}  // namespace se
