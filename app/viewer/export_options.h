/// Options of the command line for `spiraling-edge export`, which hands over to this program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "document/link.h"
#include "document/start_options.h"

namespace se::view {

/// Options that need a check before they go into Options.
struct RawExport {
    std::string path;
    std::string from;
    std::string to;
    std::string around;
    std::string unit;
    std::string steps;
    std::string captions;
    std::string dial;
    double perSecond = 2.0;
    bool program = false;
    std::string viewer{webAddress()};
};

/// Options without a line in the help: `spiraling-edge export --help` has them.
void addExportOptions(CLI::App& app, RawExport& raw);
/// Checks and takes over all of them, except steps. Throws the errors that CLI11 reports as wrong
/// usage.
void takeOverExport(const CLI::App& app, const RawExport& raw, Options& o);

/// Reads the lesson that FILE names, with the steps to export; without a lesson or a position, the
/// end of the run. Fails with a sentence; `code` is then the exit code.
Status adoptLesson(Options& o, int& code);

}  // namespace se::view
