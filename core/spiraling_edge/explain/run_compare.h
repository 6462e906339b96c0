/// Two runs step by step: up to where they do the same, and the decision at which they part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/explain/ledger.h"

namespace se {

/// What a run is made of. Both must outlive what uses it.
struct ComparedRun {
    const PointSet& points;
    const Params& params;
};

/// One of the two runs at a place where they differ.
struct DifferenceSide {
    /// It takes the decision in question. Else it does not come to it, since the point is in no
    /// list there, or no rule asks; `line` is what it does next.
    bool decides = false;
    /// Nothing if this run is over by then.
    std::optional<LedgerLine> line;
};

/// A decision that the two runs, after the same steps, take differently.
struct RunDifference {
    DifferenceSide a, b;
    std::string words;  ///< One sentence that names both.
};

/// A mesh, and the decision that made each triangle.
struct MadeMesh {
    std::vector<Triangle> triangles;
    /// Of each triangle: the address of its `emit`, or of the step after the last pivot that left
    /// it.
    std::vector<Address> made;
    /// Those of the pivots, in their order, where later steps have left others; else empty.
    std::vector<Triangle> emitted;
    std::uint32_t pivots = 0;  ///< Of the run, the steps after the last pivot among them.

    /// As the run made them, one by one.
    const std::vector<Triangle>& inOrder() const { return emitted.empty() ? triangles : emitted; }
};

/// The first decision that made one of these triangles (positions in the list); nothing if the mesh
/// does not know what made them.
std::optional<Address> firstMade(const MadeMesh& mesh, std::span<const Index> triangles);

/// Runs to the end. Fails only if `progress` cancels. O(run).
Result<MadeMesh> makeMesh(const ComparedRun& run, const Progress& progress = {});

struct RunComparison {
    /// The first decision with a consequence: behind its pivot the rings or the triangles differ.
    /// Nothing if the runs make the same from the first pivot to the last.
    std::optional<RunDifference> first;
    std::uint32_t pivotsAlike = 0;  ///< That make the same, before `first`.
    /// The first decision taken differently without a consequence, in the pivots before `first`.
    std::optional<RunDifference> harmless;
    std::uint32_t harmlessPivots = 0;  ///< Pivots with such decisions.
    MadeMesh a, b;
};

/// Runs both, in step up to the first difference. They may have other rules, other neighbor lists,
/// normals or types. What only one of them looks at because only its lists hold it counts as a
/// difference only if it has a consequence. Fails if they have not the same number of points, or if
/// `progress` cancels. Requires valid PointSets. Deterministic. O(both runs).
Result<RunComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const Progress& progress = {});

}  // namespace se
