/// §6.4: the fan of triangles.
#include <cassert>

#include "phases.h"

namespace se {

// ---- §6.4: triangles ----------------------------------------------------------------------------

void phaseTwoPoint(StepContext& context) {
    State& s = context.state;
    const NeighborRing& n = s.pivot;
    s.phase = context.params.rules.looksAtFan() ? Phase::Guard : Phase::Emit;
    if (!n.candidates.empty() || n.start != n.first || n.end != n.last) return;
    const bool overlaps = overlapsAsTwoPointRing(n.lastAngle);
    note(context, Stage::TwoPoint, [&] {
        return TwoPointEvidence{n.lastAngle.degrees(),
                                overlaps ? Verdict::Discarded : Verdict::Hole};
    });
    if (!overlaps) return;
    ++s.counters.discarded;
    s.phase = Phase::Advance;
}

void layOutFan(StepContext& context) {
    const State& s = context.state;
    NeighborRing& n = context.state.pivot;
    n.fan.clear();
    const auto addEntry = [&](Index e, const Angle& angle) {
        const Vec3 offset = context.positionAt(e) - n.frame.origin;
        n.fan.push_back({s.rings.point(e), e, false, offset, glm::dot(offset, offset), angle});
    };
    const auto addPassed = [&](Index e) {
        addEntry(e, angleOf(n.frame, context.positionAt(e) - n.frame.origin));
    };
    // Between first and start, and end and last, stand the points that were passed (Fig. 4).
    if (n.start != n.first) addEntry(n.first, Angle{});
    for (Index e = n.first; e != n.start;) {
        e = s.rings.prev(e);
        if (e != n.start) addPassed(e);
    }
    addEntry(n.start, n.startAngle);
    for (const Candidate& c : n.candidates) {
        n.fan.push_back({c.point, c.instance, true, c.offset, c.lengthSq, c.angle});
    }
    addEntry(n.end, n.endAngle);
    for (Index e = n.end; e != n.last;) {
        e = s.rings.prev(e);
        if (e != n.last) addPassed(e);
    }
    if (n.end != n.last) addEntry(n.last, n.lastAngle);
}

void phaseEmit(StepContext& context) {
    State& s = context.state;
    if (!context.params.rules.looksAtFan()) layOutFan(context);
    const Index p = s.rings.point(s.pivot.pivot);
    const std::vector<FanPoint>& fan = s.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const Triangle t{p, fan[i].point, fan[i + 1].point};
        s.triangles.push_back(t);
        if (!s.edges.empty()) s.edges.add(t);
        note(context, Stage::Emit, [&] {
            return EmitEvidence{static_cast<Index>(s.triangles.size() - 1), t};
        });
    }
    s.pivotTriangles = static_cast<std::uint32_t>(fan.size() - 1);
    // The bound that ends every guarded run, see docs/architecture.md.
    assert(!context.params.rules.guard ||
           3 * s.triangles.size() <= context.points.size() * (context.points.size() - 1));
    s.phase = Phase::Ring;
}

}  // namespace se
