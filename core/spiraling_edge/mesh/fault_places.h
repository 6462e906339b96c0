/// Places of a mesh that have faults: several faults that are connected, or near one another, are
/// one place to look at and to repair.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"

namespace se {

/// Faults with points nearer than this, in mean lengths of the edges of the mesh, are at one place.
inline constexpr double kPlaceReach = 3.0;

/// A place with faults.
struct FaultPlace {
    /// Positions in the list of failures, the most severe first: by FailureClass::severity, loops
    /// by descending length, then by position.
    std::vector<std::size_t> faults;
    Vec3 center{};        ///< Of the box around the points of its faults, scene units.
    double radius = 0.0;  ///< The farthest of these points from the center, scene units.
};

/// The places of the failures that are faults (FailureClass::fault), the most severe first: by
/// their most severe fault, then by the number of faults, then by position. `meanEdge` is the mean
/// length of the edges, MeshInspection::meanEdge. Each fault is at one place. Deterministic. About
/// O(f log f) for f points of faults.
std::vector<FaultPlace> faultPlaces(const PointSet& points, std::span<const MeshFailure> failures,
                                    double meanEdge);

/// What is at a place, most severe first: "hole of 3 edges, 2 unused points".
std::string describe(const FaultPlace& place, std::span<const MeshFailure> failures);

}  // namespace se
