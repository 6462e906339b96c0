/// What a decision compared: the value, its threshold, and how near the decision was to going the
/// other way.
#pragma once

#include <optional>
#include <string_view>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se {

/// How a test ended; nothing if the event is none.
std::optional<Verdict> verdictOf(const Event& event);
/// What became of what was tested.
Outcome outcomeOf(const Event& event);
/// The point that was tested, or that something happened to; kNone if it was none or several.
Index testedPoint(const Event& event);

/// The number that decided. Decisions that compare nothing, such as "is DONE", have none.
struct Reading {
    std::string_view quantity;  ///< "angle", "distance from the center"
    std::string_view unit;      ///< "deg", or empty: scene units.
    double value = 0.0;
    double threshold = 0.0;
    /// Signed, > 0 where the tested point is taken, < 0 where refused; at 0 the decision turns. An
    /// angle in radians, or a length over the tested point's distance from the pivot: about how far
    /// the tested point would have to move, as a share of that distance. Where two numbers decide
    /// together (§6.3), that of the one that would have to change.
    double margin = 0.0;
};

/// Where an event happened: its run, and the point that was the pivot.
struct ReadingContext {
    const PointSet& points;
    const Params& params;
    Index pivot;  ///< kNone outside of a pivot.
};

/// The reading of an event.
std::optional<Reading> readingOf(const Event& event, const ReadingContext& context);

}  // namespace se
