/// Rings that a run frees (§7), reconstructed from its events.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/stepper/event.h"

namespace se {

/// A ring that was freed, with an alert.
struct FreedRing {
    AlertEvidence alert;
    std::vector<Index> points;  ///< Ascending.
    Event event;                ///< The event of the ring.
};

/// Collects the points of a ring while they leave it.
class FreedRings {
  public:
    /// Takes the next event. Returns a ring at the event of its alert.
    std::optional<FreedRing> add(const Event& event) {
        if (event.address.stage != Stage::Done) {
            leaving_.clear();
            freed_.reset();
            return {};
        }
        if (const auto* ring = std::get_if<RingEvidence>(&event.evidence)) {
            if (freed_) leaving_.clear();
            freed_.reset();
            leaving_.push_back(ring->point);
        } else if (std::holds_alternative<FreeEvidence>(event.evidence)) {
            freed_ = event;
        } else if (const auto* alert = std::get_if<AlertEvidence>(&event.evidence)) {
            if (alert->kind == AlertKind::TriangleCap)
                return FreedRing{*alert, {alert->point}, event};
            std::vector<Index> points = leaving_;
            std::sort(points.begin(), points.end());
            points.erase(std::unique(points.begin(), points.end()), points.end());
            return FreedRing{*alert, std::move(points), freed_.value_or(event)};
        }
        return {};
    }

  private:
    std::vector<Index> leaving_;
    std::optional<Event> freed_;
};

/// The failure of a freed ring, or of the place where the run was stopped.
inline MeshFailure failureOf(const PointSet& points, const FreedRing& ring) {
    MeshFailure failure;
    const bool stopped = ring.alert.kind == AlertKind::TriangleCap;
    failure.kind = findFailureClass(stopped ? "triangle_cap" : "leftover_rings");
    failure.points = ring.points;
    for (const Index p : failure.points) failure.place += points.position[p];
    failure.place /= static_cast<double>(failure.points.size());
    return failure;
}

}  // namespace se
