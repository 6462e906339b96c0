// Both runs go side by side until the first pivot that differs; only that pivot's events are kept.
#include "trace_diff.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <unordered_map>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "teach/play_moves.h"

namespace se::teach {
namespace {

/// The last change of the rings about each point.
using RingChanges = std::unordered_map<Index, Event>;

std::string_view sideText(Side side) { return side == Side::Start ? "start" : "end"; }

/// The effect of a decision on its point: "moved start to it", "kept it: inside sphere".
std::string decisionText(const Event& event) {
    if (const auto* limit = as<LimitEvidence>(event))
        return "moved " + std::string(sideText(limit->side)) + " to it";
    if (verdictOf(event) == Verdict::Kept) return "kept it";
    return (isAgainst(outcomeOf(event)) ? "left it out: " : "kept it: ") +
           std::string(endingText(event));
}

TraceReason reasonFor(const std::vector<Event>& events, Stage last, const PointSet& points,
                      Index pivot, Index point, bool inTrace) {
    const Event* event = decisionAbout(events, point, last);
    if (event != nullptr) return {point, inTrace, decisionText(*event), event->address};
    const bool isListed = points.neighbors.has(pivot, point);
    return {point,
            inTrace,
            isListed ? "made no decision about it" : "has it not in the list of the pivot",
            {}};
}

/// The reasons for the points that only one of two lists has, in the order of the lists.
std::vector<TraceReason> reasonsFor(const std::vector<Event>& events, Stage last,
                                    const PointSet& points, Index pivot,
                                    const std::vector<Index>& trace,
                                    const std::vector<Index>& run) {
    std::vector<TraceReason> reasons;
    const auto add = [&](const std::vector<Index>& list, const std::vector<Index>& other) {
        for (const Index point : list) {
            if (std::find(other.begin(), other.end(), point) == other.end())
                reasons.push_back(reasonFor(events, last, points, pivot, point, &list == &trace));
        }
    };
    add(run, trace);
    add(trace, run);
    return reasons;
}

/// The last event of a stage; null if there is none.
const Event* lastOf(const std::vector<Event>& events, Stage stage) {
    const auto found = std::find_if(events.rbegin(), events.rend(), [&](const Event& event) {
        return event.address.stage == stage;
    });
    return found == events.rend() ? nullptr : &*found;
}

/// A decision of ours as a sentence.
TraceReason sentenceReason(const Event& event) {
    std::string text = describe(event);
    if (text.ends_with('.')) text.pop_back();
    return {kNone, false, std::move(text), event.address};
}

/// The last change about a point, if it entered or left as asked; null otherwise.
const Event* lastChange(const RingChanges& changes, Index point, bool entered) {
    const auto found = changes.find(point);
    if (found == changes.end()) return nullptr;
    return as<RingEvidence>(found->second)->inserted == entered ? &found->second : nullptr;
}

/// The reasons why first or last of the same pivot differ: their point has left our ring, or ours
/// has entered.
void addNeighborReasons(const TracePivot& trace, const TracePivot& run, const RingChanges& changes,
                        std::vector<TraceReason>& reasons) {
    for (const auto side : {&TracePivot::first, &TracePivot::last}) {
        if (trace.*side == run.*side) continue;
        const Event* change = lastChange(changes, trace.*side, false);
        if (change == nullptr) change = lastChange(changes, run.*side, true);
        if (change != nullptr) reasons.push_back(sentenceReason(*change));
    }
}

/// The reasons for another next pivot: the advance, what else changed the rings as a whole at the
/// pivot before, and the removal of their pivot from our ring.
void addAdvanceReasons(const TracePivot& trace, const std::vector<Event>& before,
                       const RingChanges& changes, std::vector<TraceReason>& reasons) {
    if (const Event* advance = lastOf(before, Stage::Advance))
        reasons.push_back(sentenceReason(*advance));
    for (const Event& event : before) {
        if (isA<SplitEvidence>(event) || isA<JoinEvidence>(event) || isA<CloseEvidence>(event))
            reasons.push_back(sentenceReason(event));
    }
    if (const Event* left = lastChange(changes, trace.p, false))
        reasons.push_back(sentenceReason(*left));
}

/// The decisions that led to the pivot: the rings, the advance, third points and seeds.
std::vector<TraceReason> pivotReasons(const TracePivot& trace, const TracePivot& run,
                                      const std::vector<Event>& before, const RingChanges& changes,
                                      const std::vector<Event>& events) {
    std::vector<TraceReason> reasons;
    if (trace.p == run.p) addNeighborReasons(trace, run, changes, reasons);
    if (reasons.empty()) addAdvanceReasons(trace, before, changes, reasons);
    for (const Stage stage : {Stage::Seed, Stage::Insert}) {
        if (const Event* event = lastOf(events, stage)) reasons.push_back(sentenceReason(*event));
    }
    return reasons;
}

/// Adds the decision for or against a fan as a whole, if there was one.
void addFanReason(const std::vector<Event>& events, std::vector<TraceReason>& reasons) {
    for (const Stage stage : {Stage::Guard, Stage::TwoPoint, Stage::Skip}) {
        if (const Event* event = lastOf(events, stage))
            return reasons.push_back(sentenceReason(*event));
    }
}

/// The changes of the rings at the pivot.
std::vector<TraceReason> ringReasons(const std::vector<Event>& events) {
    std::vector<TraceReason> reasons;
    for (const Event& event : events) {
        const Stage stage = event.address.stage;
        if (stage >= Stage::Ring && stage <= Stage::Advance)  // Also Split and Join.
            reasons.push_back(sentenceReason(event));
    }
    return reasons;
}

std::string stageWhat(TraceStage stage) {
    if (stage == TraceStage::Emit) return "the fans differ";
    if (stage == TraceStage::Ring) return "the edge rings differ";
    return "the candidates after " + std::string(rowOf(stage).name) + " differ";
}

/// The candidates of a stage, of the fan those between first and last.
std::vector<Index> pointsOf(const TracePivot& pivot, TraceStage stage) {
    const TracedPoints& points = pivot.*rowOf(stage).points;
    std::vector<Index> list = points.value_or(std::vector<Index>{});
    if (stage == TraceStage::Emit && !list.empty()) return {list.begin() + 1, list.end() - 1};
    return list;
}

std::string bothText(std::string_view what, const std::string& yours, const std::string& ours) {
    return std::string(what) + ": yours " + yours + ", ours " + ours;
}

/// The decision that keeps our limit from being at `yours`: the last one about it, or the last move
/// if ours has moved over `yours`. Null if there is none. `from`: first or last, where it began.
const Event* decisionOnLimit(const std::vector<Event>& events, Side side, Index from, Index yours) {
    const Event* last = nullptr;
    const Event* lastMove = nullptr;
    bool passed = from == yours;
    for (const Event& event : events) {
        const auto* limit = as<LimitEvidence>(event);
        if (limit == nullptr || limit->side != side) continue;
        last = &event;
        if (!limit->moves()) continue;
        passed = passed || testedPoint(event) == yours;
        lastMove = &event;
    }
    return passed && lastMove != nullptr ? lastMove : last;
}

/// Start and end where they differ, with our last decision about them.
void addLimits(const std::vector<Event>& events, TraceDifference& found) {
    const auto add = [&](std::optional<Index> TracePivot::*limit, Side side, Index from) {
        const std::optional<Index> yours = (*found.trace).*limit;
        const std::optional<Index> ours = (*found.run).*limit;
        if (!yours || !ours || yours == ours) return;
        found.both.push_back(
            bothText(sideText(side), std::to_string(*yours), std::to_string(*ours)));
        if (const Event* event = decisionOnLimit(events, side, from, *yours))
            found.reasons.push_back(sentenceReason(*event));
    };
    add(&TracePivot::start, Side::Start, found.run->first);
    add(&TracePivot::end, Side::End, found.run->last);
}

/// The points of a ring from a place on, cut after the first few: "4 8 9".
std::string ringText(const std::vector<Index>& ring, std::size_t from) {
    constexpr std::size_t kMaxShown = 12;
    const std::size_t begin = std::min(from, ring.size());
    const std::size_t count = std::min(ring.size() - begin, kMaxShown);
    std::string text = joinedNumbers(std::span(ring).subspan(begin, count), " ");
    if (ring.size() > from + kMaxShown) text += " ...";
    return text.empty() ? "no more" : text;
}

/// The two edge rings from their first difference on, and the two next pivots.
void addRings(TraceDifference& found) {
    const TracePivot& trace = *found.trace;
    const TracePivot& run = *found.run;
    if (trace.ring && run.ring && *trace.ring != *run.ring) {
        const auto differ = std::mismatch(trace.ring->begin(), trace.ring->end(), run.ring->begin(),
                                          run.ring->end());
        const auto from = static_cast<std::size_t>(differ.first - trace.ring->begin());
        const std::string place =
            from == 0 ? "ring" : "ring from place " + std::to_string(from) + " on";
        found.both.push_back(
            bothText(place, ringText(*trace.ring, from), ringText(*run.ring, from)));
    }
    const auto nextText = [](Index x) { return x == kNone ? "none" : std::to_string(x); };
    if (trace.next && run.next && trace.next != run.next)
        found.both.push_back(bothText("next", nextText(*trace.next), nextText(*run.next)));
}

/// Adds the changes of a pivot.
void takeRingChanges(const std::vector<Event>& events, RingChanges& changes) {
    for (const Event& event : events) {
        if (const auto* ring = as<RingEvidence>(event))
            changes.insert_or_assign(ring->point, event);
    }
}

/// The difference at a pivot. `run`: nothing if our run has ended. `before`: our events of the
/// pivot before; `events`: those of this one. Without a stage it is the pivot itself that differs.
TraceDifference differenceAt(TracePivot trace, std::optional<TracePivot> run,
                             std::optional<TraceStage> stage, const std::vector<Event>& before,
                             const RingChanges& changes, const std::vector<Event>& events,
                             const PointSet& points) {
    TraceDifference found;
    found.stage = stage;
    found.trace = std::move(trace);
    found.run = std::move(run);
    if (!found.run) {
        found.what = "our run has ended, the trace goes on";
    } else if (!stage) {
        const bool same = found.trace->p == found.run->p;
        found.what = same ? "the edge rings beside it differ" : "the pivots differ";
        found.reasons = pivotReasons(*found.trace, *found.run, before, changes, events);
    } else if (*stage == TraceStage::Ring) {
        found.what = stageWhat(*stage);
        addRings(found);
        found.reasons = ringReasons(events);
    } else {
        found.what = stageWhat(*stage);
        found.reasons = reasonsFor(events, rowOf(*stage).last, points, found.run->p,
                                   pointsOf(*found.trace, *stage), pointsOf(*found.run, *stage));
        if (*stage == TraceStage::Limits) addLimits(events, found);
        const bool noFan =
            *stage == TraceStage::Emit && found.trace->fan->empty() != found.run->fan->empty();
        if (noFan) {
            addFanReason(events, found.reasons);
            found.what += found.run->fan->empty() ? ": ours has none" : ": yours has none";
        } else if (found.reasons.empty() && found.both.empty()) {
            found.what += ": the same points in another order";
        }
    }
    return found;
}

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
    std::string text = "alike as far as yours goes, " + counted(comparison.alike, "pivot");
    if (reached) {
        text += " and pivot " + std::to_string(found.pivot) + " up to " +
                std::string(rowOf(*reached).name);
    }
    return text + "; ours goes on to " + counted(found.runPivots, "pivot") +
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
    const std::string alike = counted(comparison.alike, "pivot") + " alike";
    if (!comparison.difference) return "all " + alike + "\n";
    const TraceDifference& found = *comparison.difference;
    if (found.runPivots > 0) return earlyEndText(comparison) + "\n";
    std::string text = "after " + alike + ", " + headText(found) + "\n";
    for (const std::string& each : found.both) text += "  " + each + "\n";
    for (const TraceReason& each : found.reasons) text += "  " + reasonText(each) + "\n";
    return text;
}

}  // namespace se::teach
