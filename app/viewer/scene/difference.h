/// The triangles of a mesh that another one lacks, to be drawn in colors of their own.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "draw_list.h"
#include "spiraling_edge/mesh/mesh_compare.h"

namespace se::view {

/// Computed once; a prefix of them is present at any time of the run.
class DifferenceShade {
  public:
    DifferenceShade() = default;
    /// `inOrder`: the triangles as the run makes them. `other`: the final triangles of the other
    /// mesh.
    DifferenceShade(std::span<const Triangle> inOrder, std::shared_ptr<const TriangleSet> other);

    /// Those among the first `finished` triangles; or those of the repaired mesh, if there is one.
    std::array<TintedTriangles, 2> at(std::size_t finished,
                                      const std::shared_ptr<const std::vector<Triangle>>& repaired,
                                      const Color& only, const Color& turned) const;

  private:
    /// Triangles of one kind, with their positions in the order of the run.
    struct Part {
        std::vector<std::size_t> places;
        std::shared_ptr<const std::vector<Triangle>> triangles;
    };
    static std::array<Part, 2> partsOf(std::span<const Triangle> triangles,
                                       const TriangleSet& other);

    std::shared_ptr<const TriangleSet> other_;
    std::array<Part, 2> parts_{};
    mutable std::shared_ptr<const std::vector<Triangle>> repaired_;  ///< Mesh of repairedParts_.
    mutable std::array<Part, 2> repairedParts_{};
};

/// Style of a difference in one view.
struct DifferenceLook {
    const DifferenceShade* shade = nullptr;
    Color only;
    Color turned;
    /// Triangles of the other mesh in the shown region: outlined.
    std::span<const Triangle> ghosts{};
    Color ghost;
    std::uint32_t revision = 0;  ///< Grows with every change.
};

}  // namespace se::view
