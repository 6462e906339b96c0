/// The phases of a pivot, one function each; stepper.cpp calls them in the order of State::phase.
#pragma once

#include <type_traits>

#include "spiraling_edge/event.h"
#include "spiraling_edge/params.h"
#include "spiraling_edge/point_set.h"
#include "spiraling_edge/rules.h"
#include "spiraling_edge/state.h"

namespace se {

/// What a phase works on. `log` is null unless someone listens.
struct StepContext {
    const PointSet& points;
    const Params& params;
    State& state;
    EventLog* log;

    /// Someone wants to see the events. The benchmark compiles the core once more with
    /// SPIRALING_EDGE_WITHOUT_LOG, to measure what the question costs.
    bool listening() const {
#ifdef SPIRALING_EDGE_WITHOUT_LOG
        return false;
#else
        return log != nullptr;
#endif
    }

    const Vec3& positionAt(Index entry) const { return points.position[state.rings.point(entry)]; }
    const Vec3& normalAt(Index entry) const { return points.normal[state.rings.point(entry)]; }
    /// The step from `entry` is no mesh edge, as far as the rules know (Rules::openSteps).
    bool openStep(Index entry) const { return params.rules.openSteps && state.rings.open(entry); }
};

// phase_start.cpp: §4
void phaseSeed(StepContext& context);
void phasePivot(StepContext& context);
/// Makes `entry` the pivot, with first and last, start at first and end at last, the frame and the
/// angles.
void setPivot(StepContext& context, Index entry);
// phase_sort.cpp: §6.1
void phaseSort(StepContext& context);
// phase_limits.cpp: §6.1
void phaseLimits(StepContext& context);
void phaseConvex(StepContext& context);
void phaseReciprocal(StepContext& context);
// phase_thin.cpp: §6.2, §6.3
void phaseHole(StepContext& context);
void phaseSphere(StepContext& context);
// phase_triangles.cpp: §6.4
void phaseTwoPoint(StepContext& context);
void phaseEmit(StepContext& context);
/// Lays out NeighborRing::fan from the candidates that are left.
void layOutFan(StepContext& context);
// phase_guard.cpp: beyond the paper
void phaseGuard(StepContext& context);
/// Would a rule that keeps the mesh a manifold (Rules::guard, Rules::noPillow) refuse the fan?
bool manifoldRefuses(const StepContext& context);
/// Would any rule on faults of shape (Rules::noFold, Rules::noCross, Rules::noMeet) refuse it?
bool shapeRefuses(const StepContext& context);
// phase_fill.cpp: beyond the paper
void phaseFill(StepContext& context);
/// Should the active ring be closed by ears instead of being freed?
bool mayFill(const StepContext& context);
/// Rules::rim is on, and more than two in three points of the active ring lie where the surface
/// ends.
bool isOpening(const StepContext& context);
// phase_update.cpp: §6.5
void phaseRing(StepContext& context);
void phaseLink(StepContext& context);
void phaseAdvance(StepContext& context);
// phase_mend.cpp: beyond the paper, after the last pivot
/// Goes to the first phase after the last pivot that a rule asks for, else to Finished.
void beginMendPhases(StepContext& context);
void phaseReinsert(StepContext& context);
void phaseFlip(StepContext& context);
void phaseReseat(StepContext& context);
// phase_boundary.cpp: §7
/// Decides whether a boundary point may be a pivot, and puts the third point of §7.1 or §7.2 on the
/// ring if so. False: pass over it.
bool admitBoundaryPivot(StepContext& context);
/// Takes the third point off the ring again, after a pivot that made no triangle.
void withdrawThirdPoint(StepContext& context);

template <typename MakeEvidence>
[[gnu::noinline, gnu::cold]] void addEvent(StepContext& context, Stage stage,
                                           const MakeEvidence& make) {
    context.log->add(context.state.counters.pivots, stage, make());
}

/// Adds an event if someone listens. `make` is called only then, and out of the way: what remains
/// of it in the phases is one comparison.
template <typename MakeEvidence>
[[gnu::always_inline]] inline void note(StepContext& context, Stage stage,
                                        const MakeEvidence& make) {
    if (context.listening()) [[unlikely]]
        addEvent(context, stage, make);
}

/// note() where the caller knows already whether someone listens, see withOrWithoutEvents().
template <bool kNoted, typename MakeEvidence>
[[gnu::always_inline]] inline void noteIf(StepContext& context, Stage stage,
                                          const MakeEvidence& make) {
    if constexpr (kNoted) addEvent(context, stage, make);
}

/// Calls `work` with a constant that says whether someone listens: inner loops that add events are
/// compiled once with them and once without, so that nobody pays for what nobody hears.
template <typename Work>
[[gnu::always_inline]] inline void withOrWithoutEvents(const StepContext& context, Work&& work) {
    if (context.listening()) [[unlikely]] {
        work(std::true_type{});
    } else {
        work(std::false_type{});
    }
}

}  // namespace se
