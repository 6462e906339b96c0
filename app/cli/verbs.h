/// Verbs of `spiraling-edge VERB ...`: one function and one file each, tabled in main.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "exit_code.h"

namespace se::cli {

/// Words after the verb on the command line.
using Arguments = std::vector<std::string>;

/// Parses `arguments` into what `app` binds. Empty if the verb should continue; otherwise the code
/// to exit with, after the help, or with `--json` the options as data, was printed. Throws Failure
/// on wrong usage.
std::optional<ExitCode> parseArguments(CLI::App& app, const Arguments& arguments);

/// Triangulates points; writes mesh, report and trace.
ExitCode runVerb(CLI::App& app, const Arguments& words);
/// Prints file information.
ExitCode infoVerb(CLI::App& app, const Arguments& words);
/// Finds what in a file causes trouble, and fixes what needs no guessing.
ExitCode doctorVerb(CLI::App& app, const Arguments& words);
/// Finds the faults of a mesh.
ExitCode checkVerb(CLI::App& app, const Arguments& words);
/// Compares two runs, or a run and a mesh.
ExitCode compareVerb(CLI::App& app, const Arguments& words);
/// Compares the trace of another implementation with a run.
ExitCode diffVerb(CLI::App& app, const Arguments& words);
/// Reduces an input to a minimal failing case.
ExitCode reduceVerb(CLI::App& app, const Arguments& words);
/// Samples an isosurface.
ExitCode sampleVerb(CLI::App& app, const Arguments& words);
/// Prints the paper's Table 1 beside the results of this program.
ExitCode table1Verb(CLI::App& app, const Arguments& words);
/// Explains why something is in the mesh, or why not.
ExitCode whyVerb(CLI::App& app, const Arguments& words);
/// Prints the figures of the paper, and checks them.
ExitCode figuresVerb(CLI::App& app, const Arguments& words);
/// Lists, shows, checks and begins lessons, and sums up results.
ExitCode lessonVerb(CLI::App& app, const Arguments& words);
/// Prints a pivot to play by hand, and grades a try.
ExitCode practiceVerb(CLI::App& app, const Arguments& words);
/// Lists the built-in scenes.
ExitCode scenesVerb(CLI::App& app, const Arguments& words);
/// Starts the viewer. Returns only by throwing.
ExitCode viewVerb(CLI::App& app, const Arguments& words);
/// Writes a picture by the viewer, without a window. Returns only by throwing, or after its help.
ExitCode renderVerb(CLI::App& app, const Arguments& words);
ExitCode exportVerb(CLI::App& app, const Arguments& words);

}  // namespace se::cli
