/// What a run amounts to: as JSON for programs, as a few lines for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/faults.h"
#include "spiraling_edge/mesh.h"
#include "spiraling_edge/params.h"
#include "spiraling_edge/prepare.h"
#include "spiraling_edge/state.h"

namespace se::cli {

/// Why the run ended.
enum class Ending { Finished, Capped, MaxPivots, Interrupted };

/// Wall clock of the parts of a run.
struct Seconds {
    double read = 0.0;
    double prepare = 0.0;
    double triangulate = 0.0;
    double write = 0.0;
};

/// Everything that the report tells.
struct RunOutcome {
    std::string input;
    std::string output;  ///< Empty if no mesh was written.
    std::string ruleSet;
    Params params;
    PrepareReport prepared;
    MeshReport mesh;
    /// Only if they were looked for.
    std::optional<std::vector<Fault>> faults;
    bool allFaults = true;  ///< False: there may be more intersections, see searchFaults().
    /// Where each of them is: the middle of its triangle.
    std::vector<Vec3> faultPlaces;
    State state;
    Seconds seconds;
    Ending ending = Ending::Finished;
};

/// "2 intersecting, 1 folded"; empty if no fault was found or looked for.
std::string faultSentence(const RunOutcome& outcome);
/// The JSON report, with an end of line behind it.
std::string reportJson(const RunOutcome& outcome);
/// The summary for people, several lines.
std::string summaryText(const RunOutcome& outcome);

}  // namespace se::cli
