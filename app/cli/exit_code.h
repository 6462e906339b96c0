/// How the program ends, and how a verb says that it cannot go on.
#pragma once

#include <stdexcept>
#include <string>

namespace se::cli {

/// The exit codes of every verb (see README.md).
enum class ExitCode : int {
    Good = 0,
    CheckFailed = 1,    ///< It ran, but the result is not what it should be.
    Usage = 2,          ///< Wrong command line.
    Input = 3,          ///< The input is missing or malformed.
    NoDisplay = 4,      ///< No display, no OpenGL or no viewer.
    Internal = 5,       ///< A bug of ours, or the result could not be written.
    Interrupted = 130,  ///< Ctrl+C.
};

/// Thrown by a verb that cannot go on; main() prints the message and ends with the code.
class Failure : public std::runtime_error {
  public:
    Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

}  // namespace se::cli
