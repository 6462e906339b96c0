/// What a run amounts to: as JSON for programs, as a few lines for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

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
    ColumnReading columns;
    /// The place that positions in the output are relative to, if they are.
    std::optional<Vec3> shift;
    std::string ruleSet;
    Params params;
    PrepareReport prepared;
    MeshReport mesh;
    /// Only if they were looked for.
    std::optional<std::vector<Fault>> faults;
    bool crossings = true;  ///< False: crossing triangles were not looked for.
    bool allFaults = true;  ///< False: there may be more intersections, see searchFaults().
    /// Where each of them is: the middle of its triangle.
    std::vector<Vec3> faultPlaces;
    State state;
    Seconds seconds;
    Ending ending = Ending::Finished;
};

/// "3 faults: 2 intersecting, 1 folded; --rules robust may avoid them"; empty if there are none.
std::string faultSentence(const RunOutcome& outcome);
/// The JSON report, with an end of line behind it.
std::string reportJson(const RunOutcome& outcome);
/// A line that says relative to which place the output is; empty if it is in the file's
/// coordinates.
std::string shiftText(const RunOutcome& outcome);
/// The summary for people, several lines.
std::string summaryText(const RunOutcome& outcome);

}  // namespace se::cli
