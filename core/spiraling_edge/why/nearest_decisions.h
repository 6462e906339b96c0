/// The decisions of a run with the least margins, and the moves that would invert them.
#pragma once

#include <vector>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"

namespace se {

/// A move of one point.
struct FlippingMove {
    Index point = kNone;
    Vec3 by{};  ///< Scene units.
};

/// One decision, and the move that would invert it.
struct NearestDecision {
    Event event;
    Index pivot = kNone;
    Reading reading;
    FlippingMove move;  ///< Inverts the decision if no earlier one changes.
};

struct NearestDecisions {
    /// Least |margin| first, then in the order of the run.
    std::vector<NearestDecision> decisions;
    /// Per point: the least |margin| of all its tests; infinite if none of them has a number.
    std::vector<double> leastMargin;
};

/// The question for the `count` decisions of a run with the least |margin|. Ties on exact lattices
/// have a margin of 0. O(run). Deterministic.
Question<NearestDecisions> nearestQuestion(const PointSet& points, const Params& params,
                                           std::size_t count);
/// The answer to nearestQuestion(). Fails if cancelled.
Result<NearestDecisions> nearestDecisions(const PointSet& points, const Params& params,
                                          std::size_t count, const Progress& progress = {});

}  // namespace se
