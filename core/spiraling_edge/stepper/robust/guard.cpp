/// Beyond the paper (docs/robust.md): the rules on the edges of a fan (gap, guard, nopillow), and
/// the table of all rules that examine the whole fan. A candidate that a rule objects to is dropped
/// and §6.3 repeated without it; if there is none to drop, the fan is refused.
#include <algorithm>
#include <array>
#include <span>

#include "spiraling_edge/stepper/robust/fan_rules.h"

namespace se {
namespace {

// ---- gap ----------------------------------------------------------------------------------------

/// A gap of 180 degrees or more between two spokes (RobustRules::gap).
Objection wideGap(const StepContext& context) {
    const Fan& fan = context.state.pivot.fan;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (fan[i + 1].angle.key - fan[i].angle.key > kHalfTurnKey) {
            return {Verdict::WideGap, i, true};
        }
    }
    return {};
}

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

/// An edge that is taken, or a ring step closed away from its entries (RobustRules::guard).
Objection takenEdge(const StepContext& context) {
    if (const Objection repeated = repeatedSpoke(context.state.pivot.fan)) return repeated;
    const Objection spoke = takenSpoke(context);
    return spoke ? spoke : takenRim(context);
}

// ---- nopillow -----------------------------------------------------------------------------------

/// A second triangle on the same three points (RobustRules::noPillow).
Objection pillow(const StepContext& context) {
    const State& s = context.state;
    const Fan& fan = s.pivot.fan;
    const Index p = s.rings.point(s.pivot.pivot);
    if (s.pivot.fullTurn && fan.size() == 3) return {Verdict::Pillow, 0, true};
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
        if (fan[i].entry == kNone || fan[i + 1].entry == kNone) continue;
        const HalfEdge h = s.edges.find(fan[i + 1].point, fan[i].point);
        if (h != kNone && s.edges.opposite(h) == p) return {Verdict::Pillow, i, true};
    }
    return {};
}

// ---- the table ----------------------------------------------------------------------------------

struct FanRule {
    bool RobustRules::*on;
    Objection (*find)(const StepContext&);
    bool RobustRules::*orOn = on;

    bool isOn(const RobustRules& rules) const { return rules.*on || rules.*orOn; }
};

constexpr std::array kManifoldRules{
    FanRule{&RobustRules::guard, takenEdge},
    FanRule{&RobustRules::noPillow, pillow},
};
constexpr std::array kShapeRules{
    FanRule{&RobustRules::noCross, crossing},
    FanRule{&RobustRules::noFold, fold},
    FanRule{&RobustRules::rim, beyondWall},
};
/// These object only where isFlatAround() is false. They search in one pass.
constexpr std::array kBentRules{
    FanRule{&RobustRules::noMeet, conflictsWithFinished, &RobustRules::noLayer},
};
/// These drop no candidate: the fan is refused.
constexpr std::array kWaitingRules{
    FanRule{&RobustRules::gap, wideGap},
    FanRule{&RobustRules::rim, overRim},
    FanRule{&RobustRules::delay, steep},
};

/// True if one of the rules objects to the fan.
bool refuses(std::span<const FanRule> rules, const StepContext& context) {
    return std::any_of(rules.begin(), rules.end(), [&](const FanRule& rule) {
        return rule.isOn(context.params.robust) && rule.find(context);
    });
}

/// The candidate to drop for an objection: the farther one of a triangle. kNone if there is none.
std::size_t candidateToDrop(const Fan& fan, const Objection& objection) {
    const std::size_t i = objection.at;
    if (!objection.triangle) return fan[i].candidate ? i : kNone;
    if (fan[i].candidate && fan[i + 1].candidate) {
        return fan[i].lengthSq > fan[i + 1].lengthSq ? i : i + 1;
    }
    if (fan[i].candidate) return i;
    return fan[i + 1].candidate ? i + 1 : kNone;
}

/// The evidence of an objection, which drops a candidate if one is at fault and that is allowed.
GuardEvidence evidenceOf(const Fan& fan, const Objection& objection, bool mayDrop) {
    const std::size_t drop = mayDrop ? candidateToDrop(fan, objection) : kNone;
    return {objection.verdict, fan[objection.at].point,
            objection.triangle ? fan[objection.at + 1].point : kNone,
            drop == kNone ? kNone : fan[drop].point};
}

/// The first objection that is not overridden. A what-if for the point to be dropped, or for the
/// pivot if the fan would be refused, overrides the rule for this fan.
std::optional<GuardEvidence> firstStandingObjection(AnyContext auto& context,
                                                    std::span<const FanRule> rules,
                                                    bool mayDrop = true) {
    const NeighborRing& n = context.state.pivot;
    for (const FanRule& rule : rules) {
        if (!rule.isOn(context.params.robust)) continue;
        const Objection objection = rule.find(context);
        if (!objection) continue;
        GuardEvidence found = evidenceOf(n.fan, objection, mayDrop);
        const Index subject =
            found.dropped == kNone ? context.state.rings.point(n.pivot) : found.dropped;
        if (whatIfOverride(context, Stage::Guard, subject) != true) return found;
        found.verdict = Verdict::WhatIfKept;
        found.dropped = subject;
        note(context, Stage::Guard, [&] { return found; });
    }
    return std::nullopt;
}

void refuse(StepContext& context) {
    State& s = context.state;
    ++s.counters.refused;
    s.phase = Phase::Advance;
    if (context.waiting != nullptr)
        context.waiting->refuse(s.pivot.pivot, s.counters.pivots, s.retryLevel);
}

void retryWithout(StepContext& context, Index point) {
    NeighborRing& n = context.state.pivot;
    const auto found = std::find_if(n.pool.begin(), n.pool.end(),
                                    [&](const Candidate& c) { return c.point == point; });
    n.pool.erase(found);
    n.candidates = n.pool;
    context.state.phase = Phase::Sphere;
}

}  // namespace

void phaseGuard(AnyContext auto& context) {
    layOutFan(context);
    const Index pivot = context.state.rings.point(context.state.pivot.pivot);
    if (whatIfOverride(context, Stage::Guard, pivot) == false) {
        note(context, Stage::Guard, [&] {
            return GuardEvidence{Verdict::WhatIfDropped, kNone, kNone, pivot};
        });
        return refuse(context);
    }
    std::optional<GuardEvidence> found = firstStandingObjection(context, kWaitingRules, false);
    if (!found) found = firstStandingObjection(context, kManifoldRules);
    if (!found) found = firstStandingObjection(context, kShapeRules);
    if (!found && !isFlatAround(context)) found = firstStandingObjection(context, kBentRules);
    if (!found) {
        context.state.phase = Phase::Emit;
        return;
    }
    note(context, Stage::Guard, [&] { return *found; });
    if (found->dropped == kNone) {
        refuse(context);
    } else {
        retryWithout(context, found->dropped);
    }
}

bool manifoldRefuses(const StepContext& context) { return refuses(kManifoldRules, context); }

bool shapeRefuses(const StepContext& context) {
    return refuses(kShapeRules, context) ||
           (!isFlatAround(context) && refuses(kBentRules, context));
}

template void phaseGuard(UnloggedContext&);
template void phaseGuard(LoggedContext&);

}  // namespace se
