#include "spiraling_edge/explain/inspected_run.h"

#include <utility>

#include "spiraling_edge/explain/freed_rings.h"

namespace se {

std::optional<InspectedRun> inspectRun(const PointSet& points, const Params& params,
                                       const Progress& progress,
                                       const std::function<void(const ScannedPivot&)>& visit) {
    std::vector<MeshFailure> leftOver;
    FreedRings rings;
    std::optional<State> end = scanRun(
        points, params,
        [&](const ScannedPivot& pivot) {
            if (visit) visit(pivot);
            for (const Event& event : pivot.events) {
                if (const auto ring = rings.add(event))
                    leftOver.push_back(failureOf(points, *ring));
            }
        },
        progress);
    if (!end) return {};
    MeshInspection found = inspectWithTotals(points, end->mesh());
    for (MeshFailure& each : leftOver) {
        ClassTotal& total =
            found.totals[static_cast<std::size_t>(each.kind - failureClasses().data())];
        ++total.listed;
        ++total.total;
        found.failures.push_back(std::move(each));
    }
    return InspectedRun{std::move(*end), std::move(found.failures), std::move(found.totals)};
}

}  // namespace se
