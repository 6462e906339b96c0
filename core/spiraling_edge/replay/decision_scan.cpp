#include "spiraling_edge/replay/decision_scan.h"

#include <algorithm>
#include <array>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/replay/live_check.h"

namespace se {
namespace {

/// The classes detected at a single decision: by LiveCheck, or by plainFailures().
constexpr std::array<std::string_view, 13> kInRun = {"non_manifold_edges",
                                                     "non_manifold_vertices",
                                                     "inconsistent_edges",
                                                     "duplicate_triangles",
                                                     "degenerate_triangles",
                                                     "intersecting_triangles",
                                                     "folded_edges",
                                                     "flipped_triangles",
                                                     "slivers",
                                                     "holes",
                                                     "unused_points",
                                                     "leftover_rings",
                                                     "triangle_cap"};

std::uint32_t bitOf(std::string_view name) { return failureBit(*findFailureClass(name)); }

/// The failures that one event causes by itself.
std::uint32_t plainFailures(const Event& event, const PointSet& points) {
    if (const auto* emit = std::get_if<EmitEvidence>(&event.evidence)) {
        const bool thin = leastAngleCosine(points, emit->corners) > kSliverCosine;
        return thin && !isDegenerate(points, emit->corners) ? bitOf("slivers") : 0;
    }
    const auto* alert = std::get_if<AlertEvidence>(&event.evidence);
    if (alert == nullptr) return 0;
    if (alert->kind == AlertKind::TriangleCap) return bitOf("triangle_cap");
    return bitOf("leftover_rings") | (alert->kind == AlertKind::Hole ? bitOf("holes") : 0);
}

std::uint32_t failuresOf(const Event& event, const PointSet& points, LiveCheck& live) {
    std::uint32_t bits = plainFailures(event, points);
    for (const LiveFailure& each : live.check(event)) bits |= failureBit(*each.kind);
    return bits;
}

}  // namespace

std::uint32_t failureBit(const FailureClass& kind) {
    return std::uint32_t{1} << static_cast<unsigned>(&kind - failureClasses().data());
}

bool appearsInRun(const FailureClass& kind) {
    return std::find(kInRun.begin(), kInRun.end(), kind.name) != kInRun.end();
}

bool scanDecisions(const PointSet& points, const Params& params, bool failures,
                   const std::function<void(const Decision&, RunPosition)>& visit,
                   const Progress& progress) {
    std::optional<LiveCheck> live;
    if (failures) live.emplace(points);
    PositionCounter places;
    const auto onPivot = [&](const ScannedPivot& pivot) {
        for (const Event& event : pivot.events) {
            const auto reading = readingOf(event, {points, params, pivot.point});
            const std::uint32_t bits = live ? failuresOf(event, points, *live) : 0;
            visit({event, pivot.point, reading, points, pivot.events, bits}, places.next(event));
        }
    };
    return scanRun(points, params, onPivot, progress).has_value();
}

}  // namespace se
