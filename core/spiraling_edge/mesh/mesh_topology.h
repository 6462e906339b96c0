/// The topology of a mesh: what follows from its triangles alone, without positions.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/mesh/sorted_sides.h"

namespace se {

/// Fewer triangles are not worth a thread.
inline constexpr std::size_t kTrianglesPerThread = 32768;
/// Number of threads for independent checks of a mesh, as for runTasks().
inline unsigned threadsFor(std::span<const Triangle> triangles) {
    return triangles.size() < kTrianglesPerThread ? 1 : 0;
}

/// The edges, components and fans of a mesh, each found once for all checks.
struct MeshTopology {
    /// Requires corners below `points`. On all cores, with equal values for any number of them.
    /// About O(t) for t triangles.
    MeshTopology(std::size_t points, std::span<const Triangle> triangles);
    MeshTopology(const MeshTopology&) = delete;
    MeshTopology& operator=(const MeshTopology&) = delete;

    std::vector<TriangleSide> sides;  ///< sortedSides().
    std::size_t edges = 0;            ///< Number of different edges.
    /// The sides of each edge but those of two triangles that pass it in opposite directions, in
    /// the order of `sides`.
    std::vector<std::span<const TriangleSide>> irregularEdges;
    std::vector<TriangleSide> border;      ///< The edges of one triangle, in the order of `sides`.
    std::vector<bool> used;                ///< Per point: in some triangle.
    std::size_t usedPoints = 0;            ///< Number of points in some triangle.
    std::vector<Index> component;          ///< Per point: the least point of its component.
    std::size_t components = 0;            ///< Number of those with triangles.
    std::vector<Index> nonManifoldPoints;  ///< nonManifoldPoints().
};

/// Counts a mesh as reportMesh() does. Requires the topology of these triangles, and their faults.
MeshReport reportOf(const PointSet& points, std::span<const Triangle> triangles,
                    const MeshTopology& topology, std::span<const Fault> faults);

}  // namespace se
