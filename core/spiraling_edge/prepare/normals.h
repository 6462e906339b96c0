/// Estimation of missing normals.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// The plane nearest to a point and its listed neighbors.
struct PlaneFit {
    Vec3 normal{0.0};  ///< Unit length, on either side; zero where no plane fits best.
    std::array<double, 3>
        variance{};  ///< Along the normal, then across, ascending; scene units squared.
};
PlaneFit planeAt(std::span<const Vec3> position, Index p, std::span<const Index> list);
/// Its normal; zero where no plane fits best, as below.
inline Vec3 planeNormalAt(std::span<const Vec3> position, Index p, std::span<const Index> list) {
    return planeAt(position, p, list).normal;
}

/// Unit normals of the planes nearest to each point and its listed neighbors (principal components
/// of their positions; Hoppe et al. 1992, section 3.1), on either side. Zero where no plane fits
/// best: fewer than two neighbors, or all collinear. `neighbors` has a list per position; those of
/// points to leave out are empty, and no list holds these points. Deterministic. `threads` as in
/// NeighborOptions; the result is the same for any. Fails if `progress` cancels.
Result<std::vector<Vec3>> estimateNormals(std::span<const Vec3> position,
                                          const NeighborLists& neighbors, unsigned threads = 0,
                                          const Progress& progress = {});

/// True if fewer than half of the usable points have a normal with a direction (finite, not zero):
/// then those few say nothing of the side of most, and all normals are derived.
bool lacksNormals(std::span<const Vec3> normal, const std::vector<bool>& usable);

/// The normals of a file, with those of usable points that have no direction completed: each is
/// that of the plane nearest to the point and its 12 nearest, on the side of those of its neighbors
/// that have one, from neighbor to neighbor; outward in parts where none has. Zero where no plane
/// fits best. All others stay as they are. Rounded to the type of the file's normals, so that a
/// file written with them gives the same run. Deterministic. `threads` as in NeighborOptions. Fails
/// if `progress` cancels.
Result<std::vector<Vec3>> completeNormals(const PointFile& file, const std::vector<bool>& usable,
                                          unsigned threads = 0, const Progress& progress = {});

}  // namespace se
