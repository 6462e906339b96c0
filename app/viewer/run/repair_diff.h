/// The mesh as edited after the last pivot (docs/robust.md): the changes of one step, or of another
/// run, and the component of each triangle.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

using MeshEdge = std::array<Index, 2>;  ///< The smaller point first.

/// The edges of the triangles that a step removed and of those that it made.
struct MeshEdges {
    std::vector<MeshEdge> gone;  ///< In none of the new triangles.
    std::vector<MeshEdge> made;  ///< In none of the old ones.
    std::vector<MeshEdge> kept;  ///< Rim of both.
};
/// `seated`: a point that was in no triangle. Without old triangles, edges without it were there.
MeshEdges edgesOf(std::span<const Triangle> gone, std::span<const Triangle> made,
                  Index seated = kNone);

/// The difference of a mesh from that of another run over the same points.
struct MeshChange {
    std::shared_ptr<const std::vector<Triangle>> gone;  ///< Not in the other mesh, or turned there.
    std::shared_ptr<const std::vector<Triangle>> made;  ///< Of the other mesh, turned ones too.
    MeshEdges edges;                                    ///< Of these triangles.
    std::size_t before = 0;                             ///< Number of triangles of the mesh.
    std::size_t turned = 0;   ///< Number of triangles in both lists, wound the other way.
    std::size_t regions = 0;  ///< Parts of the change, connected by common points.
};
/// Requires corners below position.size(). O(t log t).
MeshChange changeOf(std::span<const Vec3> position, std::span<const Triangle> before,
                    std::span<const Triangle> after);
/// "812 of 25 950 triangles go", and "850 come, 2 turn, in 31 regions".
std::array<std::string, 2> wordsOf(const MeshChange& change);

/// Stretch of triangles of one component, from `first` up to the next stretch.
struct ComponentStretch {
    std::size_t first = 0;
    std::size_t component = 0;  ///< Counted from 0.
    friend bool operator==(const ComponentStretch&, const ComponentStretch&) = default;
};

/// Components of a repaired mesh. A flip, or a point that is put in, joins no two of them, so
/// a triangle belongs to the component that its corners had when they were first used.
/// `emitted`: the triangles of the run; `starts`: the first triangle of each component in them.
std::vector<ComponentStretch> componentsOf(std::span<const Triangle> repaired,
                                           std::span<const Triangle> emitted,
                                           std::span<const std::size_t> starts, std::size_t points);

/// Cache of the components of a repaired mesh, recomputed only for another mesh or other
/// components.
class RepairedComponents {
  public:
    const std::vector<ComponentStretch>& of(
        const std::shared_ptr<const std::vector<Triangle>>& repaired,
        std::span<const Triangle> emitted, std::span<const std::size_t> starts, std::size_t points);

  private:
    std::shared_ptr<const std::vector<Triangle>> repaired_;
    std::vector<std::size_t> starts_;
    std::vector<ComponentStretch> stretches_;
};

}  // namespace se::view
