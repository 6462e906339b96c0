/// Orientation of normals to a common side.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

/// The result of orientNormals().
struct OrientationReport {
    std::size_t turned = 0;      ///< Normals that changed sides.
    std::size_t components = 0;  ///< Parts without a list entry from one to another.
    /// Edges of the trees with nearly perpendicular normals (|cosine| < 0.1): creases, thin parts.
    /// The likeliest places of errors.
    std::size_t doubtful = 0;
};

/// Turns normals so that neighbors agree: from one point of each component on, along the minimum
/// spanning tree of the lists, cheapest where normals agree best (Riemannian graph; Hoppe et al.
/// 1992, section 3.3). Two are compared after one is mirrored at the plane halfway between the
/// points (Xie et al. 2003), which holds across creases and thin parts, where Hoppe's plain cosine
/// turns whole patches (docs/choices.md). The first point is the one farthest out along the axis
/// that its normal follows best; its normal points outward, and so do all normals of a closed
/// surface. Lists need not be symmetric. Points with a zero normal are left out. Deterministic:
/// ties by index. `threads` as in NeighborOptions; the result is the same for any. Fails if
/// `progress` cancels; then no normal has been turned.
Result<OrientationReport> orientNormals(std::span<const Vec3> position,
                                        const NeighborLists& neighbors, std::vector<Vec3>& normal,
                                        unsigned threads = 0, const Progress& progress = {});

}  // namespace se
