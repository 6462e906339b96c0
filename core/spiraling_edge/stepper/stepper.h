/// The algorithm, one phase at a time. There is one stepper: the debugger runs the code that the
/// benchmark times.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "spiraling_edge/points/shared_points.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/robust/waiting_fans.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

/// Whether isRim() holds for a point (step_context.h).
enum class RimAnswer : std::uint8_t;

/// The points as a what-if changes them, from a pivot on.
struct EditedPoints {
    std::uint32_t from = 0;
    PointSet points;
};

/// The points as Move and List leave them, each from a pivot on, in the order of the run; empty
/// without such.
std::vector<EditedPoints> editedPoints(const PointSet& points, const Params& params);

/// The points as the rules take them: where angles grow clockwise (PaperRules::turn), normals and
/// the gaps of rim points are turned over in a copy, so that no rule asks for the direction.
SharedPoints turnedPoints(SharedPoints points, const Params& params);

/// The reason why runUntil() returned.
enum class StopReason : std::uint8_t {
    Finished,   ///< Every point is DONE.
    Condition,  ///< The condition held.
    Observer,   ///< The observer stopped it.
    Capped,     ///< AlertKind::TriangleCap.
};

/// Callback for each decision, in order, after the phase that made it. Returns true to stop the
/// run; the other decisions of that phase, which are made already, are still reported.
using DecisionObserver = std::function<bool(const Event&)>;

/// Runs the Spiraling Edge algorithm on a State. The points must pass validate(); they are never
/// written.
///
/// Example: `Stepper stepper(points, params); while (stepper.stepPivot()) draw(stepper.state());`
class Stepper {
  public:
    /// Every decision is appended to `log` unless it is null; see setLog(). Requires that
    /// requireStart() succeeds for params.start.
    Stepper(SharedPoints points, const Params& params, EventLog* log = nullptr);

    /// Runs one phase of a pivot. Returns false, doing nothing, if the run is finished.
    bool advance();
    /// Runs to the end of the current pivot, or of the next one if between two (including its
    /// seed). Returns false if no pivot was left (stranded points at the very end are still
    /// marked), or if the observer stopped it before that end.
    bool stepPivot();
    /// Runs whole pivots until the condition holds between two of them, or to the end.
    StopReason runUntil(const std::function<bool(const State&)>& condition);
    /// Runs to the end.
    StopReason run();

    const State& state() const { return state_; }
    /// Goes to another place of a run over the same points and params.
    void setState(State state) { exchangeState(std::move(state)); }
    /// As setState(); returns the previous State.
    State exchangeState(State state) {
        observed_.clear();
        stopped_ = false;
        if (waiting_) waiting_->forget();
        return std::exchange(state_, std::move(state));
    }
    /// Moves the state out, e.g. for its triangles. The stepper starts over.
    State takeState();
    /// Frees the table of edges after the last pivot, which nothing after it needs: for runs that
    /// never go back.
    void freePast();
    void setLog(EventLog* log) { log_ = log; }
    /// An observer that is shown every decision from now on, with or without a log; none if empty.
    /// Where it stops the run, the phase of that decision is complete: PivotReplay gives the state
    /// at the decision itself. The next call goes on.
    void setObserver(DecisionObserver observer) {
        observer_ = std::move(observer);
        stopped_ = false;
    }
    /// True if the observer stopped the last call.
    bool stopped() const { return stopped_; }
    /// The points at the current place: what-ifs may change them during a run.
    const PointSet& points() const;
    const Params& params() const { return params_; }

  private:
    /// Calls work(context) in the variant with or without a log, chosen once per call and not in
    /// the phases.
    template <typename Work>
    bool inContext(Work&& work);
    bool stepPivotObserved();
    /// The last of these sets that begins at or before the current place, else the input.
    const PointSet& setAt(const std::vector<EditedPoints>& sets) const;
    StopReason reason() const;

    SharedPoints points_;
    Params params_;
    std::vector<EditedPoints> edited_;
    std::vector<EditedPoints> turned_;  ///< turnedPoints() of all, input first; empty: as given.
    /// Non-default paper rules or what-ifs: such a run takes the logging code path also without a
    /// log, always or at the pivots of the what-ifs.
    bool altered_;
    std::vector<RimAnswer> rimAnswers_;  ///< Empty where what-ifs change the points.
    /// Null where no fan is refused, and with non-default paper rules or what-ifs.
    std::unique_ptr<WaitingFans> waiting_;
    State state_;
    EventLog* log_;
    DecisionObserver observer_;
    EventLog observed_;  ///< The decisions of the present pivot, for an observer without a log.
    bool stopped_ = false;
};

}  // namespace se
