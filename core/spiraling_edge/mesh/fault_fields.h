/// Faults and distances of points as columns of their file, which other programs show as scalar
/// fields.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// Names of the columns: CloudCompare reads names that begin with "scalar_" as scalar fields, and
/// shows the rest of them.
inline constexpr std::string_view kFaultField = "scalar_se_fault";
inline constexpr std::string_view kDistanceField = "scalar_se_distance";

/// The most severe fault of each point by its class: 0 for none, else the position of the class in
/// failureClasses(), from 1. Failures of classes that are no faults do not count. Requires points
/// of failures below `points`.
std::vector<double> faultNumbers(std::size_t points, std::span<const MeshFailure> failures);

/// Sets the columns kFaultField, of faultNumbers(), and kDistanceField, of distancesFromMesh(), in
/// `file`; those of an earlier mesh are replaced. `points` are those of the file, in its order.
/// Requires the conditions of both functions.
void setFaultFields(PointFile& file, const PointSet& points, std::span<const Triangle> triangles,
                    std::span<const MeshFailure> failures);

}  // namespace se
