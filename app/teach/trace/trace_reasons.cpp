// A point of one list that the other has not is explained by the last decision about it.
#include "trace_reasons.h"

#include <algorithm>

#include "spiraling_edge/replay/event_text.h"
#include "spiraling_edge/replay/reading.h"

namespace se::teach {
namespace {

std::string_view sideText(Side side) { return side == Side::Start ? "start" : "end"; }

/// The effect of a decision on its point: "moved start to it", "kept it: inside sphere".
std::string decisionText(const Event& event) {
    if (const auto* limit = as<LimitEvidence>(event))
        return "moved " + std::string(sideText(limit->side)) + " to it";
    if (verdictOf(event) == Verdict::Kept) return "kept it";
    return (isAgainst(outcomeOf(event)) ? "left it out: " : "kept it: ") +
           std::string(endingText(event));
}

/// True for the tests that decide about a candidate.
bool decidesCandidate(const Event& event, Index point) {
    if (testedPoint(event) != point) return false;
    if (const auto* e = as<LimitEvidence>(event)) return e->moves();
    if (const auto* e = as<DropEvidence>(event); e && e->isLimit()) return false;
    return verdictOf(event).has_value();
}

/// The last decision of a pivot about a point, up to a stage; of entries at which the reciprocal
/// test was made, one that kept it, if any did. Null if there is none.
const Event* decisionAbout(const std::vector<Event>& events, Index point, Stage last) {
    const Event* found = nullptr;
    for (const Event& event : events) {
        if (event.address.stage > last) continue;
        if (!decidesCandidate(event, point)) continue;
        // A point that start or end has passed is in the fan, although outside of them.
        if (found != nullptr && isA<LimitEvidence>(*found)) continue;
        const bool isOtherEntry = found != nullptr && isA<ReciprocalEvidence>(event) &&
                                  isA<ReciprocalEvidence>(*found) &&
                                  outcomeOf(*found) == Outcome::Taken;
        if (!isOtherEntry) found = &event;
    }
    return found;
}

TraceReason reasonFor(const std::vector<Event>& events, Stage last, const PointSet& points,
                      Index pivot, Index point, bool inTrace) {
    const Event* event = decisionAbout(events, point, last);
    if (event != nullptr) return {point, inTrace, decisionText(*event), event->address};
    const auto list = points.neighbors[pivot];
    const bool isListed = std::find(list.begin(), list.end(), point) != list.end();
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
    const auto has = [](const std::vector<Index>& list, Index point) {
        return std::find(list.begin(), list.end(), point) != list.end();
    };
    std::vector<TraceReason> reasons;
    for (const Index point : run) {
        if (!has(trace, point))
            reasons.push_back(reasonFor(events, last, points, pivot, point, false));
    }
    for (const Index point : trace) {
        if (!has(run, point))
            reasons.push_back(reasonFor(events, last, points, pivot, point, true));
    }
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

/// The decision for or against a fan as a whole; nothing if there was none.
std::vector<TraceReason> fanReasons(const std::vector<Event>& events) {
    for (const Stage stage : {Stage::Guard, Stage::TwoPoint, Stage::Skip}) {
        if (const Event* event = lastOf(events, stage)) return {sentenceReason(*event)};
    }
    return {};
}

/// The changes of the rings at the pivot.
std::vector<TraceReason> ringReasons(const std::vector<Event>& events) {
    std::vector<TraceReason> reasons;
    for (const Event& event : events) {
        const Stage stage = event.address.stage;
        if (stage == Stage::Ring || stage == Stage::Split || stage == Stage::Join ||
            stage == Stage::Advance)
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
    std::string text;
    for (std::size_t i = from; i < std::min(ring.size(), from + kMaxShown); ++i)
        text += (text.empty() ? "" : " ") + std::to_string(ring[i]);
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

}  // namespace

void takeRingChanges(const std::vector<Event>& events, RingChanges& changes) {
    for (const Event& event : events) {
        if (const auto* ring = as<RingEvidence>(event))
            changes.insert_or_assign(ring->point, event);
    }
}

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
            for (TraceReason& each : fanReasons(events)) found.reasons.push_back(std::move(each));
            found.what += found.run->fan->empty() ? ": ours has none" : ": yours has none";
        } else if (found.reasons.empty() && found.both.empty()) {
            found.what += ": the same points in another order";
        }
    }
    return found;
}

}  // namespace se::teach
