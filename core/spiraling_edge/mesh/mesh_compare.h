/// Comparison of two meshes over the same points: the triangles that only one of them has, by
/// region. One of them may come from a file of another program, with vertices in another order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "spiraling_edge/points/point_file.h"

namespace se {

/// A vertex of a file is a point of the set if it is not farther from it than this times the
/// diagonal of the box around the points: the error of rounding to floats, or to six digits.
inline constexpr double kSamePointTolerance = 1e-6;

/// A mesh of a file, with vertices renumbered as the points that it was made on.
struct MatchedMesh {
    /// The triangles in the order of the file. A corner n with n >= points is
    /// unmatchedVertices[n - points].
    std::vector<Triangle> triangles;
    std::vector<Vec3> unmatchedVertices;  ///< Vertices of triangles that lie on no point.
    std::vector<Index> unmatchedNumbers;  ///< Their numbers in the file, ascending.
};

/// Finds the point of each vertex: the one of the same number if it lies there, or else the nearest
/// within kSamePointTolerance, ties by index. Vertices in no triangle are ignored. Requires faces
/// that name existing vertices. Deterministic. About O(points + vertices).
MatchedMesh matchMesh(std::span<const Vec3> points, const PointFile& mesh);

/// The counterpart of a triangle in the other mesh.
enum class Match : std::uint8_t {
    Same,      ///< The same corners, wound the same way.
    Reversed,  ///< The same corners, wound the other way.
    Missing,   ///< Nothing with these corners.
};

/// Triangles that only one mesh has, or has reversed, connected by common points.
struct DifferenceRegion {
    std::vector<Index> inA;  ///< Positions in the list of A, ascending: Missing and Reversed.
    std::vector<Index> inB;
    std::vector<Index> points;  ///< All their corners, ascending.
    Vec3 place{};               ///< Center of the box around them, scene units.
    double radius = 0.0;        ///< Half the diagonal of that box.
};

struct MeshDifference {
    std::vector<Match> a;  ///< For each triangle of A.
    std::vector<Match> b;
    std::size_t both = 0;
    std::size_t reversed = 0;
    std::size_t onlyA = 0;
    std::size_t onlyB = 0;
    /// Most triangles first, then by the least point.
    std::vector<DifferenceRegion> regions;

    bool same() const { return regions.empty(); }
};

/// Compares as sets of triangles: neither their order nor the corner they begin with counts. A
/// repeated triangle counts as often as it occurs. Requires corners below position.size().
/// Deterministic. O(t log t).
MeshDifference compareMeshes(std::span<const Vec3> position, std::span<const Triangle> a,
                             std::span<const Triangle> b);

/// A triangle by its corners in ascending order.
struct SortedTriangle {
    std::array<Index, 3> corners;
    bool odd;        ///< Wound against them.
    Index triangle;  ///< Its index in the mesh.

    friend bool operator<(const SortedTriangle& x, const SortedTriangle& y) {
        return std::tie(x.corners, x.odd, x.triangle) < std::tie(y.corners, y.odd, y.triangle);
    }
};

/// The triangles of a mesh as a set, to look up the counterpart of a triangle. Repetitions do not
/// count.
class TriangleSet {
  public:
    TriangleSet() = default;
    explicit TriangleSet(std::span<const Triangle> mesh);
    /// Same, Reversed or Missing: as if `triangle` were one of A, and the set B. O(log t).
    Match find(const Triangle& triangle) const;

  private:
    std::vector<SortedTriangle> entries_;  ///< In order.
};

/// Triangles of `after` that `before` lacks, regardless of the first corner: those that a step
/// after the last pivot made. Fast where few entries of the lists differ.
std::vector<Triangle> freshTriangles(const std::vector<Triangle>& before,
                                     const std::vector<Triangle>& after);

}  // namespace se
