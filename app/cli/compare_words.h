/// The two runs of `compare`, from one command line: IN, the options of A, and after --with the
/// options in which B differs.
#pragma once

#include <string>

#include "input.h"

namespace se::cli {

/// Words after the verb, split into the two runs.
struct ComparedWords {
    Arguments a;     ///< Includes the options that belong to neither run, such as --json.
    Arguments with;  ///< After --with; a single quoted word is split at its blanks.
    bool hasWith = false;
};
ComparedWords splitAtWith(const Arguments& words);

/// The spec of B: that of A, changed by `with` (otherRun()). Throws Failure(Usage) if a word is
/// not understood, or changes the points.
RunSpec specOfB(const RunSpec& a, const Arguments& with);

/// "--rules robust"; "the paper's rules" if nothing is set.
std::string titleOf(const RunSpec& spec);

}  // namespace se::cli
