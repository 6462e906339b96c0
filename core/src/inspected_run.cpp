#include "inspected_run.h"

#include <utility>

#include "freed_rings.h"
#include "spiraling_edge/run_scan.h"

namespace se {

std::optional<InspectedRun> inspectRun(const PointSet& points, const Params& params,
                                       const Progress& progress) {
    std::vector<MeshFailure> leftOver;
    FreedRings rings;
    std::optional<State> end = scanRun(
        points, params,
        [&](const ScannedPivot& pivot) {
            for (const Event& event : pivot.events) {
                if (const auto ring = rings.see(event))
                    leftOver.push_back(failureOf(points, *ring));
            }
        },
        progress);
    if (!end) return {};
    std::vector<MeshFailure> failures = inspectMesh(points, end->mesh());
    failures.insert(failures.end(), leftOver.begin(), leftOver.end());
    return InspectedRun{std::move(*end), std::move(failures)};
}

}  // namespace se
