/// §6.4: the fan of triangles from first to last, and the two-point rings over 180 degrees that are
/// discarded. Triangles are only appended. O(fan).
#include <cassert>
#include <span>

#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// §6.4, Fig. 9: true if a neighbor ring of first and last alone is discarded.
bool isDiscarded(const AnyContext auto& context) {
    const NeighborRing& n = context.state.pivot;
    switch (paperRules(context).twoPoint) {
        case TwoPointRule::Over:
            return overlapsAsTwoPointRing(n.lastAngle);
        case TwoPointRule::From:
            return n.lastAngle.key >= kHalfTurnKey - context.params.sameAngle;
        case TwoPointRule::None:
            break;
    }
    return n.fullTurn;
}

/// Calls `entry`, with its side, for the entries among the spokes of the fan and `candidate` for
/// the others, in order from first to last. Between first and start, and between end and last, lie
/// the points that were passed (Fig. 4).
template <typename OnEntry, typename OnCandidate>
void forEachSpoke(const State& s, OnEntry&& entry, OnCandidate&& candidate) {
    const NeighborRing& n = s.pivot;
    for (Index e = n.first; e != n.start; e = s.rings.prev(e)) entry(e, Side::Start);
    entry(n.start, Side::Start);
    for (const Candidate& c : n.candidates) candidate(c);
    for (Index e = n.end; e != n.last; e = s.rings.prev(e)) entry(e, Side::End);
    entry(n.last, Side::End);
}

/// Lists the points of the fan's spokes, from first to last.
void listSpokes(State& s) {
    std::vector<Index>& spokes = s.pivot.spokes;
    spokes.clear();
    forEachSpoke(
        s, [&](Index e, Side) { spokes.push_back(s.rings.point(e)); },
        [&](const Candidate& c) { spokes.push_back(c.point); });
}

}  // namespace

void phaseTwoPoint(AnyContext auto& context) {
    State& s = context.state;
    const NeighborRing& n = s.pivot;
    const Index p = s.rings.point(n.pivot);
    const bool unwanted = whatIfOverride(context, Stage::Guard, p) == false;
    s.phase = context.params.robust.looksAtFan() || unwanted ? Phase::Guard : Phase::Emit;
    if (!n.candidates.empty() || n.start != n.first || n.end != n.last) return;
    const bool overlaps = isDiscarded(context);
    // The full turn has no triangle that a what-if could keep.
    const auto forced = n.fullTurn ? std::nullopt : whatIfOverride(context, Stage::TwoPoint, p);
    note(context, Stage::TwoPoint, [&] {
        return TwoPointEvidence{
            n.lastAngle.degrees(),
            applyOverride(overlaps ? Verdict::Discarded : Verdict::Hole, forced, !overlaps),
            n.fullTurn};
    });
    if (forced.value_or(!overlaps)) return;
    ++s.counters.discarded;
    s.phase = Phase::Advance;
}

void layOutFan(StepContext& context) {
    const State& s = context.state;
    NeighborRing& n = context.state.pivot;
    n.fan.clear();
    const auto angleAt = [&](Index e, Side side, const Vec3& offset) {
        const bool atStart = side == Side::Start;
        if (e == (atStart ? n.start : n.end)) return atStart ? n.startAngle : n.endAngle;
        if (e == (atStart ? n.first : n.last)) return atStart ? Angle{} : n.lastAngle;
        return angleOf(n.frame, offset);
    };
    forEachSpoke(
        s,
        [&](Index e, Side side) {
            const Vec3 offset = context.positionAt(e) - n.frame.origin;
            n.fan.push_back({s.rings.point(e), e, false, offset, glm::dot(offset, offset),
                             angleAt(e, side, offset)});
        },
        [&](const Candidate& c) {
            n.fan.push_back({c.point, c.instance, true, c.offset, c.lengthSq, c.angle});
        });
}

void phaseEmit(AnyContext auto& context) {
    State& s = context.state;
    const Index p = s.rings.point(s.pivot.pivot);
    listSpokes(s);
    const std::vector<Index>& spokes = s.pivot.spokes;
    const std::size_t before = s.triangles.size();
    for (std::size_t i = 0; i + 1 < spokes.size(); ++i) {
        assert(spokes[i] != p && spokes[i + 1] != p && spokes[i] != spokes[i + 1]);
        s.triangles.push_back({p, spokes[i], spokes[i + 1]});
    }
    s.pivotTriangles = static_cast<std::uint32_t>(s.triangles.size() - before);
    if (context.waiting != nullptr) {
        context.change(p);
        for (const Index each : spokes) context.change(each);
    }
    if (!s.edges.empty()) {
        for (const Triangle& t : std::span(s.triangles).subspan(before)) {
            // Invariant 5, unless a what-if overrides the guard: no directed edge twice.
            assert(!context.params.robust.guard || !context.params.whatIf.empty() ||
                   !(s.edges.has(t.a, t.b) || s.edges.has(t.b, t.c) || s.edges.has(t.c, t.a)));
            s.edges.add(t);
        }
    }
    for (std::size_t i = before; i < s.triangles.size(); ++i) {
        note(context, Stage::Emit, [&] {
            return EmitEvidence{static_cast<Index>(i), s.triangles[i]};
        });
    }
    // The bound that ends every guarded run, see docs/architecture.md.
    assert(!context.params.robust.guard ||
           3 * s.triangles.size() <= context.points.size() * (context.points.size() - 1));
    s.phase = Phase::Ring;
}

template void phaseTwoPoint(UnloggedContext&);
template void phaseTwoPoint(LoggedContext&);
template void phaseEmit(UnloggedContext&);
template void phaseEmit(LoggedContext&);

}  // namespace se
