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
ExitCode runVerb(const Arguments& arguments);
/// Prints file information.
ExitCode infoVerb(const Arguments& arguments);
/// Finds what in a file causes trouble, and fixes what needs no guessing.
ExitCode doctorVerb(const Arguments& arguments);
/// Finds the faults of a mesh.
ExitCode checkVerb(const Arguments& arguments);
/// Compares two runs, or a run and a mesh.
ExitCode compareVerb(const Arguments& arguments);
/// Compares the trace of another implementation with a run.
ExitCode diffVerb(const Arguments& arguments);
/// Reduces an input to a minimal failing case.
ExitCode reduceVerb(const Arguments& arguments);
/// Samples an isosurface.
ExitCode sampleVerb(const Arguments& arguments);
/// Prints the paper's Table 1 beside the results of this program.
ExitCode table1Verb(const Arguments& arguments);
/// Explains why something is in the mesh, or why not.
ExitCode whyVerb(const Arguments& arguments);
/// Prints the figures of the paper, and checks them.
ExitCode figuresVerb(const Arguments& arguments);
/// Lists, shows, checks and begins lessons, and sums up results.
ExitCode lessonVerb(const Arguments& arguments);
/// Prints a pivot to play by hand, and grades a try.
ExitCode practiceVerb(const Arguments& arguments);
/// Lists the built-in scenes.
ExitCode scenesVerb(const Arguments& arguments);
/// Starts the viewer. Returns only by throwing.
ExitCode viewVerb(const Arguments& arguments);
/// Writes a picture by the viewer, without a window. Returns only by throwing, or after its help.
ExitCode renderVerb(const Arguments& arguments);
ExitCode exportVerb(const Arguments& arguments);

}  // namespace se::cli
