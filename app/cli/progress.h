/// Long work on a terminal: a progress line. Ctrl+C needs nothing here: it ends the program at once
/// (atomic_file.h).
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "exit_code.h"

namespace se::cli {

/// Name of an input in messages: "standard input" for -.
std::string nameOfInput(const std::string& input);

/// Writes to stderr if that is a terminal, at most ten times a second, and erases the line at the
/// end.
class ProgressLine {
  public:
    /// Never writes anything if not `wanted`.
    explicit ProgressLine(bool wanted);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// False if the user wants no messages.
    bool isWanted() const { return wanted_; }
    /// True if it is time to write again; cheap enough for inner loops.
    bool due();
    /// Writes "what 42 %"; `share` is in [0, 1]. Call when due().
    void write(const std::string& what, double share);
    void clear();

  private:
    bool wanted_;
    bool enabled_;
    bool dirty_ = false;
    std::chrono::steady_clock::time_point last_;
};

/// Runs `work`, which takes a Progress and returns a Result, while the progress line shows `what`
/// and the share done. Throws Failure if it fails; `input` begins the message.
template <typename Work>
auto runWithProgress(const std::string& what, const std::string& input, ProgressLine& line,
                     Work&& work) {
    auto result = work([&](double share) {
        if (line.due()) line.write(what, share);
        return true;
    });
    line.clear();
    return require(std::move(result), ExitCode::Input, nameOfInput(input) + ": ");
}

}  // namespace se::cli
