#include "spiraling_edge/replay/scan_run.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {
namespace {

Index pivotPoint(std::span<const Event> events) {
    for (const Event& event : events) {
        if (const auto* pivot = std::get_if<PivotEvidence>(&event.evidence)) return pivot->pivot;
        if (const auto* fill = std::get_if<FillEvidence>(&event.evidence)) return fill->pivot;
    }
    return kNone;
}

}  // namespace

std::optional<State> scanRun(const PointSet& points, const Params& params,
                             const std::function<void(const ScannedPivot&)>& visit,
                             const Progress& progress) {
    assert(validate(points).ok());
    EventLog log;
    Stepper stepper(points, params, &log);
    const auto all = static_cast<double>(std::max<std::size_t>(points.size(), 1));
    for (std::uint32_t count = 0;; ++count) {
        const bool more = stepper.stepPivot();
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
