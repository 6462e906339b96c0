/// The points of a run whose what-ifs move points or replace neighbor lists.
#pragma once

#include <cstdint>
#include <vector>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// The points as a what-if changes them, from a pivot on.
struct EditedPoints {
    std::uint32_t from = 0;
    PointSet points;
};

/// The points as Move and List leave them, each from a pivot on, in the order of the run; empty
/// without such.
std::vector<EditedPoints> editedPoints(const PointSet& points, const Params& params);

}  // namespace se
