/// The algorithm, one phase at a time. There is one stepper: the debugger steps what the benchmark
/// times.
#pragma once

#include <functional>
#include <utility>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/edited_points.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

/// Why runUntil() came back.
enum class StopReason : std::uint8_t {
    Finished,   ///< Every point is DONE.
    Condition,  ///< The condition held.
    Capped,     ///< AlertKind::TriangleCap.
};

/// Runs the Spiraling Edge algorithm on a State. Holds no state of its own but references:
/// points must outlive it and pass validate(); they are never written.
///
/// Example: `Stepper stepper(points, params); while (stepper.stepPivot()) draw(stepper.state());`
class Stepper {
  public:
    /// Every decision is appended to `log` unless it is null; see setLog().
    Stepper(const PointSet& points, const Params& params, EventLog* log = nullptr);

    /// Runs one phase of a pivot. Returns false, doing nothing, if the run is finished.
    bool advance();
    /// Runs to the end of the present pivot, or of the next one if between two (its seed included).
    /// Returns false if no pivot was left (stranded points at the very end are still marked).
    bool stepPivot();
    /// Runs whole pivots until the condition holds between two of them, or to the end.
    StopReason runUntil(const std::function<bool(const State&)>& condition);
    /// Runs to the end.
    StopReason run();

    const State& state() const { return state_; }
    /// Goes to another place of a run over the same points and params.
    void setState(State state) { state_ = std::move(state); }
    /// The same, and returns the State from before.
    State exchangeState(State state) { return std::exchange(state_, std::move(state)); }
    /// Gives the state away, e.g. to take the triangles out. The stepper starts over.
    State takeState();
    void setLog(EventLog* log) { log_ = log; }
    /// At the present place: what-ifs may change them on the way.
    const PointSet& points() const;
    const Params& params() const { return params_; }

  private:
    /// Calls work(context), with a log or without: what listens is asked once per call, not in the
    /// phases.
    template <typename Work>
    bool inContext(Work&& work);

    const PointSet& points_;
    Params params_;
    std::vector<EditedPoints> edited_;
    /// The paper's own rules are not as usual, or something else happens somewhere: such a run is
    /// heard whether there is a log or not.
    bool altered_;
    State state_;
    EventLog* log_;
};

}  // namespace se
