#include "spiraling_edge/explain/inspected_run.h"

#include <algorithm>
#include <utility>

#include "spiraling_edge/replay/reading.h"

namespace se {

std::optional<FreedRing> FreedRings::add(const Event& event) {
    if (event.address.stage != Stage::Done) {
        leaving_.clear();
        freed_.reset();
        return {};
    }
    if (const auto* ring = as<RingEvidence>(event)) {
        if (freed_) leaving_.clear();
        freed_.reset();
        leaving_.push_back(ring->point);
    } else if (isA<FreeEvidence>(event)) {
        freed_ = event;
    } else if (const auto* alert = as<AlertEvidence>(event)) {
        if (alert->kind == AlertKind::TriangleCap) return FreedRing{*alert, {alert->point}, event};
        std::vector<Index> points = leaving_;
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        return FreedRing{*alert, std::move(points), freed_.value_or(event)};
    }
    return {};
}

MeshFailure failureOf(const PointSet& points, const FreedRing& ring) {
    MeshFailure failure;
    const bool stopped = ring.alert.kind == AlertKind::TriangleCap;
    failure.kind = findFailureClass(stopped ? "triangle_cap" : "leftover_rings");
    failure.points = ring.points;
    for (const Index p : failure.points) failure.place += points.position[p];
    failure.place /= static_cast<double>(failure.points.size());
    return failure;
}

namespace {

/// The mesh of a finished run, whose other memory is freed: it is several times as large.
std::vector<Triangle> meshOf(State run) {
    return run.repair.empty() ? std::move(run.triangles) : run.repair.triangles.take();
}

}  // namespace

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
    std::vector<Triangle> mesh = meshOf(std::move(*end));
    MeshInspection found = inspectWithTotals(points, mesh);
    for (MeshFailure& each : leftOver) {
        ClassTotal& total = found.totals[rankOf(*each.kind)];
        ++total.listed;
        ++total.total;
        found.failures.push_back(std::move(each));
    }
    std::stable_sort(found.failures.begin(), found.failures.end(), isOfEarlierClass);
    return InspectedRun{std::move(found), std::move(mesh)};
}

}  // namespace se
