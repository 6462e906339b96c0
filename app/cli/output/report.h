/// Results of a run: as JSON, and as a few lines of text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/trial.h"

namespace se::cli {

/// Wall clock of the parts of a run.
struct Seconds {
    double read = 0.0;
    double trials = 0.0;  ///< Of --best.
    double prepare = 0.0;
    double judge = 0.0;  ///< To prepare the points that faults are judged by.
    double triangulate = 0.0;
    double write = 0.0;
};

/// Everything that the report contains.
struct RunOutcome {
    std::string input;
    std::string output;  ///< Empty if no mesh was written.
    InputPiece read;
    /// Offset that positions in the output are relative to, if any.
    std::optional<Vec3> shift;
    RunSpec spec;                  ///< Of the run, with --best the best.
    std::optional<Trials> trials;  ///< Of --best.
    Params params;
    PrepareReport prepared;
    /// Empty if faults were not searched; without a judge the inspection alone.
    JudgedMesh judged;
    /// Null: intersecting triangles and second layers were not searched.
    std::shared_ptr<const MeshJudge> judge;
    State state;
    Seconds seconds;
    StopReason ending = StopReason::Finished;  ///< Condition: after --max-pivots.

    const MeshReport& mesh() const { return judged.inspection.report; }
};

/// "the mesh has 3 faults at 2 places: 2 holes, 1 folded; --best may avoid them", "no fault
/// found, but the search ended early"; empty if the mesh is sound, or faults were not searched.
std::string faultSentence(const RunOutcome& outcome);
/// The JSON report, ending in a newline.
std::string reportJson(const RunOutcome& outcome);
/// A line with the offset that the output is relative to; empty if it is in the file's
/// coordinates.
std::string shiftText(const RunOutcome& outcome);
/// The summary, several lines.
std::string summaryText(const RunOutcome& outcome);

}  // namespace se::cli
