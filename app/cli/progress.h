/// The line on a terminal that says how far long work has come.
///
/// Ctrl+C as a question that long work asks now and then.
///
/// Long work of the core, done for a verb.
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "exit_code.h"
#include "input.h"

namespace se::cli {

/// From now on the first Ctrl+C is only noted; the second ends the program as usual.
void catchInterrupts();
bool interrupted();
/// From now on Ctrl+C ends the program at once.
void releaseInterrupts();

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

/// Does `work`, which is given a Progress and returns a Result, with the line telling `what` is
/// done. Throws Failure if it fails, or is interrupted; `input` begins the message.
template <typename Work>
auto workedOut(const std::string& what, const std::string& input, ProgressLine& line, Work&& work) {
    auto result = work([&](double share) {
        if (line.due()) line.write(what, share);
        return !interrupted();
    });
    line.clear();
    if (interrupted()) throw Failure(ExitCode::Interrupted, "interrupted; nothing was written");
    if (!result) throw Failure(ExitCode::Input, nameOfInput(input) + ": " + result.error().message);
    return std::move(result.value());
}

}  // namespace se::cli
