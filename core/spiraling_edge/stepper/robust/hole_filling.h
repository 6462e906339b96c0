/// The filling of a hole in a RepairState with triangles between the points of its ring.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {

/// The ring of a hole.
struct HoleRing {
    std::vector<Index> points;    ///< Counterclockwise around the filling.
    std::vector<HalfEdge> outer;  ///< Per point: across the side to the next; kNone at a border.
    std::vector<Index> gone;      ///< Triangles inside, which the filling replaces.
    Index inside = kNone;  ///< A point in no triangle that stays; the filling goes around it.

    std::size_t size() const { return points.size(); }
    /// The point at a position; at size() the one inside.
    Index at(std::size_t i) const { return i < points.size() ? points[i] : inside; }
};
inline bool isOn(const HoleRing& ring, Index point) {
    return std::find(ring.points.begin(), ring.points.end(), point) != ring.points.end();
}
inline bool isGone(const HoleRing& ring, Index triangle) {
    return std::find(ring.gone.begin(), ring.gone.end(), triangle) != ring.gone.end();
}

/// Widens the ring by the triangle across a side, which has a new point. False at a border, and
/// where the point is pinched or on the ring already.
bool widenByTriangle(const RepairState& repair, std::size_t side, HoleRing& ring);

/// The patch of one triangle.
HoleRing patchOf(const RepairState& repair, Index triangle);

/// Places of HoleRing::at(), counterclockwise.
using RingTriangle = std::array<std::size_t, 3>;
/// Triangles that fill a ring of n points: n - 2, with a point inside n; or none.
using Filling = std::vector<RingTriangle>;

/// The search for the filling of a ring. A triangle of it has no fault: it is not flipped, has
/// width, is in conflict with none nearby and not folded onto its neighbors; and no edge of it
/// is one of a triangle that stays.
class FillingSearch {
  public:
    /// The points, the mesh and the ring must outlive it.
    FillingSearch(const PointSet& points, RepairState& repair, const HoleRing& ring);

    /// The filling with the largest least angle or, where that one crosses itself, with the least
    /// area; empty if there is none. Dynamic programming over parts of the ring (Barequet and
    /// Sharir 1995), O(n^3), unless a side of the ring is blocked: 97 in 100 of the rings without a
    /// filling have such a side. Around a point inside, each side in turn gets a triangle with that
    /// point, and only the least angle is tried, O(n^4).
    Filling find();
    /// The first side of the ring, from number `from` on, at which every triangle has a fault; the
    /// number of sides if there is none.
    std::size_t firstBlocked(std::size_t from);

  private:
    Triangle triangle(const RingTriangle& t) const {
        return {ring_.at(t[0]), ring_.at(t[1]), ring_.at(t[2])};
    }
    bool staysJoined(std::size_t u, std::size_t v);
    bool findStaying(Index u, Index v) const;
    bool foldsOnto(const Triangle& made, HalfEdge outer) const;
    bool fits(const RingTriangle& t);
    bool isFit(const RingTriangle& t);
    bool mayMake(const RingTriangle& t);
    bool isInConflict(const Triangle& made);
    template <typename Visit>
    bool anyThird(std::size_t side, Visit&& visit);
    bool isBlocked(std::size_t side);
    bool hasBlockedSide();
    bool crossesItself(const Filling& filling) const;
    Filling findAround();

    template <typename Goal>
    friend class FillingTable;

    /// Result of the tests of a triangle of the ring: it fits if it has no fault, conflicts not
    /// counted.
    enum class Known : std::uint8_t { Nothing, Fit, Sound, Faulty };
    Known& known(const RingTriangle& t) {
        const std::size_t count = ring_.size() + 1;
        return known_[(t[0] * count + t[1]) * count + t[2]];
    }

    const PointSet& points_;
    RepairState& m_;
    const HoleRing& ring_;
    std::vector<Known> known_;
    std::vector<std::optional<bool>> joined_;  ///< staysJoined() of two places, if asked.
    Index inTheWay_ = kNone;  ///< The triangle that the last conflict was with: tested first.
};

/// Grows a patch to each of these numbers of triangles in turn, or as far as it goes, by those
/// nearest to the first before others, until it has a filling other than its own triangles, which
/// takes their place. Returns how many of them the filling lacks; 0 if no patch of these sizes has
/// such a filling.
Index replacePatch(const PointSet& points, RepairState& repair, HoleRing& patch,
                   std::span<const std::size_t> sizes);

/// Puts the filling in the place of HoleRing::gone, and at the end of the list; those that are gone
/// and get no new one are dropped.
void putFilling(RepairState& repair, const HoleRing& ring, const Filling& filling);

}  // namespace se
