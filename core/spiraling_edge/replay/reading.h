/// The comparison of a decision: the value, its threshold, and the margin by which it was decided.
#pragma once

#include <optional>
#include <string_view>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se {

/// The verdict of a test; nothing if the event is no test.
std::optional<Verdict> verdictOf(const Event& event);
/// The outcome of a test; None if the event is no test.
Outcome outcomeOf(const Event& event);
/// The tested point, or the point that an event changed; kNone if it is none or several.
Index testedPoint(const Event& event);

/// The number that decided. Decisions that compare nothing, such as "is DONE", have none.
struct Reading {
    std::string_view quantity;  ///< "angle", "distance from the center"
    std::string_view unit;      ///< "deg", or empty: scene units.
    double value = 0.0;
    double threshold = 0.0;
    /// Signed, > 0 where the tested point is taken, < 0 where refused; at 0 the decision changes.
    /// An angle in radians, or a length over the tested point's distance from the pivot: about the
    /// move of the tested point that would change it, as a share of that distance. Where two
    /// numbers decide together (§6.3), the margin of the one that would have to change.
    double margin = 0.0;
};

/// The context of an event: its run, and the point that was the pivot.
struct ReadingContext {
    const PointSet& points;
    const Params& params;
    Index pivot;  ///< kNone outside of a pivot.
};

/// The reading of an event; nothing if it compared nothing.
std::optional<Reading> readingOf(const Event& event, const ReadingContext& context);

}  // namespace se
