#include "spiraling_edge/replay/scan_run.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/replay/reading.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {

Index pivotPoint(std::span<const Event> events) {
    for (const Event& event : events) {
        if (const auto* pivot = as<PivotEvidence>(event)) return pivot->pivot;
        if (const auto* fill = as<FillEvidence>(event)) return fill->pivot;
    }
    return kNone;
}

PivotTally tallyOf(std::span<const Event> events) {
    PivotTally tally;
    for (const Event& event : events) {
        if (const auto* pivot = as<PivotEvidence>(event)) tally.ringLength = pivot->ringLength;
        const Outcome outcome = outcomeOf(event);
        if (outcome == Outcome::None) continue;
        ++tally.tests;
        const bool sorted = isA<SortEvidence>(event);
        if (sorted && outcome == Outcome::Taken) ++tally.candidates;
    }
    return tally;
}

std::optional<State> scanRun(const PointSet& points, const Params& params,
                             const std::function<void(const ScannedPivot&)>& visit,
                             const Progress& progress) {
    assert(validate(points).ok());
    EventLog log;
    Stepper stepper(points, params, &log);
    const auto all = static_cast<double>(std::max<std::size_t>(points.size(), 1));
    for (std::uint32_t count = 0;; ++count) {
        const bool more = stepper.stepPivot();
        stepper.freePast();
        const std::vector<Event>& events = log.events();
        if (!events.empty()) {
            visit({pivotPoint(events), events, stepper.state()});
            log.clear();
        }
        if (!more) return stepper.takeState();
        if (count % kPivotsPerReport == 0 && progress &&
            !progress(static_cast<double>(stepper.state().done.size()) / all))
            return {};
    }
}

}  // namespace se
