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

/// Throws Failure: the list of the run on `input`, which has these failures in all, lacks it.
[[noreturn]] void noSuchFailure(std::span<const ClassTotal> totals, const FailureChoice& wanted,
                                const std::string& input);

/// The chosen failure of a list, with or without its moments; kindOf(failure) is its class. Throws
/// as noSuchFailure() if it is not there.
template <typename Listed, typename KindOf>
const Listed& pickFailure(const std::vector<Listed>& list, KindOf kindOf,
                          std::span<const ClassTotal> totals, const FailureChoice& wanted,
                          const std::string& input) {
    std::size_t seen = 0;
    for (const Listed& each : list) {
        if (kindOf(each) == wanted.kind && ++seen == wanted.number) return each;
    }
    noSuchFailure(totals, wanted, input);
}

}  // namespace se::cli
