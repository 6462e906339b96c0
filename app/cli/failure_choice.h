/// One failure of a run, named on the command line: CLASS or CLASS:N.
#pragma once

#include <string>
#include <vector>

#include "spiraling_edge/explain/failure_moments.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

namespace se::cli {

/// A class of failures, and which one of it.
struct FailureChoice {
    const FailureClass* kind;
    std::size_t number;  ///< From 1.
};

/// Throws Failure if there is no such class, or N is no number.
FailureChoice failureChoiceFrom(const std::string& text);

/// The end of a run; how far it has come if the user interrupts.
State endOfRun(const PointSet& points, const Params& params);

/// The failure that is asked for. Throws Failure if it is not in the list of the run on `input`.
MeshFailure pickFailure(const MeshInspection& found, const FailureChoice& choice,
                        const std::string& input);
/// The failure that is asked for, with its moments. Throws Failure if it is not in the list.
RunFailure pickFailure(const RunFailureSearch& found, const FailureChoice& choice,
                       const std::string& input);

}  // namespace se::cli
