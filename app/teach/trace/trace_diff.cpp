// Both runs go side by side until the first pivot that differs; only that pivot's events are kept.
#include "trace_diff.h"

#include <algorithm>
#include <cassert>

#include "trace_reasons.h"

namespace se::teach {
namespace {

/// The run of this program under the trace.
class TracedRun {
  public:
    TracedRun(const SharedPoints& points, const Params& params, TraceDetail detail, bool logged)
        : detail_(detail), stepper_(points, params, logged ? &log_ : nullptr) {}

    /// The next pivot; nothing at the end of the run.
    std::optional<TracePivot> next() {
        log_.clear();
        while (true) {
            TraceStep step = stepTraced(stepper_, detail_);
            if (step.pivot || !step.ran) return std::move(step.pivot);
        }
    }
    const std::vector<Event>& events() const { return log_.events(); }

  private:
    TraceDetail detail_;
    EventLog log_;
    Stepper stepper_;
};

/// The detail of the run that a comparison with the trace needs.
TraceDetail detailOf(const Trace& trace) {
    const auto hasStages = [](const TracePivot& pivot) {
        return pivot.next || pivot.start || pivot.end ||
               std::any_of(traceStages().begin(), traceStages().end(),
                           [&](const TraceStageRow& row) {
                               return row.id != TraceStage::Emit && pivot.*row.points;
                           });
    };
    return std::any_of(trace.pivots.begin(), trace.pivots.end(), hasStages) ? TraceDetail::Stages
                                                                            : TraceDetail::Fans;
}

bool isSamePivot(const TracePivot& a, const TracePivot& b) {
    return a.p == b.p && a.first == b.first && a.last == b.last;
}

/// True if a stage differs, as far as the trace has it. A pivot that was passed over has no
/// candidates after any stage, and no limits.
bool stageDiffers(const TraceStageRow& row, const TracePivot& trace, const TracePivot& run) {
    const TracedPoints& theirs = trace.*row.points;
    if (theirs && *theirs != (run.*row.points).value_or(std::vector<Index>{})) return true;
    if (row.id == TraceStage::Limits && run.start)
        return (trace.start && trace.start != run.start) || (trace.end && trace.end != run.end);
    return row.id == TraceStage::Ring && trace.next && trace.next != run.next;
}

/// The first stage that differs; nothing if none does.
std::optional<TraceStage> firstDifference(const TracePivot& trace, const TracePivot& run,
                                          TraceStage upto) {
    for (const TraceStageRow& row : traceStages()) {
        if (row.id > upto) break;
        if (stageDiffers(row, trace, run)) return row.id;
    }
    return std::nullopt;
}

std::string pivotText(const TracePivot& pivot) {
    return "point " + std::to_string(pivot.p) + " between " + std::to_string(pivot.first) +
           " and " + std::to_string(pivot.last);
}

std::string whereText(const TraceReason& reason) {
    if (!reason.address) return {};
    const std::string_view section = stageSection(reason.address->stage);
    return ", " + toString(*reason.address) +
           (section.empty() ? std::string() : " (" + std::string(section) + ")");
}

std::string countedPivots(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " pivot" : " pivots");
}

/// The end of a trace that is alike so far, at our next pivot or in it.
TraceDifference earlyEnd(std::optional<TracePivot> trace, TracePivot ours, TracedRun& run,
                         std::size_t alike) {
    TraceDifference found;
    found.trace = std::move(trace);
    found.run = std::move(ours);
    found.runPivots = alike + 1;
    while (run.next()) ++found.runPivots;
    found.what = "the trace ends, our run goes on";
    return found;
}

/// The last stage that a pivot has; nothing if it has none.
std::optional<TraceStage> lastStage(const TracePivot& pivot) {
    std::optional<TraceStage> last;
    for (const TraceStageRow& row : traceStages()) {
        if (pivot.*row.points) last = row.id;
    }
    return last;
}

}  // namespace

Result<TraceComparison> compareTrace(const Trace& trace, const SharedPoints& points,
                                     const Params& params, std::optional<TraceStage> upto,
                                     const Progress& progress) {
    assert(trace.points == points->size());
    TracedRun run(points, params, detailOf(trace), true);
    TraceComparison comparison;
    std::vector<Event> before;
    RingChanges changes;
    while (true) {
        const bool ended = comparison.alike == trace.pivots.size();
        if (ended && comparison.alike > 0 && trace.pivots.back().ends) return comparison;
        if (progress && !progress(static_cast<double>(comparison.alike) /
                                  static_cast<double>(trace.pivots.size() + 1)))
            return Error{"cancelled"};
        before = run.events();
        takeRingChanges(before, changes);
        std::optional<TracePivot> ours = run.next();
        if (ended && !ours) return comparison;
        std::optional<TracePivot> theirs;
        if (!ended) theirs = trace.pivots[comparison.alike];
        std::optional<TraceStage> stage;
        bool endsEarly = ended;
        if (ours && theirs && isSamePivot(*theirs, *ours)) {
            stage = firstDifference(*theirs, *ours, upto.value_or(TraceStage::Ring));
            // Only the last pivot of a trace may lack its last stages.
            endsEarly =
                !stage && !theirs->ends && !hasStage(*theirs, upto.value_or(TraceStage::Emit));
            if (!stage && !endsEarly) {
                ++comparison.alike;
                continue;
            }
        }
        comparison.difference =
            endsEarly ? earlyEnd(std::move(theirs), std::move(*ours), run, comparison.alike)
                      : differenceAt(std::move(*theirs), std::move(ours), stage, before, changes,
                                     run.events(), *points);
        comparison.difference->pivot = comparison.alike + 1;
        return comparison;
    }
}

TraceMatch matchTrace(const Trace& trace, const SharedPoints& points, const Params& params,
                      std::optional<TraceStage> upto) {
    assert(trace.points == points->size());
    TracedRun run(points, params, detailOf(trace), false);
    TraceMatch match;
    for (const TracePivot& theirs : trace.pivots) {
        const std::optional<TracePivot> ours = run.next();
        if (!ours || !isSamePivot(theirs, *ours) ||
            firstDifference(theirs, *ours, upto.value_or(TraceStage::Ring)))
            return match;
        ++match.alike;
    }
    const bool mayEnd = match.alike > 0 && trace.pivots.back().ends;
    match.whole = mayEnd || !run.next();
    return match;
}

std::string earlyEndText(const TraceComparison& comparison) {
    const TraceDifference& found = *comparison.difference;
    const auto reached = found.trace ? lastStage(*found.trace) : std::nullopt;
    if (comparison.alike == 0 && !reached) {
        return "yours has no pivots, ours has " + std::to_string(found.runPivots) +
               ": nothing is compared";
    }
    std::string text = "alike as far as yours goes, " + countedPivots(comparison.alike);
    if (reached) {
        text += " and pivot " + std::to_string(found.pivot) + " up to " +
                std::string(rowOf(*reached).name);
    }
    return text + "; ours goes on to " + countedPivots(found.runPivots) +
           "\n  the last line of a trace that is meant to end early has \"ends\": true";
}

std::string headText(const TraceDifference& found) {
    const bool otherPivot = !found.stage && found.trace && found.run;
    return "pivot " + std::to_string(found.pivot) + " (" +
           (otherPivot ? "yours: " + pivotText(*found.trace) + "; ours: " + pivotText(*found.run)
                       : pivotText(found.run ? *found.run : *found.trace)) +
           "): " + found.what;
}

std::string reasonText(const TraceReason& reason) {
    const std::string yours = reason.inTrace ? "yours has " : "yours has no ";
    return (reason.point != kNone ? yours + std::to_string(reason.point) + ": ours "
                                  : std::string("ours: ")) +
           reason.decision + whereText(reason);
}

std::string differenceText(const TraceComparison& comparison) {
    const std::string alike = countedPivots(comparison.alike) + " alike";
    if (!comparison.difference) return "all " + alike + "\n";
    const TraceDifference& found = *comparison.difference;
    if (found.runPivots > 0) return earlyEndText(comparison) + "\n";
    std::string text = "after " + alike + ", " + headText(found) + "\n";
    for (const std::string& each : found.both) text += "  " + each + "\n";
    for (const TraceReason& each : found.reasons) text += "  " + reasonText(each) + "\n";
    return text;
}

}  // namespace se::teach
