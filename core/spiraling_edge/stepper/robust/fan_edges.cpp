/// Rules on the edges of a fan: gap, guard, nopillow.
#include "spiraling_edge/stepper/robust/fan_rules.h"

namespace se {
// ---- gap ----------------------------------------------------------------------------------------

Objection wideGap(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (fan[i + 1].angle.key - fan[i].angle.key > kHalfTurnKey) {
            return {Verdict::WideGap, i, true};
        }
    }
    return {};
}

namespace {

// ---- guard --------------------------------------------------------------------------------------

/// Objects to a point twice in the fan, other than as first and last (pinched rings): its spoke
/// would be used twice in one direction.
Objection repeatedSpoke(const Fan& fan) {
    for (std::size_t i = 0; i < fan.size(); ++i) {
        for (std::size_t j = i + 1; j < fan.size(); ++j) {
            const bool ends = i == 0 && j + 1 == fan.size();
            if (!ends && fan[i].point == fan[j].point) return {Verdict::EdgeTaken, j, false};
        }
    }
    return {};
}

/// Objects to a spoke that is taken. Spokes inside the fan are new edges, used in both directions.
Objection takenSpoke(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const Index p = s.rings.point(s.pivot.pivot);
    const auto isNewOrStep = [&](Index u, Index v, bool open) {
        // u -> v would be made; v -> u may exist only as the ring step at the pivot.
        return !s.edges.has(u, v) && !(open && s.edges.has(v, u));
    };
    if (!isNewOrStep(p, fan.front().point, s.rings.open(s.pivot.first))) {
        return {Verdict::EdgeTaken, 0, false};
    }
    if (!isNewOrStep(fan.back().point, p, s.rings.open(s.pivot.pivot))) {
        return {Verdict::EdgeTaken, fan.size() - 1, false};
    }
    for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
        if (fan[i].entry == kNone) continue;  // UNUSED: it has no edges.
        if (s.edges.has(p, fan[i].point) || s.edges.has(fan[i].point, p)) {
            return {Verdict::EdgeTaken, i, false};
        }
    }
    return {};
}

/// Objects to a rim edge that is taken. One that exists in the reverse direction must be the ring
/// step between these entries.
Objection takenRim(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        const FanPoint& u = fan[i];
        const FanPoint& v = fan[i + 1];
        if (u.entry == kNone || v.entry == kNone) continue;
        if (s.edges.has(u.point, v.point)) return {Verdict::EdgeTaken, i, true};
        const bool isStep = s.rings.next(v.entry) == u.entry && !s.rings.open(v.entry);
        if (!isStep && s.edges.has(v.point, u.point)) return {Verdict::EntryMissed, i, true};
    }
    return {};
}

}  // namespace

Objection takenEdge(const StepContext& context) {
    if (const Objection repeated = repeatedSpoke(context.state.pivot.fan)) return repeated;
    const Objection spoke = takenSpoke(context);
    return spoke ? spoke : takenRim(context);
}

// ---- nopillow -----------------------------------------------------------------------------------

Objection pillow(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const Index p = s.rings.point(s.pivot.pivot);
    if (s.pivot.fullTurn() && fan.size() == 3) return {Verdict::Pillow, 0, true};
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (fan[i].entry == kNone || fan[i + 1].entry == kNone) continue;
        const HalfEdge h = s.edges.find(fan[i + 1].point, fan[i].point);
        if (h != kNone && s.edges.opposite(h) == p) return {Verdict::Pillow, i, true};
    }
    return {};
}

}  // namespace se
