/// Rims: places where the surface ends although no wall cuts it, as in scans with holes, open busts
/// and sheets, found from points, normals and neighbor lists alone (docs/choices.md, "Rims").
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

/// The rims of a set of points.
struct Rim {
    /// For each point its gap, the sector without neighbors; no ends where the surface continues.
    std::vector<RimGap> gap;
    /// Closed chains of rim points, with the surface to their left in projection along the normals:
    /// clockwise around a hole. A rim point may lie beside a chain and not on it.
    std::vector<std::vector<Index>> chains;
    std::size_t candidates = 0;  ///< Points whose neighbors leave a gap of more than 120 degrees.

    /// Number of points with a gap.
    std::size_t points() const;
};

/// Finds rims without Delaunay, in three steps. (1) A point is a candidate if the directions to its
/// neighbors, in projection along its normal, leave a gap of more than 120 degrees. List entries
/// count in both directions, the first twelve of each list. (2) From each candidate a walk follows
/// the gaps: from a point on to the end of its gap, and there to the end of the widest gap that
/// begins near the direction that the walk came from, if it has 60 degrees. (3) A walk that closes
/// is a rim if two in three of its points are candidates and it is at least 2.5 of its edges wide,
/// as an opening of RobustRules::rim must be. Candidates between two points of rims belong to them,
/// nothing else does.
///
/// `type` may be empty; points on walls walk along, but do not become rim points, and a chain in
/// which they are the majority is no rim: the wall ends the surface there. Deterministic; positions
/// and normals decide by + - * / and sqrt alone. O(list entries log longest list). `threads` as in
/// NeighborOptions; the result is the same for any. Fails if there are too many list entries, or if
/// cancelled.
Result<Rim> findRim(std::span<const Vec3> position, std::span<const Vec3> normal,
                    const NeighborLists& neighbors, std::span<const std::uint8_t> type = {},
                    unsigned threads = 0, const Progress& progress = {});

/// The widest gaps of points that were given as rim points (kRimPoint): by `type`. All others get
/// no ends, nor do points with fewer than two neighbors in different directions.
Result<std::vector<RimGap>> gapsOfRimPoints(std::span<const Vec3> position,
                                            std::span<const Vec3> normal,
                                            const NeighborLists& neighbors,
                                            std::span<const std::uint8_t> type,
                                            unsigned threads = 0, const Progress& progress = {});

}  // namespace se
