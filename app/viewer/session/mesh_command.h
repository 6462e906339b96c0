/// The command line that makes the mesh which the viewer saves.
#pragma once

#include <string>

#include "jobs/mesh_export.h"
#include "run/model.h"

namespace se::view {

class Session;

/// A command line for a POSIX shell, or the reason why there is none.
struct MeshCommand {
    std::string text;  ///< One line, words quoted where a shell needs it; empty: there is none.
    std::string note;  ///< A sentence: steps of the line before the run, or why there is none.
};

/// The line for an input whose what-ifs all have an effect; intermediate files are written to the
/// folder of the mesh.
MeshCommand meshCommand(const RunSpec& spec, const MeshTarget& target);
/// The line for the open input. Requires session.ready().
MeshCommand meshCommand(const Session& session, const MeshTarget& target);

/// The name of the input as the beginning of a file's name, "torus". Requires session.ready().
std::string inputStem(const Session& session);
/// A file name without folder and extension for the mesh of the open input: "torus-mesh". Requires
/// session.ready().
std::string meshStem(const Session& session);

}  // namespace se::view
