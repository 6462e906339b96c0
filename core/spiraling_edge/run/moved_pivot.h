/// One pivot of a run with a point moved, made again for each position: for dragging a point.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "spiraling_edge/points/shared_points.h"
#include "spiraling_edge/run/pivot_record.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se {

/// The decisions of one stage of a pivot about one point.
struct PointDecisions {
    Stage stage = Stage::Pivot;
    Index point = kNone;
};

/// The outcome of the last of these decisions; None if the pivot has none.
Outcome outcomeOf(const PivotRecord& record, const PointDecisions& decisions);

class MovedPivot {
  public:
    /// Runs to the beginning of `pivot`, counted from 1. Empty if the run has no such pivot, or
    /// once `keepGoing` returns false.
    static std::optional<MovedPivot> make(const SharedPoints& points, const Params& params,
                                          std::uint32_t pivot,
                                          const std::function<bool()>& keepGoing = {});

    std::uint32_t pivot() const { return before_.counters.pivots + 1; }
    /// The pivot if `point` were at `to` from its beginning on, as WhatIfKind::Move has it.
    /// O(points of the input).
    std::shared_ptr<const PivotRecord> record(Index point, const Vec3& to) const;
    /// The least share of the way from `from` to `to` of `point` at which the outcome of the
    /// decisions differs from that at `from`, found at 24 places and then by halving. Empty if
    /// there is none, or once `keepGoing` returns false.
    std::optional<double> turn(Index point, const Vec3& from, const Vec3& to,
                               const PointDecisions& decisions,
                               const std::function<bool()>& keepGoing = {}) const;

  private:
    MovedPivot(SharedPoints points, const Params& params, State before)
        : points_(std::move(points)), params_(params), before_(std::move(before)) {}

    SharedPoints points_;
    Params params_;
    State before_;  ///< Between two pivots.
};

}  // namespace se
