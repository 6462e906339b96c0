/// The two runs of `compare`, out of one command line: IN, the options of A, and behind --with what
/// is different in B.
#pragma once

#include <string>

#include "prepared_input.h"

namespace se::cli {

/// The words behind the verb, parted.
struct ComparedWords {
    Arguments a;     ///< With the options that are of neither run, such as --json.
    Arguments with;  ///< After --with; a single quoted word is split at its blanks.
    bool hasWith = false;
};
ComparedWords partedAtWith(const Arguments& words);

/// The options of one run, read from words of their own.
class ParsedInput {
  public:
    /// Throws Failure on wrong usage, calling the words what they are on the command line.
    explicit ParsedInput(const Arguments& words);
    ParsedInput(const ParsedInput&) = delete;
    ParsedInput& operator=(const ParsedInput&) = delete;
    const InputArguments& input() const { return input_; }

  private:
    CLI::App app_;
    InputArguments input_;
};

/// The words of B, which is A but for `with`: a set of rules there takes the place of A's rules, a
/// number of neighbors that of A's radius.
Arguments wordsOfB(const InputArguments& a, const Arguments& with);

/// "--rules robust"; "the paper's rules" if no option was given.
std::string titleOf(const InputArguments& input);

}  // namespace se::cli
