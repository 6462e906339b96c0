/// The paper's algorithm once more, from its sentences alone: plain loops, no code of the library
/// beyond points, types, normals and neighbor lists. The reference for the set `printed`.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se::test {

/// One pivot of a run: its point, and the triangles made at it, in order.
struct PivotTriangles {
    Index point = kNone;
    std::vector<Triangle> triangles;
    friend bool operator==(const PivotTriangles&, const PivotTriangles&) = default;
};

/// The pivots of the whole run, or up to the first one at which there are more than 8 triangles per
/// point, since the paper's rules need not end. Rim points without a wall are no points of the
/// paper: none may be in `points`.
std::vector<PivotTriangles> literalRun(const PointSet& points, const GivenStart& start = {});

}  // namespace se::test
