/// Places of a mesh that have faults: a fault together with the less severe ones near it is one
/// place to look at and to repair.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"

namespace se {

/// Faults with points nearer to one another than this, in mean lengths of the edges of the mesh,
/// can be at one place.
inline constexpr double kPlaceReach = 3.0;

/// A place with faults.
struct FaultPlace {
    /// Positions in the list of failures, the most severe first: by FailureClass::severity, loops
    /// by descending length, then by position.
    std::vector<std::size_t> faults;
    Vec3 center{};        ///< Of the most severe fault, scene units.
    double radius = 0.0;  ///< Of the most severe fault: its farthest point from the center.
};

/// The places of the failures that are faults (FailureClass::fault), the most severe first. Each is
/// the most severe fault that is at no place yet, with all others at no place yet that have a point
/// in common with it, or one nearer than kPlaceReach: so a place is not much larger than its most
/// severe fault. `meanEdge` is the mean length of the edges, MeshInspection::meanEdge. Each fault
/// is at one place. Deterministic. About O(f log f) for f points of faults.
std::vector<FaultPlace> faultPlaces(const PointSet& points, std::span<const MeshFailure> failures,
                                    double meanEdge);

/// Description of the faults at a place, the most severe first, with at most three classes: "1 hole
/// of 3 edges, 2 lost points".
std::string describe(const FaultPlace& place, std::span<const MeshFailure> failures);

}  // namespace se
