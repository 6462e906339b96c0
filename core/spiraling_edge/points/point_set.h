/// The input of the Spiraling Edge algorithm (§3, §4): points with normals, type bits and
/// neighbor lists ordered by distance.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/base/types.h"

namespace se {

/// Type bits of a point (§4). The paper names the bits; the values are ours.
/// An interior point has none; a point with two or more face bits also has kCorner. A boundary
/// point without face bits, where the surface ends although no wall cuts it, has kRimPoint alone.
enum TypeBits : std::uint8_t {
    kInterior = 0,
    kPositiveX = 1,
    kPositiveY = 2,
    kPositiveZ = 4,
    kNegativeX = 8,
    kNegativeY = 16,
    kNegativeZ = 32,
    kCorner = 64,
    kFaceBits = 63,
    kRimPoint = 128,
};

/// True if the surface ends at the point: on a wall of the box, or on a rim.
constexpr bool isBoundary(std::uint8_t type) { return (type & (kFaceBits | kRimPoint)) != 0; }
/// True if the point lies on a wall of the box (any face bit set).
constexpr bool isOnWall(std::uint8_t type) { return (type & kFaceBits) != 0; }
/// True if the surface ends at the point although no wall cuts it there.
constexpr bool isRimPoint(std::uint8_t type) { return isBoundary(type) && !isOnWall(type); }
/// True if the point lies on two or more walls.
constexpr bool isCorner(std::uint8_t type) {
    const unsigned faces = type & kFaceBits;
    return (faces & (faces - 1U)) != 0;
}
/// True if both points lie on a common wall.
constexpr bool shareFace(std::uint8_t a, std::uint8_t b) { return (a & b & kFaceBits) != 0; }
/// The face bits of `type`, with kCorner set exactly when there are two or more of them; where
/// there are none, kRimPoint or nothing.
constexpr std::uint8_t withCornerBit(std::uint8_t type) {
    if (isRimPoint(type)) return kRimPoint;
    const auto faces = static_cast<std::uint8_t>(type & kFaceBits);
    return static_cast<std::uint8_t>(isCorner(faces) ? faces | kCorner : faces);
}

/// One list of point indices per point, nearest first, packed consecutively. Lists may be of any
/// length, unsymmetric or empty.
struct NeighborLists {
    /// size() + 1 positions into `ids`, ascending; list p is ids[offset[p] .. offset[p + 1]).
    std::vector<std::uint32_t> offset{0};
    std::vector<Index> ids;

    std::size_t size() const { return offset.size() - 1; }
    std::span<const Index> operator[](Index p) const {
        return {ids.data() + offset[p], ids.data() + offset[p + 1]};
    }
    /// Fails unless `offset` divides `ids` into lists. O(lists).
    Status checkDivided() const {
        if (!offset.empty() && offset.front() == 0 && offset.back() == ids.size() &&
            std::is_sorted(offset.begin(), offset.end()))
            return success();
        return Error{"the offsets of the neighbor lists do not divide their entries"};
    }
    /// True if the list of p has q. O(list).
    bool has(Index p, Index q) const {
        const auto list = (*this)[p];
        return std::find(list.begin(), list.end(), q) != list.end();
    }
    /// Appends the list of the next point.
    void append(std::span<const Index> list) {
        ids.insert(ids.end(), list.begin(), list.end());
        offset.push_back(static_cast<std::uint32_t>(ids.size()));
    }
};

/// The gap of a rim point: a sector of its tangent plane without neighbors, counterclockwise from
/// `from` to `to`, two of its neighbors. No ends: not a rim point, or unknown.
struct RimGap {
    Index from = kNone;
    Index to = kNone;
    bool known() const { return from != kNone; }
    friend bool operator==(const RimGap&, const RimGap&) = default;
};

/// The reason why a point takes no part in a run: no list has it, and no triangle.
enum class Aside : std::uint8_t {
    No,         ///< It takes part.
    NotFinite,  ///< A coordinate is NaN or infinite.
    Copy,       ///< A point with a lower index has exactly the same position.
    Sentinel,   ///< Its coordinates stand for a missing value: sentinels.h.
    LeftOut,    ///< At the user's request.
    Stray,      ///< Far from all others: strays.h.
    NoNormal,   ///< Its normal has no direction, and no plane fits the points about it.
    Noise,      ///< Others lie nearer to the middle of the noise: noise.h.
};
inline constexpr std::size_t kAsides = static_cast<std::size_t>(Aside::Noise) + 1;

struct MeshJudge;  // mesh/mesh_judge.h

/// The input of the stepper. All arrays have the same length.
struct PointSet {
    std::vector<Vec3> position;      ///< Scene units.
    std::vector<Vec3> normal;        ///< Unit length; the outer side of the surface.
    std::vector<std::uint8_t> type;  ///< TypeBits.
    NeighborLists neighbors;
    /// Gaps of rim points; empty: none are known.
    std::vector<RimGap> rim;
    /// The order in which the start pointer of §4 takes the points, all of them once; empty: by
    /// index.
    std::vector<Index> order;
    /// Points that prepare() set aside: no triangle has them, and none should. Empty: none.
    std::vector<Aside> aside;
    /// The judge of a mesh of these points. Null: these points themselves.
    std::shared_ptr<const MeshJudge> judge;

    Aside asideOf(Index p) const { return p < aside.size() ? aside[p] : Aside::No; }
    bool isAside(Index p) const { return asideOf(p) != Aside::No; }
    /// The gap of point p; no ends where none is known.
    RimGap gapAt(Index p) const { return rim.empty() ? RimGap{} : rim[p]; }
    /// The point at position i of that order.
    Index inOrder(std::size_t i) const { return order.empty() ? static_cast<Index>(i) : order[i]; }
    std::size_t size() const { return position.size(); }
    bool empty() const { return position.empty(); }
};

/// The distance of a point to the nearest in its list; 0 for an empty list.
inline double nearestDistance(const PointSet& points, Index p) {
    const auto list = points.neighbors[p];
    return list.empty() ? 0.0 : glm::distance(points.position[list.front()], points.position[p]);
}

/// The sixth neighbor of a list that is not empty, or its last: the spacing at a point is its
/// distance to that one. On an even surface a point has six neighbors around it.
inline Index sixthOf(std::span<const Index> list) {
    return list[std::min<std::size_t>(5, list.size() - 1)];
}

/// True if the corners of all triangles have finite positions. Requires corners below
/// points.size(). O(t) for t triangles.
inline bool haveFinitePositions(const PointSet& points, std::span<const Triangle> triangles) {
    const std::vector<Vec3>& x = points.position;
    return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        return isFinite(x[t.a]) && isFinite(x[t.b]) && isFinite(x[t.c]);
    });
}

/// Checks the preconditions of the stepper: equal array lengths (`aside` and `rim` may be
/// empty); for every point that has a list or is in one, a finite position and a unit normal
/// (within 1e-6); in every list only existing points, none twice, not the point itself; all points
/// once in `order`, unless empty; as ends of `rim` only other points that exist, both or none.
/// Points outside all lists may have any values: they end as isolated. prepare() makes any input
/// pass. O(points + list entries).
Status validate(const PointSet& points);

}  // namespace se
