/// The triangles of a mesh that another one has not, to be drawn in colors of their own.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "draw_list.h"
#include "spiraling_edge/mesh/mesh_compare.h"

namespace se::view {

/// Worked out once; at any time of the run the first so many of them are there.
class DifferenceShade {
  public:
    DifferenceShade() = default;
    /// `inOrder`: the triangles as the run makes them. `other`: what the other mesh has in the end.
    DifferenceShade(std::span<const Triangle> inOrder, std::shared_ptr<const TriangleSet> other);

    /// Those among the first `finished` triangles; or those of the mended mesh, if there is one.
    std::array<TintedTriangles, 2> at(std::size_t finished,
                                      const std::shared_ptr<const std::vector<Triangle>>& mended,
                                      const Color& only, const Color& turned) const;

  private:
    /// Of one kind, with their places in the order of the run.
    struct Part {
        std::vector<std::size_t> places;
        std::shared_ptr<const std::vector<Triangle>> triangles;
    };
    static std::array<Part, 2> partsOf(std::span<const Triangle> triangles,
                                       const TriangleSet& other);

    std::shared_ptr<const TriangleSet> other_;
    std::array<Part, 2> parts_{};
    mutable std::shared_ptr<const std::vector<Triangle>> mended_;  ///< What mendedParts_ are of.
    mutable std::array<Part, 2> mendedParts_{};
};

/// How a difference is shown in one view.
struct DifferenceLook {
    const DifferenceShade* shade = nullptr;
    Color only;
    Color turned;
    /// Those of the other mesh in the region that is shown: outlined.
    std::span<const Triangle> ghosts{};
    Color ghost;
    std::uint32_t revision = 0;  ///< Grows whenever something of it changes.
};

}  // namespace se::view
