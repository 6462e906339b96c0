/// Exit codes of the program, and the exception by which a verb ends early.
#pragma once

#include <stdexcept>
#include <string>

namespace se::cli {

/// The exit codes of every verb (see README.md).
enum class ExitCode : int {
    Good = 0,
    CheckFailed = 1,  ///< The run ended, but its result has a fault.
    Usage = 2,        ///< Wrong command line.
    Input = 3,        ///< The input is missing or malformed.
    NoDisplay = 4,    ///< No display, no OpenGL or no viewer.
    Internal = 5,     ///< A bug, or the result could not be written.
};

/// Thrown by a verb that cannot continue; main() prints the message and exits with the code.
class Failure : public std::runtime_error {
  public:
    Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

}  // namespace se::cli
