/// One failure of a run, named on the command line: CLASS or CLASS:N.
#pragma once

#include <string>
#include <vector>

#include "spiraling_edge/failure_moments.h"
#include "spiraling_edge/params.h"

namespace se::cli {

/// A class of failures, and which one of it.
struct FailureChoice {
    const FailureClass* kind;
    std::size_t number;  ///< From 1.
};

/// Throws Failure if there is no such class, or N is no number.
FailureChoice failureChoiceFrom(const std::string& text);

/// The mesh of a run; as far as it is made if the user interrupts.
std::vector<Triangle> meshOf(const PointSet& points, const Params& params);

/// The failure that is asked for. Throws Failure if there is none such in the run on `input`.
MeshFailure pickFailure(const std::vector<MeshFailure>& failures, const FailureChoice& choice,
                        const std::string& input);
/// The same among those of a run.
RunFailure pickFailure(const std::vector<RunFailure>& failures, const FailureChoice& choice,
                       const std::string& input);

}  // namespace se::cli
