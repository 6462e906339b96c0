/// Options of the command line that choose the input and prepare it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "controllers/start_options.h"

namespace se::view {

/// Options that need a check before they go into Options.
struct RawInput {
    std::size_t neighbors = 0;
    double radius = 0.0;
    double reach = 0.0;
    std::string box;
    std::string crop;
    std::string scanner;
    bool orient = false;
    bool deriveNormals = false;
    SampleSpec grow;
    double iso = 0.0;
};

/// Options for what is derived from the points; names as in `spiraling-edge run`.
void addPreparing(CLI::App& app, Options& o, RawInput& raw);
/// Checks them and takes them over. Throws the errors that CLI11 reports as wrong usage.
void takeOverPreparing(const RawInput& raw, Options& o);
/// All: also those for a piece of the file, and for new points; names as in `spiraling-edge run`
/// and `sample`.
void addInputOptions(CLI::App& app, Options& o, RawInput& raw);
/// Checks and takes over all of them. Throws as above.
void takeOverInput(const CLI::App& app, const RawInput& raw, Options& o);

}  // namespace se::view
