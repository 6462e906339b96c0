/// The verbs of `spiraling-edge VERB ...`: one function and one file each, tabled in main.cpp.
#pragma once

#include <string>
#include <vector>

#include "exit_code.h"

namespace se::cli {

/// What stands behind the verb on the command line.
using Arguments = std::vector<std::string>;

/// Triangulates points; writes mesh, report and trace.
ExitCode runVerb(const Arguments& arguments);
/// Says what a file holds.
ExitCode infoVerb(const Arguments& arguments);
/// Says what in a file will upset the algorithm, and mends it.
ExitCode doctorVerb(const Arguments& arguments);
/// Says what is wrong with a mesh.
ExitCode checkVerb(const Arguments& arguments);
/// Two runs, or a run and a mesh, side by side.
ExitCode compareVerb(const Arguments& arguments);
/// The fewest points that still fail.
ExitCode reduceVerb(const Arguments& arguments);
/// Samples an isosurface.
ExitCode sampleVerb(const Arguments& arguments);
/// The paper's Table 1 beside ours.
ExitCode table1Verb(const Arguments& arguments);
/// Why something is in the mesh, or why not.
ExitCode whyVerb(const Arguments& arguments);
/// Lists the built-in scenes.
ExitCode scenesVerb(const Arguments& arguments);
/// Hands over to the viewer. Returns only by throwing.
ExitCode viewVerb(const Arguments& arguments);
/// The same without a window: writes a picture. Returns only by throwing, or after its help.
ExitCode renderVerb(const Arguments& arguments);

}  // namespace se::cli
