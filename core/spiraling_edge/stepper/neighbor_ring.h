/// The neighbor ring of one pivot (§6.1): candidates sorted counterclockwise about the pivot's
/// normal, between start and end.
#pragma once

#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// An angle at a pivot, counterclockwise from the reference vector z, in [0, 2*pi] (§6.1).
/// `key` orders angles without an arccosine: 1 - cos up to 180 degrees, 3 + cos beyond, so 0..4.
/// For any two angles a <= b: b - a > 180 degrees exactly when b.key - a.key > 2.
struct Angle {
    double cosine = 1.0;
    double key = 0.0;

    /// The angle in degrees, by arccosine (§6.1), for display. Decisions never use it.
    double degrees() const;
};

/// The angle of a full turn: the angle of last when first and last are the same point (§6.1).
inline constexpr Angle kFullTurn{1.0, 4.0};
/// Keys of 180 degrees.
inline constexpr double kHalfTurnKey = 2.0;

/// A neighbor that may become a corner of the pivot's fan.
struct Candidate {
    Index point = kNone;
    /// For a USED point: the entry whose free sector holds the pivot, the "other instance" of §6.5.
    Index instance = kNone;
    Angle angle;
    Vec3 offset{};          ///< Position minus the pivot's position.
    double lengthSq = 0.0;  ///< Squared length of offset.
};

/// One spoke of the pivot's fan, from first to last.
struct FanPoint {
    Index point = kNone;
    Index entry =
        kNone;  ///< The entry if already on the ring, or the candidate's instance; else kNone.
    bool candidate = false;  ///< May be dropped; else one of first .. start, end .. last.
    Vec3 offset{};
    double lengthSq = 0.0;
    Angle angle;
};

/// Local frame of a pivot: where angles are measured (§6.1).
struct Frame {
    Vec3 origin{};         ///< The pivot's position.
    Vec3 normal{};         ///< The pivot's normal, unit.
    Vec3 z{};              ///< Unit vector to first; zero if first lies on the pivot.
    Vec3 n{};              ///< normal x z: normal of the plane that slices the ring at 180 degrees.
    Vec3 x{};              ///< n x normal: z projected onto the tangent plane, as long as n.
    bool tangent = false;  ///< RobustRules::tangent: measure in the tangent plane, by x and n.
};

/// Everything about the pivot being worked on. first, last, start and end are ring entries, not
/// points: a point may be on both sides of its pivot.
struct NeighborRing {
    Index pivot = kNone;  ///< Entry of p.
    Index first = kNone;  ///< Predecessor of the pivot.
    Index last = kNone;   ///< Successor of the pivot; equal to first on a ring of two.
    /// First and last are the same point: the sector is a full turn (§6.1).
    bool fullTurn = false;
    Index start = kNone;  ///< first, or an entry before it (Fig. 4).
    Index end = kNone;    ///< last, or an entry after it.
    Frame frame;
    Angle lastAngle;   ///< The sector: angle of last, kFullTurn if `fullTurn`.
    Angle startAngle;  ///< 0 at first.
    Angle endAngle;
    /// The candidates as they come in the pivot's list, before they are sorted.
    std::vector<Candidate> listed;
    /// Strictly between start and end, by increasing angle.
    std::vector<Candidate> candidates;
    /// For the rules beyond the paper that drop candidates: the candidates before §6.3, so that it
    /// can be repeated without the dropped ones.
    std::vector<Candidate> pool;
    /// For the rules that examine the whole fan, in order: first .. start, candidates, end .. last.
    std::vector<FanPoint> fan;
    /// The points of the fan alone.
    std::vector<Index> spokes;
};

}  // namespace se
