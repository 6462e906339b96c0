/// The mesh that is edited after the last pivot (docs/robust.md): what one step changed, and which
/// triangle belongs to which component.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se::view {

/// Triangles of `after` that `before` has not got, whichever corner comes first.
std::vector<Triangle> freshTriangles(const std::vector<Triangle>& before,
                                     const std::vector<Triangle>& after);

using MeshEdge = std::array<Index, 2>;  ///< The smaller point first.

/// The edges of the triangles that a step took out and of those that it made.
struct MeshEdges {
    std::vector<MeshEdge> gone;  ///< In none of the new triangles.
    std::vector<MeshEdge> made;  ///< In none of the old ones.
    std::vector<MeshEdge> kept;  ///< The rim of both.
};
/// `seated`: a point that was in no triangle; without old triangles what it is joined to was there.
MeshEdges edgesOf(std::span<const Triangle> gone, std::span<const Triangle> made,
                  Index seated = kNone);

/// Triangles from `first` up to the next stretch are of one component.
struct ComponentStretch {
    std::size_t first = 0;
    std::size_t component = 0;  ///< Counted from 0.
    friend bool operator==(const ComponentStretch&, const ComponentStretch&) = default;
};

/// The components of a mended mesh. A flip, or a point that goes in, joins no two of them, so that
/// a triangle is of the component that its corners were of when they were first used.
/// `emitted`: the triangles of the run; `starts`: where in them each component begins.
std::vector<ComponentStretch> componentsOf(std::span<const Triangle> mended,
                                           std::span<const Triangle> emitted,
                                           std::span<const std::size_t> starts, std::size_t points);

/// The same, worked out anew only for another mesh or other components.
class MendedComponents {
  public:
    const std::vector<ComponentStretch>& of(
        const std::shared_ptr<const std::vector<Triangle>>& mended,
        std::span<const Triangle> emitted, std::span<const std::size_t> starts, std::size_t points);

  private:
    std::shared_ptr<const std::vector<Triangle>> mended_;
    std::vector<std::size_t> starts_;
    std::vector<ComponentStretch> stretches_;
};

}  // namespace se::view
