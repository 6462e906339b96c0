/// Collects, pivot by pivot, the lines of a ledger; then finds the deciding one.
#pragma once

#include <bitset>

#include "spiraling_edge/explain/ledger.h"
#include "spiraling_edge/replay/scan_run.h"

namespace se {

/// True if the mesh has the subject: a point in some triangle, an edge, or the triangle in either
/// winding. O(triangles).
bool isInMesh(std::span<const Triangle> mesh, const Subject& subject);

class LedgerBuilder {
  public:
    LedgerBuilder(const PointSet& points, const Params& params, const Subject& subject)
        : points_(points), params_(params), ledger_{subject, false, {}, 0, {}} {}

    void add(const ScannedPivot& pivot);
    /// Finds the deciding line. Call it after the last pivot was added, with the state there.
    Ledger finish(const State& end);

  private:
    void addEvent(const ScannedPivot& pivot, const Event& event);
    std::optional<LineRole> roleOf(const ScannedPivot& pivot, const Event& event) const;
    std::optional<LineRole> roleOfTest(Index pivot, const Event& event) const;
    bool isFactOf(const Event& event) const;
    void follow(const Event& event);

    const PointSet& points_;
    const Params& params_;
    Ledger ledger_;
    std::bitset<3> alive_;  ///< Points of the subject that may become spokes of the current fan.
    Index reciprocal_ = kNone;  ///< The last point that passed the reciprocal test at this pivot.
    bool inMesh_ = false;       ///< Updated during the repair after the last pivot.
    bool repairing_ = false;
};

}  // namespace se
