/// Progress line of long work on a terminal.
#pragma once

#include <chrono>
#include <string>

namespace se::cli {

/// Writes to stderr if that is a terminal, at most ten times a second, and erases the line at the
class ProgressLine {
    /// end.
  public:
    /// Never writes anything if not `wanted`.
    explicit ProgressLine(bool wanted);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// True if it is time to write again; cheap enough for inner loops.
    bool due();
    /// Writes "what 42 %"; `share` is in [0, 1]. Call when due().
    void write(const std::string& what, double share);
    void clear();

  private:
    bool enabled_;
    bool dirty_ = false;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace se::cli
