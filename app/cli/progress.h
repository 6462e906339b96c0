/// The line on a terminal that says how far long work has come.
#pragma once

#include <chrono>
#include <string>

namespace se::cli {

/// Writes to stderr if that is a terminal, at most ten times a second, and cleans up behind itself.
class ProgressLine {
  public:
    /// Never writes anything if not `wanted`.
    explicit ProgressLine(bool wanted);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// True if it is time to write again. Cheap enough to be asked often.
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
