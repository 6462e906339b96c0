/// The phases of a pivot, one function each; stepper.cpp calls them in the order of State::phase.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/robust/waiting_fans.h"
#include "spiraling_edge/stepper/rules.h"
#include "spiraling_edge/stepper/state.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

/// Whether isRim() holds for a point.
enum class RimAnswer : std::uint8_t { Unknown, No, Yes };

/// The context of a phase.
struct StepContext {
    const PointSet& points;
    const Params& params;
    State& state;
    /// Per point: what isRim() found, since it is the same for the whole run; null: not kept.
    RimAnswer* rimAnswers = nullptr;
    /// The fans that would be refused again; null: not kept.
    WaitingFans* waiting = nullptr;

    const Vec3& positionAt(Index entry) const { return points.position[state.rings.point(entry)]; }
    const Vec3& normalAt(Index entry) const { return points.normal[state.rings.point(entry)]; }
    /// True if the rules know that the step from `entry` is no mesh edge (Readings::openSteps).
    bool openStep(Index entry) const {
        return params.readings.openSteps && state.rings.open(entry);
    }
    /// isRim() by the threshold of the run (RobustRules::rim), found out once per point.
    bool passesRim(Index p) const {
        RimAnswer here = RimAnswer::Unknown;
        RimAnswer& answer = rimAnswers == nullptr ? here : rimAnswers[p];
        if (answer == RimAnswer::Unknown)
            answer =
                isRim(points, p, params.thresholds.rimGapCosine) ? RimAnswer::Yes : RimAnswer::No;
        return answer == RimAnswer::Yes;
    }
    /// Notes that a ring step or triangle at the point changes in this pivot.
    void change(Index p) const {
        if (waiting != nullptr) waiting->change(p, state.counters.pivots);
    }
};

// Phases are compiled twice, for a context with a log and for one without: a branch at each event
// would cost 1 to 4 percent even without a log (docs/performance.md).

/// No log: events are not made.
struct UnloggedContext : StepContext {};
/// Every decision goes to the log.
struct LoggedContext : StepContext {
    EventLog& log;
};
template <typename T>
concept AnyContext = std::is_same_v<T, UnloggedContext> || std::is_same_v<T, LoggedContext>;
template <AnyContext Context>
constexpr bool kLogging = std::is_same_v<Context, LoggedContext>;

inline constexpr PaperRules kDefaultPaperRules{};
/// The paper's rules of the run. Without a log they are the defaults, known at compile time: runs
/// with non-default paper rules take the logging code path.
template <AnyContext Context>
constexpr const PaperRules& paperRules(const Context& context) {
    if constexpr (kLogging<Context>) return context.params.paper;
    return kDefaultPaperRules;
}

/// Logs an event of `pivot` with the evidence that `make` returns; nothing without a log.
template <AnyContext Context, typename MakeEvidence>
void noteAt(Context& context, std::uint32_t pivot, Stage stage, const MakeEvidence& make) {
    if constexpr (kLogging<Context>) context.log.add(pivot, stage, make());
}
/// Logs an event of the current pivot.
template <typename MakeEvidence>
void note(AnyContext auto& context, Stage stage, const MakeEvidence& make) {
    noteAt(context, context.state.counters.pivots, stage, make);
}

// phases/what_if_phase.cpp
/// The what-if for a point tested at this stage of the current pivot: true keeps it, false drops
/// it; nothing without one.
std::optional<bool> findWhatIfOverride(const StepContext& context, Stage stage, Index point);
/// The what-if for a point as above. Without a log there is none: runs take the logging path at
/// every what-if.
template <AnyContext Context>
std::optional<bool> whatIfOverride(const Context& context, Stage stage, Index point) {
    if constexpr (kLogging<Context>) return findWhatIfOverride(context, stage, point);
    return std::nullopt;
}
/// A verdict after a what-if: unchanged if there is none, or if it agrees.
inline Verdict applyOverride(Verdict verdict, std::optional<bool> forced, bool keeps) {
    if (!forced || *forced == keeps) return verdict;
    return *forced ? Verdict::WhatIfKept : Verdict::WhatIfDropped;
}
/// Applies a what-if of the kind Pivot after a pivot.
void redirect(LoggedContext& context);

// phases/start.cpp: §4
void phaseSeed(AnyContext auto& context);
void phasePivot(AnyContext auto& context);
/// Makes `entry` the pivot, with first and last, start at first and end at last, the frame and the
/// angles.
void setPivot(StepContext& context, Index entry);
/// The free sector at an entry, from the entry before it to the one after it, for the log.
double sectorDegrees(const StepContext& context, Index entry);
// phases/sort.cpp: §6.1
void phaseSort(AnyContext auto& context);
// phases/limits.cpp: §6.1
void phaseLimits(AnyContext auto& context);
void phaseConvex(AnyContext auto& context);
void phaseReciprocal(AnyContext auto& context);
// phases/hole.cpp: §6.2
void phaseHole(AnyContext auto& context);
// phases/circumsphere.cpp: §6.3
void phaseSphere(AnyContext auto& context);
// phases/emit.cpp: §6.4
void phaseTwoPoint(AnyContext auto& context);
void phaseEmit(AnyContext auto& context);
/// Fills NeighborRing::fan from the remaining candidates.
void layOutFan(StepContext& context);
// robust/guard.cpp: beyond the paper
void phaseGuard(AnyContext auto& context);
/// True if a rule that keeps the mesh a manifold (RobustRules::guard, RobustRules::noPillow) would
/// refuse the fan.
bool manifoldRefuses(const StepContext& context);
/// True if a rule on faults of shape (RobustRules::noFold, RobustRules::noCross,
/// RobustRules::noMeet, RobustRules::noLayer, beyondWall() of RobustRules::rim) would refuse the
/// fan.
bool shapeRefuses(const StepContext& context);
// robust/fill.cpp: beyond the paper
void phaseFill(AnyContext auto& context);
/// True if the active ring should be closed by ears instead of being freed.
bool mayFill(const StepContext& context);
/// True if the surface may end at the active ring: more than two in three of its points are rim
/// points by type; or, with RobustRules::rim, boundary points, or points where the surface ends and
/// the ring is wide; or the ring, of more than five, runs around a patch. The last needs
/// State::edges.
bool isOpening(const StepContext& context);
// phases/ring_update.cpp: §6.5
void phaseRing(AnyContext auto& context);
void phaseLink(AnyContext auto& context);
void phaseAdvance(AnyContext auto& context);
// phases/finish.cpp: §3
/// Ends the run, with an event that sums up its mesh.
void finishRun(AnyContext auto& context);
// robust/repair.cpp: beyond the paper, after the last pivot
/// Goes to the first phase after the last pivot whose rule is on, else ends the run.
void beginRepairPhases(AnyContext auto& context);
void phaseReinsert(AnyContext auto& context);
void phaseFlip(AnyContext auto& context);
void phaseRemesh(AnyContext auto& context);
void phaseDropFans(AnyContext auto& context);
void phaseDropPatch(AnyContext auto& context);
void phaseCloseHole(AnyContext auto& context);
// phases/boundary.cpp: §7
/// Decides whether a boundary point may be a pivot; if so, inserts the third point of §7.1 or §7.2.
/// False: pass over it.
bool tryBoundaryPivot(AnyContext auto& context);
/// Removes the third point after a pivot that made no triangle.
void removeThirdPoint(StepContext& context);

}  // namespace se
