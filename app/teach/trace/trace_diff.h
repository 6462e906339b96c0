/// Comparison of a trace with the run of this program: the first pivot that differs, and the
/// decisions that account for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setrace.h"
#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/points/shared_points.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se::teach {

/// A point that only one of the two has, and our decision about it; or a decision of ours that led
/// to the pivot, its rings or its lack of triangles.
struct TraceReason {
    Index point = kNone;   ///< kNone: `decision` is a sentence.
    bool inTrace = false;  ///< The trace has the point; else only our run.
    std::string decision;  ///< "moved start to it", "left it out: beyond last"
    std::optional<Address> address;
};

/// The first pivot that differs.
struct TraceDifference {
    std::size_t pivot = 0;            ///< From 1.
    std::string what;                 ///< "the fans differ"
    std::optional<TraceStage> stage;  ///< That differs; nothing if it is the pivot itself.
    std::optional<TracePivot> trace;  ///< Nothing: the trace has ended. It may end in a pivot.
    std::optional<TracePivot> run;    ///< Nothing: the run has ended.
    std::vector<TraceReason> reasons;
    /// Results of both, where they are no lists of candidates: "start: yours 19, ours 18".
    std::vector<std::string> both;
    /// Pivots of our whole run, where the trace ends before it, alike so far; otherwise 0.
    std::size_t runPivots = 0;
};

/// The outcome of a comparison.
struct TraceComparison {
    std::size_t alike = 0;  ///< Pivots before the difference, or all.
    std::optional<TraceDifference> difference;
};

/// Compares pivot by pivot: p, first and last, then of the stages those that the trace has.
/// `upto`: no stage after this one. A trace that ends before the run differs, unless its last pivot
/// has TracePivot::ends. Fails if cancelled. Requires requireTraceOf().
Result<TraceComparison> compareTrace(const Trace& trace, const SharedPoints& points,
                                     const Params& params, std::optional<TraceStage> upto,
                                     const Progress& progress = {});

/// The number of pivots of the trace that a run under `params` repeats, and whether it is the whole
/// trace: the cheap part of compareTrace().
struct TraceMatch {
    std::size_t alike = 0;
    bool whole = false;
};
TraceMatch matchTrace(const Trace& trace, const SharedPoints& points, const Params& params,
                      std::optional<TraceStage> upto);

/// "alike as far as yours goes, 5 pivots and pivot 6 up to limits; ours goes on to 83 pivots", and
/// what to write if that is meant. Requires TraceDifference::runPivots.
std::string earlyEndText(const TraceComparison& comparison);
/// "pivot 8 (point 11 between 1 and 3): the fans differ"
std::string headText(const TraceDifference& difference);
/// "yours has no 17: ours moved start to it, 8.limits.1 (6.1)"
std::string reasonText(const TraceReason& reason);
/// The difference in lines of text: "after 7 pivots alike, pivot 8 (point 11 between 1 and 3): the
/// fans differ", then a line for each result of both and for each reason.
std::string differenceText(const TraceComparison& comparison);

}  // namespace se::teach
