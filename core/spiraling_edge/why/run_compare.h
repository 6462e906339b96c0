/// Comparison of two runs step by step: the part in which they agree, and the decision at which
/// they diverge.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/why/ledger.h"

namespace se {

/// The input of a run. Both must outlive this object and its users.
struct ComparedRun {
    const PointSet& points;
    const Params& params;
};

/// One of the two runs at a difference.
struct DifferenceSide {
    /// The run makes the decision in question. Else it never reaches it, since the point is in no
    /// list there, or no rule tests it; `line` is then its next event.
    bool decides = false;
    /// Nothing if this run has already ended.
    std::optional<LedgerLine> line;
};

/// A decision that the two runs make differently after the same steps.
struct RunDifference {
    DifferenceSide a, b;
    std::string words;  ///< One sentence that names both.
};

/// A mesh, and the decision that made each triangle.
struct MadeMesh {
    std::vector<Triangle> triangles;
    /// For each triangle: the address of its `emit`, or of the step after the last pivot that made
    /// it.
    std::vector<Address> made;
    /// The triangles of the pivots, in their order, where later steps have changed the mesh; else
    /// empty.
    std::vector<Triangle> emitted;
    std::uint32_t pivots = 0;  ///< Pivots of the run, including the steps after the last pivot.

    /// The triangles in the order in which the run made them.
    const std::vector<Triangle>& inOrder() const { return emitted.empty() ? triangles : emitted; }
};

/// The first decision that made one of these triangles (positions in the list); nothing if the mesh
/// has no record of them.
std::optional<Address> firstMade(const MadeMesh& mesh, std::span<const Index> triangles);

/// Runs to the end. Fails only if `progress` cancels. O(run).
Result<MadeMesh> makeMesh(const ComparedRun& run, const Progress& progress = {});

struct RunComparison {
    /// The first decision with a consequence: after its pivot the rings or the triangles differ.
    /// Nothing if the runs agree from the first pivot to the last.
    std::optional<RunDifference> first;
    std::uint32_t commonPivots = 0;  ///< Pivots before `first`, in which the runs agree.
    /// The first different decision without a consequence, in the pivots before `first`.
    std::optional<RunDifference> harmless;
    std::uint32_t harmlessPivots = 0;  ///< Pivots with such decisions.
    MadeMesh a, b;
};

/// Runs both, in step up to the first difference. They may have other rules, other neighbor lists,
/// normals or types. A point that only one of them tests because only its lists hold it counts as a
/// difference only if it has a consequence. Fails if their numbers of points differ, or if
/// `progress` cancels. Requires valid PointSets. Deterministic. O(both runs).
Result<RunComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const Progress& progress = {});

}  // namespace se
