/// The decisions of §4 to §7, each a pure function in the paper's words that returns its evidence:
/// the numbers compared and the verdict. Only + - * / and sqrt decide, so that runs are equal on
/// every machine; numbers for display (degrees, centers, radii) come from member functions that are
/// called only for that. All positions are first taken relative to a nearby point, so that a set
/// far from the origin loses no precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/neighbor_ring.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

// ---- §6.1: angles -------------------------------------------------------------------------------

/// The frame of pivot p: reference vector z to the point at first, and n.
/// Choice: n = normal x z, see docs/choices.md ("sign of n").
inline Frame makeFrame(const Vec3& p, const Vec3& normal, const Vec3& first, bool tangent = false) {
    const Vec3 toFirst = first - p;
    const double lengthSq = glm::dot(toFirst, toFirst);
    const Vec3 z = lengthSq > 0.0 ? toFirst / std::sqrt(lengthSq) : Vec3(0.0);
    const Vec3 n = glm::cross(normal, z);
    return {p, normal, z, n, tangent ? glm::cross(n, normal) : Vec3(0.0), tangent};
}

/// The angle whose cosine is `cosine` (clamped to [-1, 1]), beyond 180 degrees if `secondHalf`.
inline Angle makeAngle(double cosine, bool secondHalf) {
    const double c = std::max(-1.0, std::min(1.0, cosine));
    // 3 + c or 1 - c: by table, since a branch would be guessed wrong half of the time.
    constexpr double kBase[2] = {1.0, 3.0};
    constexpr double kSign[2] = {-1.0, 1.0};
    return {c, kBase[secondHalf ? 1 : 0] + kSign[secondHalf ? 1 : 0] * c};
}

/// The angle between z and `offset` (relative to the pivot), projected onto the tangent plane.
inline Angle angleInPlane(const Vec3& x, const Vec3& n, const Vec3& offset) {
    const double along = glm::dot(x, offset);
    const double across = glm::dot(n, offset);
    const double lengthSq = along * along + across * across;
    return makeAngle(lengthSq > 0.0 ? along / std::sqrt(lengthSq) : 0.0, across < 0.0);
}

/// §6.1: the angle of `offset` (relative to the pivot) from z: arccos(z . v) if n . v >= 0, else
/// 2 pi minus that; v is the unit vector along offset. RobustRules::tangent: the angle in the
/// plane.
inline Angle angleOf(const Frame& frame, const Vec3& offset, double lengthSq) {
    if (frame.tangent) return angleInPlane(frame.x, frame.n, offset);
    const double cosine = lengthSq > 0.0 ? glm::dot(frame.z, offset) / std::sqrt(lengthSq) : 0.0;
    return makeAngle(cosine, glm::dot(frame.n, offset) < 0.0);
}
inline Angle angleOf(const Frame& frame, const Vec3& offset) {
    return angleOf(frame, offset, glm::dot(offset, offset));
}

/// True if `angle` is strictly between `from` and `to`, by more than `tolerance` (in key units).
/// The angle of the reference vector itself counts as 0 and as 360 degrees.
inline bool strictlyBetween(const Angle& angle, const Angle& from, const Angle& to,
                            double tolerance) {
    const double low = std::max(from.key, 0.0) + tolerance;
    const double high = std::min(to.key, kFullTurn.key) - tolerance;
    return angle.key > low && angle.key < high;
}

/// True if b - a, for a <= b, exceeds the angle below 180 degrees whose cosine is `limitCosine`.
inline bool exceedsAngle(const Angle& a, const Angle& b, double limitCosine) {
    if (b.key - a.key > kHalfTurnKey) return true;
    const auto sine = [](const Angle& x) {
        const double s = std::sqrt((1.0 - x.cosine) * (1.0 + x.cosine));
        return x.key > kHalfTurnKey ? -s : s;
    };
    return a.cosine * b.cosine + sine(a) * sine(b) < limitCosine;
}

// ---- §6.1: limits and reciprocity ---------------------------------------------------------------

/// §6.1, Fig. 4: the test whether the edge ring is concave at s.
struct ConcaveTest {
    double turn;  ///< ((before - s) x (after - s)) . N_s, squared scene units.
    bool concave() const { return turn > 0.0; }
};
/// The free angle at s runs counterclockwise from `before` to `after`, its neighbors on the ring;
/// below 180 degrees the ring is concave there.
inline ConcaveTest testConcave(const Vec3& s, const Vec3& normal, const Vec3& before,
                               const Vec3& after) {
    return {glm::dot(glm::cross(before - s, after - s), normal)};
}

/// §6.1, Fig. 6: the test whether p could be in the neighbor ring of e.
struct ReciprocalTest {
    Angle pivot;  ///< Angle of p at e, from `first`.
    Angle limit;  ///< Angle of `last` at e.
    bool inside;
};
/// `first` and `last` are the positions before and after e's entry on the ring; sameEntry: they are
/// the same entry, so that the sector is a full turn.
inline ReciprocalTest testReciprocal(const Vec3& e, const Vec3& normal, const Vec3& first,
                                     const Vec3& last, bool sameEntry, const Vec3& p,
                                     double tolerance, bool tangent = false) {
    const Frame frame = makeFrame(e, normal, first, tangent);
    const Angle limit = sameEntry ? kFullTurn : angleOf(frame, last - e);
    const Angle pivot = angleOf(frame, p - e);
    return {pivot, limit, strictlyBetween(pivot, Angle{}, limit, tolerance)};
}

// ---- §6.2: holes --------------------------------------------------------------------------------

/// §6.2, Fig. 7: the plane through start and end along the mean normal.
struct HolePlane {
    Vec3 origin;       ///< Position of start.
    Vec3 normal;       ///< (end - start) x (N_p + N_start + N_end), not unit.
    double pivotSide;  ///< Sign: the side of p.

    double side(const Vec3& x) const { return glm::dot(normal, x - origin); }
    /// Strictly on the pivot's side.
    bool keeps(const Vec3& x) const {
        // No product: it would be 0 for points 1e-85 apart.
        return pivotSide > 0.0 ? side(x) > 0.0 : pivotSide < 0.0 && side(x) < 0.0;
    }
};
inline HolePlane makeHolePlane(const Vec3& start, const Vec3& end, const Vec3& normalSum,
                               const Vec3& p) {
    HolePlane plane{start, glm::cross(end - start, normalSum), 0.0};
    plane.pivotSide = plane.side(p);
    return plane;
}

// ---- §6.3: removal ------------------------------------------------------------------------------

/// §6.3, Fig. 8: q against the sphere whose equator is the circle through p, s and t. All vectors
/// are relative to p. With c = numerator / (2 denominator), |q - c| < |c| is the same as
/// |q|^2 denominator < q . numerator, which needs no division and no root.
struct SphereTest {
    Vec3 q;              ///< Relative to p.
    Vec3 numerator;      ///< 2 denominator times the center, relative to p.
    double denominator;  ///< |t x s|^2
    double power;        ///< |q|^2 denominator - q . numerator; < 0 inside.
    double scale;        ///< |q|^2 denominator, the magnitude that power is compared with.
    bool noCircle;       ///< p, s and t are collinear.

    /// Strictly inside. Choice: a point on the sphere up to rounding counts as on it.
    bool inside() const { return power < -1e-12 * scale; }
    /// On it up to rounding.
    bool onSphere() const { return std::abs(power) <= 1e-12 * scale; }
    Vec3 center() const { return numerator / (2.0 * denominator); }  ///< Relative to p.
    double radius() const { return std::sqrt(glm::dot(center(), center())); }
    double distance() const { return std::sqrt(glm::dot(q - center(), q - center())); }
};
/// testSphere() for lengths whose products of six are numbers.
inline SphereTest testUsualSphere(const Vec3& t, double tLengthSq, const Vec3& s, double sLengthSq,
                                  const Vec3& q, double qLengthSq) {
    const Vec3 perp = glm::cross(t, s);
    const double denominator = glm::dot(perp, perp);
    SphereTest test{q, Vec3(0.0), denominator, 0.0, 0.0, false};
    // sin^2 of the angle between t and s below 1e-20: no circle that doubles could give.
    if (!(denominator > 1e-20 * tLengthSq * sLengthSq)) {
        test.noCircle = true;
        return test;
    }
    test.numerator = glm::cross(tLengthSq * s - sLengthSq * t, perp);
    test.scale = qLengthSq * denominator;
    test.power = test.scale - glm::dot(q, test.numerator);
    return test;
}
/// testSphere() for lengths of any size: `denominator`, `power` and `scale` are multiplied by a
/// power of two, and `numerator` so that center() is right.
SphereTest testExtremeSphere(const Vec3& t, const Vec3& s, const Vec3& q);
/// Circle through the origin (p), t and s after Hill, "The Pleasures of Perp Dot Products",
/// Graphics Gems IV, pages 138-148, in three dimensions.
inline SphereTest testSphere(const Vec3& t, double tLengthSq, const Vec3& s, double sLengthSq,
                             const Vec3& q, double qLengthSq) {
    constexpr double kLargest = 1e250;
    constexpr double kSmallest = 1e-250;
    const double size = tLengthSq * sLengthSq * qLengthSq;
    if (!(size > kSmallest && size < kLargest)) [[unlikely]]
        return testExtremeSphere(t, s, q);
    return testUsualSphere(t, tLengthSq, s, sLengthSq, q, qLengthSq);
}

// ---- §6.4: two-point rings ----------------------------------------------------------------------

/// §6.4, Fig. 9: a neighbor ring of first and last alone overlaps if its angle is over 180 degrees.
inline bool overlapsAsTwoPointRing(const Angle& last) { return last.key > kHalfTurnKey; }

// ---- §7: walls ----------------------------------------------------------------------------------

/// True if `direction` points out of one of the walls in `faces`: positive component on a maximum
/// wall, negative on a minimum wall (§7.1).
bool pointsOut(const Vec3& direction, std::uint8_t faces);

/// True if the sector at p from `from` counterclockwise to `to` stays inside the box: it is at most
/// 180 degrees, and no outward direction of p's walls lies strictly in it. Measured in the tangent
/// plane. Choice: the paper gives only the cross product of 7.1; this is the property that it
/// decides.
bool sectorStaysInside(const Vec3& p, const Vec3& normal, std::uint8_t faces, const Vec3& from,
                       const Vec3& to);

/// §7.1: the place of the third point on the ring.
struct ThirdPointSide {
    Vec3 cross;   ///< N_p x (s - p), s the second point of the ring.
    bool before;  ///< Before p on the ring, else after.
};
/// p has `faces`, `second` is the other point of the ring, `third` the point to insert.
ThirdPointSide placeThirdPoint(const Vec3& p, const Vec3& normal, std::uint8_t faces,
                               const Vec3& second, const Vec3& third);

/// As placeThirdPoint(), by the cross product alone, even if the sector leads out of the box.
ThirdPointSide printedThirdPointSide(const Vec3& p, const Vec3& normal, std::uint8_t faces,
                                     const Vec3& second);

/// §7 for a rim point: the part of the free sector between its ring neighbors that is not yet
/// meshed. Choice: a boundary point without wall bits has no wall; its gap takes the place of one.
struct RimSector {
    /// The surface ends in the sector: the middle of the gap lies in it, or first or last in the
    /// gap.
    bool holdsGap;
    /// If so: there is surface between first and the gap's beginning; between its end and last.
    bool openAtFirst, openAtLast;
};
/// Measured in the tangent plane; `from` and `to` are the positions of the gap's ends. sameEntry:
/// first and last are the same entry, and the sector is a full turn.
RimSector testRimSector(const Vec3& p, const Vec3& normal, const Vec3& first, const Vec3& last,
                        bool sameEntry, const Vec3& from, const Vec3& to);

/// RobustRules::rim: true if the surface ends at p: a boundary point, or a point where the
/// directions to its neighbors, in projection along its normal, leave a gap wider than the angle of
/// `gapCosine`.
bool isRim(const PointSet& points, Index p, double gapCosine);

/// §7.2: true if there is a transition from one wall to another between two ring neighbors.
inline bool isTransition(std::uint8_t a, std::uint8_t b) {
    return isOnWall(a) && isOnWall(b) && !shareFace(a, b);
}

}  // namespace se
