/// §6.2: where p, start and end close a hole of three edges, candidates on the far side of the
/// plane through start and end along the mean normal are removed. O(candidates).
#include "spiraling_edge/stepper/step_context.h"

namespace se {

namespace {

/// The number of edges of the hole that p, start and end form, at most PaperRules::holeSize (by
/// default three); 0 if they form none.
Index edgesOfHole(const AnyContext auto& context) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const Index size = paperRules(context).holeSize;
    if (!context.params.readings.realHole) {
        const Index length = s.rings.length(s.rings.active());
        return length >= 3 && length <= size ? length : 0;
    }
    if (!(n.endAngle.key - n.startAngle.key < kHalfTurnKey)) return 0;
    // p to start and end are two edges; the others lead back from end to start.
    Index e = n.end;
    for (Index edges = 3; edges <= size; ++edges) {
        if (context.openStep(e)) return 0;
        e = s.rings.next(e);
        if (e == n.start) return edges;
    }
    return 0;
}

}  // namespace

void phaseHole(AnyContext auto& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    s.phase = Phase::Sphere;
    if (n.candidates.empty() || n.fullTurn) return;
    const Index edges = edgesOfHole(context);
    if (edges == 0) return;
    const HolePlane plane = makeHolePlane(
        context.positionAt(n.start), context.positionAt(n.end),
        n.frame.normal + context.normalAt(n.start) + context.normalAt(n.end), n.frame.origin);
    std::size_t kept = 0;
    for (const Candidate& c : n.candidates) {
        const Vec3& x = context.points.position[c.point];
        const bool onSide = plane.keeps(x);
        const auto forced = whatIfOverride(context, Stage::Hole, c.point);
        const bool keeps = forced.value_or(onSide);
        note(context, Stage::Hole, [&] {
            const double length = std::sqrt(glm::dot(plane.normal, plane.normal));
            const double unit = length > 0.0 ? 1.0 / length : 0.0;
            return HoleEvidence{
                c.point,
                plane.normal,
                plane.side(x) * unit,
                plane.pivotSide * unit,
                applyOverride(onSide ? Verdict::Kept : Verdict::FarSide, forced, onSide),
                edges};
        });
        if (keeps) n.candidates[kept++] = c;
    }
    n.candidates.resize(kept);
}

template void phaseHole(UnloggedContext&);
template void phaseHole(LoggedContext&);

}  // namespace se
