/// The two runs of `compare`, from one command line: IN, the options of A, and after --with the
/// options in which B differs.
#pragma once

#include <string>

#include "prepared_input.h"

namespace se::cli {

/// Words after the verb, split into the two runs.
struct ComparedWords {
    Arguments a;     ///< Includes the options that belong to neither run, such as --json.
    Arguments with;  ///< After --with; a single quoted word is split at its blanks.
    bool hasWith = false;
};
ComparedWords splitAtWith(const Arguments& words);

/// Options of one run, parsed from their own list of words.
class ParsedInput {
  public:
    /// Throws Failure on wrong usage; its message names the words as given on the command line.
    explicit ParsedInput(const Arguments& words);
    ParsedInput(const ParsedInput&) = delete;
    ParsedInput& operator=(const ParsedInput&) = delete;
    const InputArguments& input() const { return input_; }

  private:
    CLI::App app_;
    InputArguments input_;
};

/// The words of B: those of A, changed by `with`. A rule set there replaces the rules of A, a
/// number of neighbors the radius of A.
Arguments optionsOfB(const InputArguments& a, const Arguments& with);

/// "--rules robust"; "the paper's rules" if no option was given.
std::string titleOf(const InputArguments& input);

}  // namespace se::cli
