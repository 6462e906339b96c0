/// Long work of the core, done for a verb.
#pragma once

#include <string>
#include <utility>

#include "exit_code.h"
#include "input.h"
#include "interrupt.h"
#include "progress.h"

namespace se::cli {

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
