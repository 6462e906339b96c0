/// Beyond the paper: repairs of the mesh after the last pivot (docs/robust.md). The list of emitted
/// triangles is unchanged; the repairs edit a copy, one step at a time.
#pragma once

#include <optional>
#include <vector>

#include "spiraling_edge/mesh/edge_table.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// Triangles with their neighbors, for local changes. A plain value: a copy is a place to return
/// to.
struct RepairState {
    std::vector<Triangle> triangles;
    /// For each side 3 t + k, the opposite side in the adjacent triangle; kNone at a border.
    std::vector<HalfEdge> twin;
    /// One side that leaves each point; kNone for a point in no triangle.
    std::vector<HalfEdge> sideOf;
    /// Points whose triangles form more than one fan: left alone.
    std::vector<bool> pinched;
    /// Sides to examine, and the position of the next one.
    std::vector<HalfEdge> queue;
    std::size_t queueFront = 0;
    /// Per triangle: the flips it took part in that only made fewer conflicts.
    std::vector<std::uint8_t> conflictFlips;
    Index nextPoint = 0;  ///< Position in PointSet::order.
    Index nextTriangle = 0;
    std::uint32_t takenOut = 0;
    std::uint32_t round = 0;  ///< Reinserting and flipping are done in turn, kRepairRounds times.
    std::uint32_t reinserted = 0;
    std::uint32_t flipped = 0;

    bool empty() const { return triangles.empty(); }
};

/// Number of rounds: flips make room for more points, and new points for more flips.
inline constexpr std::uint32_t kRepairRounds = 3;

/// A RepairState of `triangles`. Sides of edges with more than two triangles get no twin.
RepairState beginRepair(std::size_t pointCount, const std::vector<Triangle>& triangles);

/// RobustRules::reinsert: puts the next stranded point in the place of triangles it lies over, onto
/// a side of the border or beside it, if no new triangle has a fault. Nothing if no point is left
/// to try.
std::optional<ReinsertEvidence> reinsertNext(const PointSet& points, RepairState& repair);

/// RobustRules::flip: flips the next edge whose flip leaves fewer faults, or equally many and a
/// larger least angle where the surface is flat. Nothing if none is left. Terminates: every flip
/// makes fewer faults of shape, or keeps them and increases the least angle of its two triangles,
/// or makes fewer conflicts, which each triangle may be flipped for a few times.
std::optional<FlipEvidence> flipNext(const PointSet& points, const RobustThresholds& thresholds,
                                     RepairState& repair);

/// RobustRules::removeFolded: takes out a point at the next faulty triangle, if the hole of its
/// triangles can be closed without a fault. Nothing if none is left. Terminates: every point taken
/// out leaves two triangles less.
std::optional<RemoveFoldedEvidence> removeFoldedPoint(const PointSet& points, RepairState& repair);

}  // namespace se
