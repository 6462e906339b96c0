/// The option --start: the state that a run begins with.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se::cli {

class StartArguments {
  public:
    void addTo(CLI::App& app);
    /// The file of the option; empty if it was not given.
    const std::string& path() const { return path_; }
    /// The start of the file; without one that of the scene `input`, if it has one. Throws
    /// Failure(Input).
    GivenStart start(const std::string& input) const;
    /// Throws Failure(Input) if a run on `points` of `input` cannot begin with `start`.
    void require(const PointSet& points, const GivenStart& start, const std::string& input) const;

  private:
    std::string path_;
};

/// Throws Failure(Usage) if there is a start, which names points by numbers, for work that changes
/// them: `what` ("--crop") begins the message.
void requireNoStart(const GivenStart& start, const std::string& what);

}  // namespace se::cli
