/// A start other than an empty mesh: triangles and edge rings that a run begins with, as if it had
/// made them. It is data among the Params, so that everything that runs points under params begins
/// there. For figures of the paper that show one pivot, and for tests.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"

namespace se {

struct Params;
struct State;

/// A step of an edge ring, by its points.
struct RingStep {
    Index from = kNone;
    Index to = kNone;
    friend bool operator==(const RingStep&, const RingStep&) = default;
};

/// The state that a run begins with. Points that it does not name are UNUSED.
struct GivenStart {
    /// The mesh so far, in the order in which the triangles count as made.
    std::vector<Triangle> triangles = {};
    /// Edge rings as lists of points, in their direction (the mesh is on their left): the bottom of
    /// the stack first, the active ring last. Each begins with its pivot. Without any, the run goes
    /// on with a new ring of two (§4).
    std::vector<std::vector<Index>> rings = {};
    std::vector<Index> done = {};  ///< DONE points, in the order in which they became so.
    /// Steps of the rings that are no edges of the mesh.
    std::vector<RingStep> open = {};

    /// True if the run begins as usual, with nothing.
    bool empty() const { return triangles.empty() && rings.empty() && done.empty(); }
    friend bool operator==(const GivenStart&, const GivenStart&) = default;
};

/// Success if invariants 1, 2, 3 and 5 (invariants.h) hold at the start, and each point of its
/// triangles is on a ring or DONE. Otherwise a sentence that begins with the entry: "rings[0]: the
/// step 3 -> 5 is no edge of a triangle; ...". O(points + start, times the open steps).
Status requireStart(const PointSet& points, const GivenStart& start);

/// The state before the first phase of a run: that of Params::start. Requires requireStart() to
/// succeed.
State startState(const PointSet& points, const Params& params);

// The parts of a start, which check nothing: tests begin with incomplete ones too.
/// Makes `points` the active ring, with steps that are mesh edges, and puts the ring that was
/// active on top of the stack. Returns the entry of the first point. Requires two points or more.
Index addRing(State& state, std::span<const Index> points);
/// Adds triangles to the mesh. Status and rings stay.
void addTriangles(State& state, std::span<const Triangle> triangles);
/// Marks the entries of `step.from` whose step leads to `step.to` as open; with kNone there, all of
/// its entries.
void openSteps(State& state, const RingStep& step);

}  // namespace se
