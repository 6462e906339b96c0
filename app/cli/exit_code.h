/// Exit codes of the program, and the exception by which a verb ends early.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "spiraling_edge/base/result.h"

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
    /// With a message as of fmt::format().
    template <typename... Values>
    Failure(ExitCode code, fmt::format_string<Values...> form, Values&&... values)
        : Failure(code, fmt::format(form, std::forward<Values>(values)...)) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

/// Throws Failure(Usage) with a message as of fmt::format().
template <typename... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> form, Values&&... values) {
    throw Failure(ExitCode::Usage, form, std::forward<Values>(values)...);
}

/// The value of a result. Throws Failure with its error, which `before` begins.
template <typename Value>
Value require(Result<Value> result, ExitCode code, const std::string& before = "") {
    if (!result) throw Failure(code, before + result.error().message);
    return std::move(result).value();
}

}  // namespace se::cli
