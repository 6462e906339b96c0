/// The trace of another implementation as a run to look at: the mesh that its fans lay, pivot by
/// pivot, and the rings and statuses that follow from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/why/run_compare.h"
#include "teach/trace/trace_diff.h"

namespace se::view {

/// A position in a trace.
struct TracePosition {
    std::uint32_t pivot = 0;  ///< From 1; 0: before the first.
    std::size_t laid = 0;     ///< Triangles of its fan so far.
    bool complete = false;    ///< After the pivot: all of the fan is laid.
    friend bool operator==(const TracePosition&, const TracePosition&) = default;
};

class TraceReplay {
  public:
    /// `given`: triangles that the run begins with. Requires that the points of the trace are less
    /// than `pointCount`.
    TraceReplay(teach::Trace trace, std::vector<Triangle> given, std::size_t pointCount);

    std::uint32_t pivots() const { return static_cast<std::uint32_t>(trace_.pivots.size()); }
    const teach::Trace& trace() const { return trace_; }
    /// The mesh at the end, its triangles in the order of the fans; `made`: with the address that
    /// an `emit` of ours would have.
    const MadeMesh& mesh() const { return mesh_; }
    /// Triangles of the fan of a pivot, from 1.
    std::span<const Triangle> fanOf(std::uint32_t pivot) const;
    /// The state at a position, without a decision. The rings are the loops of edges with a single
    /// triangle, or the active ring of the trace; a point is DONE once it was a pivot, or no such
    /// edge has it. O(triangles so far).
    DecisionState stateAt(const TracePosition& position) const;
    /// "Pivot 8 of the trace: point 11 between 1 and 3, fan 1 4 3."
    std::string sentence(const TracePosition& position) const;

  private:
    std::vector<RingPath> ringsAt(std::size_t triangles, std::uint32_t pivots) const;

    teach::Trace trace_;
    std::size_t pointCount_;
    MadeMesh mesh_;
    std::vector<std::size_t> begin_;  ///< First triangle of each pivot's fan, and the end.
};

/// A trace beside the open run, and their first difference.
struct ComparedTrace {
    TraceReplay replay;
    teach::TraceComparison comparison;
    std::string guess;  ///< A sentence on the rules that account for it; empty: no difference.
};

}  // namespace se::view
