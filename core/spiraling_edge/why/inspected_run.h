/// A run with all its failures, without their moments, and the rings that it frees (§7).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/run/sweep.h"

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
    std::optional<FreedRing> add(const Event& event);

  private:
    std::vector<Index> leaving_;
    std::optional<Event> freed_;
};

/// Position of a class in failureClasses().
inline std::size_t rankOf(const FailureClass& kind) {
    return static_cast<std::size_t>(&kind - failureClasses().data());
}

/// True if `a` is of a class before that of `b`.
inline bool isOfEarlierClass(const MeshFailure& a, const MeshFailure& b) {
    return rankOf(*a.kind) < rankOf(*b.kind);
}

/// The inspection of the mesh of a run: the failures that inspectWithTotals() finds, then rings
/// left over, in the order of failureClasses(); the totals count all of them.
struct InspectedRun : MeshInspection {
    std::vector<Triangle> mesh;

    /// The total of a class.
    const ClassTotal& totalOf(const FailureClass& kind) const { return totals[rankOf(kind)]; }
};

/// The mesh of a finished run, whose other memory is freed: it is several times as large.
std::vector<Triangle> takeMesh(State run);

/// The rings that a run leaves over, collected from its events.
class LeftOverRings {
  public:
    void add(const PointSet& points, std::span<const Event> events);
    const std::vector<MeshFailure>& found() const { return found_; }

  private:
    FreedRings rings_;
    std::vector<MeshFailure> found_;
};

/// The inspection of the mesh at the end of a run that left over these rings.
InspectedRun inspectEnd(const PointSet& points, std::vector<Triangle> mesh,
                        const LeftOverRings& leftOver);

}  // namespace se
