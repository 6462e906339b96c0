/// Points as the algorithm gets them: the options that choose rules and derive missing data, and
/// the preparation itself, for verbs that query a run.
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "output/output.h"
#include "piece_input.h"
#include "progress.h"
#include "start_arguments.h"

namespace se::cli {

/// A run that has not started.
struct PreparedInput {
    PointFile file;  ///< As read, repaired by applyFixes(), with the normals and types of `points`.
    PointSet points;
    Params params;
};

/// An option as it was given.
struct GivenOption {
    std::string name;                ///< "rule"
    std::vector<std::string> words;  ///< "--rule", "flip=off", "--rule", "rim=off"
};

/// The same options as those of `run`.
class InputArguments {
  public:
    void addTo(CLI::App& app);
    const std::string& input() const { return input_; }
    /// All files that are read, for ForceOption::require().
    NamedFiles files() const { return {{"", input_}, {"--start", start_.path()}}; }
    const ByteLimit& limit() const { return limit_; }
    const std::string& ruleSet() const { return rules_.setName(); }
    /// The options that were given, without the input. The app must outlive this object.
    std::vector<GivenOption> given() const;
    /// Words of the given options, each option followed by its value.
    std::vector<std::string> options() const;
    PrepareOptions prepareOptions(const PointFile& file) const;
    /// Reads input(), or the piece of it that the options choose; then prints what was kept to
    /// stderr, if messages are wanted. Throws Failure.
    PointFile read(const ProgressLine& line) const;
    /// Reads and prepares, with the line of progress. Throws Failure.
    PreparedInput prepare(ProgressLine& line) const;
    /// Prepares what read() has returned. Throws Failure.
    PreparedInput prepare(PointFile file, ProgressLine& line) const;

  private:
    Params params() const;
    /// Throws Failure(Usage) if a piece was chosen, whose points have other numbers than a start.
    void requireWhole(const GivenStart& start) const;

    std::string input_;
    PieceArguments piece_;
    RuleArguments rules_;
    StartArguments start_;
    NeighborArguments neighbors_;
    DerivedArguments derived_;
    ByteLimit limit_;
    std::vector<const CLI::Option*> options_;
};

}  // namespace se::cli
