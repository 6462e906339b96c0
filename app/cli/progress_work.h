/// Long work of core with a progress line.
#pragma once

#include <string>
#include <utility>

#include "exit_code.h"
#include "input.h"
#include "interrupt.h"
#include "progress.h"

namespace se::cli {

/// Runs `work`, which takes a Progress and returns a Result, while the progress line shows `what`
/// and the share done. Throws Failure if it fails or is interrupted; `input` begins the message.
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
