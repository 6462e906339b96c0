/// Parsing of a verb's options.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "exit_code.h"
#include "options/spec_options.h"
#include "spiraling_edge/base/files.h"
#include "verbs.h"

namespace se::cli {

/// Parses `arguments` into what `app` binds. Empty if the verb should continue; otherwise the code
/// to exit with, after the help, or with `--json` the options as data, was printed. Throws Failure
/// on wrong usage.
std::optional<ExitCode> parseArguments(CLI::App& app, const Arguments& arguments);

/// The spec of these values. Throws Failure(Usage) with the first that is not valid.
RunSpec specOf(const SpecChange& given, RunSpec spec = {});

}  // namespace se::cli
