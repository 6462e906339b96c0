/// The command line that makes the mesh which is saved here.
#pragma once

#include <string>

#include "run/model.h"

namespace se::view {

class Session;

/// Where a mesh is written, and with which points.
struct MeshTarget {
    std::string path;       ///< Its extension names the format (core's mesh_io.h).
    bool usedOnly = false;  ///< Without the points that stand in no triangle.
};

/// A command line for a POSIX shell, or the reason why there is none.
struct MeshCommand {
    std::string text;  ///< One line, words quoted where a shell needs it; empty: there is none.
    std::string note;  ///< A sentence: what the line does before the run, or why there is none.
};

/// The line for an input; files that it needs on the way are written beside the mesh. Requires
/// that every what-if of `spec` has an effect.
MeshCommand meshCommand(const InputSpec& spec, const MeshTarget& target);
/// The line for what is open. Requires session.ready().
MeshCommand meshCommand(const Session& session, const MeshTarget& target);

/// A file name without folder and extension for the mesh of what is open: "torus-mesh". Requires
/// session.ready().
std::string meshStem(const Session& session);

}  // namespace se::view
