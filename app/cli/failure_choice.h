/// One failure of a run, named on the command line: CLASS or CLASS:N.
#pragma once

#include <string>

#include "spiraling_edge/why/failure_moments.h"

namespace se::cli {

/// A class of failures and a number within it.
struct FailureChoice {
    const FailureClass* kind;
    std::size_t number;  ///< From 1.
};

/// Throws Failure if there is no such class, or N is no number.
FailureChoice failureChoiceFrom(const std::string& text);

/// The chosen failure. Throws Failure if the list of the run on `input` lacks it.
MeshFailure pickFailure(const MeshInspection& found, const FailureChoice& choice,
                        const std::string& input);
/// The chosen failure with its moments. Throws Failure if the list lacks it.
RunFailure pickFailure(const RunFailureSearch& found, const FailureChoice& choice,
                       const std::string& input);

}  // namespace se::cli
