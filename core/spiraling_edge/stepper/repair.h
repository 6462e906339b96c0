/// Beyond the paper: what is done with the mesh after the last pivot (docs/robust.md). The list of
/// emitted triangles stays as it is; this is a copy that is edited, one step at a time.
#pragma once

#include <vector>

#include "spiraling_edge/mesh/edge_table.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

/// Triangles with their neighbors, for local changes. A plain value: copy it, and you can go back.
struct MendState {
    std::vector<Triangle> triangles;
    /// For each side 3 t + k, the same side seen from the other triangle; kNone at a border.
    std::vector<HalfEdge> twin;
    /// One side that leaves each point; kNone for a point in no triangle.
    std::vector<HalfEdge> sideOf;
    /// Points whose triangles form more than one fan: left alone.
    std::vector<bool> pinched;
    /// Sides to look at, and how far the looking has come.
    std::vector<HalfEdge> queue;
    std::size_t queueFront = 0;
    Index nextPoint = 0;  ///< A place in PointSet::order.
    Index nextTriangle = 0;
    std::uint32_t takenOut = 0;
    std::uint32_t round = 0;  ///< Reinserting and flipping are done in turn, kMendRounds times.
    std::uint32_t reinserted = 0;
    std::uint32_t flipped = 0;

    bool empty() const { return triangles.empty(); }
};

/// What was flipped makes room for more points, and the other way round.
inline constexpr std::uint32_t kMendRounds = 3;

/// Takes over the triangles. Sides of edges with more than two triangles get no twin.
MendState beginMending(std::size_t pointCount, const std::vector<Triangle>& triangles);

/// Rules::reinsert: puts the next stranded point into the triangle it lies over, if that makes
/// three triangles without a fault. False if no point is left to try; `point` is the one that went
/// in.
bool reinsertNext(const PointSet& points, MendState& mend, Index& point);

/// An edge that was flipped: u v became x y.
struct Flip {
    Index u, v, x, y;
};
/// Rules::flip: flips the next edge that is better flipped: fewer faults, or the same and a larger
/// least angle where the surface is flat. False if none is left. Every flip lessens the faults, or
/// leaves them and makes the least angle of its two triangles larger, so that it ends.
bool flipNext(const PointSet& points, const RobustLimits& limits, MendState& mend, Flip& flip);

/// Rules::reseat: takes out a point at the next flipped triangle, if the hole of its triangles can
/// be closed without a fault. False if none is left. Every point taken out leaves two triangles
/// less, so that it ends.
bool reseatNext(const PointSet& points, MendState& mend, Index& point);

}  // namespace se
