/// Beyond the paper (docs/robust.md): the table of the rules that examine the whole fan. A
/// candidate that a rule objects to is dropped and §6.3 repeated without it; if there is none to
/// drop, the fan is refused.
#include <algorithm>
#include <array>

#include "spiraling_edge/stepper/robust/fan_rules.h"

namespace se {
namespace {

/// Consequence of an objection.
enum class Consequence : std::uint8_t {
    Drop,    ///< The candidate at fault is dropped; without one the fan is refused.
    Refuse,  ///< The fan is refused.
};

struct FanRule {
    bool RobustRules::*on;
    Objection (*find)(const StepContext&);
    Consequence consequence;
};

constexpr std::array kManifoldRules{
    FanRule{&RobustRules::guard, takenEdge, Consequence::Drop},
    FanRule{&RobustRules::noPillow, pillow, Consequence::Drop},
};
constexpr std::array kShapeRules{
    FanRule{&RobustRules::noCross, crossing, Consequence::Drop},
    FanRule{&RobustRules::noFold, fold, Consequence::Drop},
    FanRule{&RobustRules::noMeet, meetsFinished, Consequence::Drop},
};
constexpr std::array kWaitingRules{
    FanRule{&RobustRules::gap, wideGap, Consequence::Refuse},
    FanRule{&RobustRules::rim, overRim, Consequence::Refuse},
    FanRule{&RobustRules::delay, steep, Consequence::Refuse},
};

template <std::size_t N>
const FanRule* firstObjecting(const StepContext& context, const std::array<FanRule, N>& rules,
                              Objection& objection) {
    for (const FanRule& rule : rules) {
        if (!(context.params.robust.*rule.on)) continue;
        objection = rule.find(context);
        if (objection) return &rule;
    }
    return nullptr;
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

/// The evidence of an objection and its consequence.
GuardEvidence evidenceOf(const Fan& fan, const FanRule& rule, const Objection& objection) {
    const std::size_t drop =
        rule.consequence == Consequence::Refuse ? kNone : candidateToDrop(fan, objection);
    return {objection.verdict, fan[objection.at].point,
            objection.triangle ? fan[objection.at + 1].point : kNone,
            drop == kNone ? kNone : fan[drop].point};
}

/// The first objection that is not overridden. A what-if for the point to be dropped, or for the
/// pivot if the fan would be refused, overrides the rule for this fan.
template <AnyContext Context, std::size_t N>
std::optional<GuardEvidence> firstStandingObjection(Context& context,
                                                    const std::array<FanRule, N>& rules) {
    const NeighborRing& n = context.state.pivot;
    for (const FanRule& rule : rules) {
        if (!(context.params.robust.*rule.on)) continue;
        const Objection objection = rule.find(context);
        if (!objection) continue;
        GuardEvidence found = evidenceOf(n.fan, rule, objection);
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
    ++context.state.counters.refused;
    context.state.phase = Phase::Advance;
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
    std::optional<GuardEvidence> found = firstStandingObjection(context, kWaitingRules);
    if (!found) found = firstStandingObjection(context, kManifoldRules);
    if (!found) found = firstStandingObjection(context, kShapeRules);
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

bool manifoldRefuses(const StepContext& context) {
    Objection objection;
    return firstObjecting(context, kManifoldRules, objection) != nullptr;
}

bool shapeRefuses(const StepContext& context) {
    Objection objection;
    return firstObjecting(context, kShapeRules, objection) != nullptr;
}

template void phaseGuard(UnloggedContext&);
template void phaseGuard(LoggedContext&);

}  // namespace se
