/// Traces of a run, from this program or any other, as JSON Lines (.setrace): a header with the
/// number of points, then one line per pivot with its fan; and a run as these lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/given_start.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::teach {

/// Extension of a trace's file.
inline constexpr std::string_view kTraceExtension = ".setrace";
/// Largest trace that is read, in bytes.
inline constexpr std::size_t kMaxTraceBytes = std::size_t{1} << 28U;

/// Part of a pivot whose result a trace can hold, in the order of the paper.
enum class TraceStage : std::uint8_t {
    Sort,        ///< §6.1, Fig. 3: the candidates by angle.
    Limits,      ///< §6.1, Figs. 4 and 5: those that moved limits and convexity leave.
    Reciprocal,  ///< §6.1, Fig. 6
    Hole,        ///< §6.2
    Sphere,      ///< §6.3
    Emit,        ///< §6.4: the fan.
    Ring,        ///< §6.5: the edge ring and the next pivot.
};
inline constexpr std::size_t kTraceStageCount = static_cast<std::size_t>(TraceStage::Ring) + 1;

/// A list of points; nothing where the trace has none.
using TracedPoints = std::optional<std::vector<Index>>;

/// One pivot of a trace.
struct TracePivot {
    std::size_t line = 0;  ///< Of the file, from 1; 0: of no file.
    Index p = kNone, first = kNone, last = kNone;
    TracedPoints sort, limits, reciprocal, hole, sphere;  ///< Candidates after that stage.
    std::optional<Index> start, end;                      ///< Points of the limits after §6.1.
    TracedPoints fan;           ///< From first to last; empty: no triangle.
    TracedPoints ring;          ///< The active edge ring after the pivot, from the next one.
    std::optional<Index> next;  ///< The next pivot; kNone: no ring is left.
    /// The trace is meant to end with this pivot, which may lack its last stages.
    bool ends = false;
    // Written, not read: what a test of one stage needs to know of the run before the pivot.
    std::vector<std::vector<Index>> stack;  ///< The other rings after the pivot, bottom first.
    std::vector<RingStep> open;             ///< Steps of all rings that are no edges of the mesh.
    std::vector<Index> done;                ///< Points that this pivot, or its seed, made DONE.
};

/// One row of the table of stages.
struct TraceStageRow {
    TraceStage id;
    std::string_view name;             ///< "sort", as on the command line.
    std::string_view field;            ///< "sort"; of emit, "fan".
    Phase phase;                       ///< After which a run has its result.
    Stage last;                        ///< Of the decisions that lead to its result.
    TracedPoints TracePivot::*points;  ///< Result of the stage.
};
/// True if the pivot has the result of a stage, or was passed over, so that there is none before
/// its ring.
bool hasStage(const TracePivot& pivot, TraceStage stage);
/// All stages, in the order of the enum.
std::span<const TraceStageRow> traceStages();
const TraceStageRow& rowOf(TraceStage stage);

/// A trace.
struct Trace {
    std::size_t points = 0;
    std::string hash;  ///< pointsHash() of the input; empty: not given.
    std::vector<TracePivot> pivots;
};

/// Hash of the positions: 64-bit FNV-1a of x, y and z of each point, in their order, as doubles in
/// little endian.
std::string pointsHash(const PointSet& points);

/// The first line of a trace.
std::string traceHeader(const PointSet& points);
/// The line of a pivot, with what it has: empty lists of `stack`, `open` and `done` are left out.
std::string traceLine(const TracePivot& pivot);

/// Reads a trace. `upto`: the last stage that has to be in each line but the last one, whose
/// program may have stopped there, and but for pivots that were passed over, with an empty fan;
/// those before it may be missing. Fails with name, line and field: no JSON, not UTF-8, a cut line,
/// a point that does not exist, a fan that does not lead from first to last. Unknown fields are
/// passed over.
Result<Trace> readTrace(std::string_view text, const std::string& name,
                        TraceStage upto = TraceStage::Emit);
/// As readTrace(), of a file of at most kMaxTraceBytes.
Result<Trace> readTraceFile(const std::string& path, TraceStage upto = TraceStage::Emit);

/// Success if the trace is of `points`: their number and their hash, if it has one.
Status requireTraceOf(const Trace& trace, const PointSet& points, const std::string& name);

/// The points of a ring from an entry on.
std::vector<Index> ringFrom(const EdgeRings& rings, Index entry);

/// Content of a recorded pivot.
enum class TraceDetail : std::uint8_t {
    Fans,    ///< Pivot, first, last and fan.
    Stages,  ///< Also the candidates after each stage, the rings, and what became DONE.
};

/// One step of a run.
struct TraceStep {
    bool ran = false;                 ///< False at the end of the run, as Stepper::stepPivot().
    std::optional<TracePivot> pivot;  ///< Nothing for a step after the last pivot.
};

/// Runs `stepper` to the end of its next pivot. Requires that it stands between two pivots.
TraceStep stepTraced(Stepper& stepper, TraceDetail detail);

}  // namespace se::teach
