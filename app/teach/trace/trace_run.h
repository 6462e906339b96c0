/// A run as the lines of its trace, pivot by pivot.
#pragma once

#include <optional>

#include "setrace.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::teach {

/// The points of a ring from an entry on.
std::vector<Index> ringFrom(const EdgeRings& rings, Index entry);

/// Content of a recorded pivot.
enum class TraceDetail : std::uint8_t {
    Fans,    ///< Pivot, first, last and fan.
    Stages,  ///< Also the candidates after each stage, the rings, and what became DONE.
};

/// One step of a run.
struct TraceStep {
    bool ran = false;                 ///< False at the end of the run, as Stepper::stepPivot().
    std::optional<TracePivot> pivot;  ///< Nothing for a step after the last pivot.
};

/// Runs `stepper` to the end of its next pivot. Requires that it stands between two pivots.
TraceStep stepTraced(Stepper& stepper, TraceDetail detail);

}  // namespace se::teach
