#include "spiraling_edge/why/inspected_run.h"

#include <algorithm>
#include <utility>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/run/reading.h"

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
        sortUnique(points);
        return FreedRing{*alert, std::move(points), freed_.value_or(event)};
    }
    return {};
}

namespace {

/// The failure of a freed ring, or of the place where the run was stopped.
MeshFailure failureOf(const PointSet& points, const FreedRing& ring) {
    MeshFailure failure;
    const bool stopped = ring.alert.kind == AlertKind::TriangleCap;
    failure.kind = findFailureClass(stopped ? "triangle_cap" : "leftover_rings");
    failure.points = ring.points;
    for (const Index p : failure.points) failure.place += points.position[p];
    failure.place /= static_cast<double>(failure.points.size());
    return failure;
}

}  // namespace

void LeftOverRings::add(const PointSet& points, std::span<const Event> events) {
    for (const Event& event : events) {
        if (const auto ring = rings_.add(event)) found_.push_back(failureOf(points, *ring));
    }
}

std::vector<Triangle> takeMesh(State run) {
    return run.repair.empty() ? std::move(run.triangles) : run.repair.triangles.take();
}

InspectedRun inspectEnd(const PointSet& points, std::vector<Triangle> mesh,
                        const LeftOverRings& leftOver) {
    MeshInspection found = inspectWithTotals(points, mesh);
    for (const MeshFailure& each : leftOver.found()) {
        ClassTotal& total = found.totals[rankOf(*each.kind)];
        ++total.listed;
        ++total.total;
        found.failures.push_back(each);
    }
    std::stable_sort(found.failures.begin(), found.failures.end(), isOfEarlierClass);
    return InspectedRun{std::move(found), std::move(mesh)};
}

}  // namespace se
