/// The place in a run at which a sentence is checked: points, rings, status and triangles, with the
/// neighbor ring of the pivot as the decisions so far leave it. Uses no rule of the stepper.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/run/sentences/plain_geometry.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::test::sentences {

class Witness {
  public:
    Witness(const PointSet& points, const Params& params, const State& state);

    /// Call before and after each phase of the stepper.
    void beforePhase();
    void afterPhase();
    /// Applies a decision, after its sentence was checked.
    void follow(const Event& event);

    const PointSet& points;
    const Params& params;
    const State& state;                  ///< After the phase.
    EdgeRings was;                       ///< Before the phase.
    std::vector<PointStatus> status;     ///< After the decisions so far.
    std::vector<PointStatus> statusWas;  ///< Before the phase.
    std::vector<std::vector<Index>> at;  ///< Triangles at each point, those of this pivot too.
    std::vector<Triangle> meshWas;       ///< Before a step after the last pivot.
    EdgeRings rings;                     ///< After the splits, joins and closed edges so far.
    std::size_t changes = 0;             ///< Splits, joins and closed edges of the phase so far.
    std::size_t emitted = 0;             ///< Triangles named so far.
    Index p = kNone, first = kNone, last = kNone;  ///< Points.
    Index start = kNone, end = kNone;              ///< Entries.
    bool startMoved = false, endMoved = false;
    std::vector<Index> candidates, pool;
    Index circuit = 0;  ///< Length of the active ring, without a third point of §7.
    Index idle = 0;     ///< Pivots without a triangle, of this ring and circuit.
    Index seeds = 0, failed = 0;
    std::vector<Index> released;  ///< Points taken off the ring in this phase.

    V place(Index x) const { return V(points.position[x]); }
    /// Clockwise: angles grow counterclockwise about the opposite of the normal.
    bool isTurned() const { return params.paper.turn == TurnRule::Clockwise; }
    V normal(Index x) const { return isTurned() ? -V(points.normal[x]) : V(points.normal[x]); }
    RimGap gapAt(Index x) const {
        const RimGap gap = points.gapAt(x);
        return isTurned() ? RimGap{gap.to, gap.from} : gap;
    }
    V offset(Index x) const { return place(x) - place(p); }
    Index pointOf(Index entry) const { return state.rings.point(entry); }
    Corners corners(const Triangle& t) const { return {place(t.a), place(t.b), place(t.c)}; }
    /// At the pivot, from first; 0 to 360 degrees.
    Real angle(Index x) const;
    /// angle(); of a point in the plane of first, where rounding decides about the half, the mirror
    /// image if that is nearer to `stated`.
    Real angleNear(Index x, Real stated) const;
    Real lastAngle() const { return first == last ? 360 : angle(last); }
    Real startAngle() const { return startMoved ? angle(pointOf(start)) : 0; }
    Real endAngle() const { return endMoved ? angle(pointOf(end)) : lastAngle(); }
    bool lists(Index a, Index b) const;
    /// The triangle with the directed edge; kNone if there is none.
    Index triangleWith(Index u, Index v) const;
    bool joined(Index u, Index v) const {
        return triangleWith(u, v) != kNone || triangleWith(v, u) != kNone;
    }
    /// The entry that this pivot inserted for a point, and the other instance that it is linked to.
    std::pair<Index, Index> linked(Index point) const;
    /// An entry of `a` between entries of b, or its own successor if b is kNone; kNone without one.
    Index closedEntry(Index a, Index b) const;
    /// The points of the fan from first to last, as it would be made now.
    std::vector<Index> spokes() const;
    V outward(const Triangle& t) const;
    /// 4 if a triangle does not face the sum of its corners' normals, 1 if not one of them.
    int shapeFault(const Triangle& t) const;
    /// True if two triangles meet, or one is a second layer of the other.
    bool inConflict(const Triangle& a, const Triangle& b) const;
    /// True if the surface ends at x: RobustRules::rim.
    bool endsAt(Index x) const;

  private:
    void keepMesh(const std::vector<Triangle>& mesh);
    std::vector<Index> keptByInstance_;
    std::map<Index, Real> stated_;  ///< Angles of listed points, see angleNear().
};

}  // namespace se::test::sentences
