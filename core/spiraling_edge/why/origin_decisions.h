/// The decisions that triangles come from: the tests of their pivot, or where they fill the gap
/// between three points (§6.4), those of an earlier one.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/why/ledger.h"

namespace se {

bool hasCorner(const Triangle& t, Index p);

/// True if only first and last are left and make a triangle (§6.4).
bool fillsHole(const Event& event);

/// A candidate that a move of start or end left outside (§6.1, Fig. 4); null for other events.
const DropEvidence* passedBy(const Event& event);
/// True if this move of start or end goes past the candidate. Requires a LimitEvidence.
bool passes(const Event& move, const DropEvidence& candidate);

/// The removal of a candidate between two others, which then are neighbors in the fan; null for
/// other events.
const SphereEvidence* closedGap(const Event& event);

/// The last test that took a corner of `made`, or removed a candidate between two of them; nothing
/// if the fan is first and last alone. `decided` are the lines of the pivot, in order.
std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided,
                                       const Triangle& made);

/// The last test that took an end of the edge a b, the pivot not counted, or that removed a
/// candidate between both.
std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided, Index a, Index b);

/// For triangles that are the whole fan of their pivot, by number: the decision in an earlier pivot
/// that made the last of their edges, traced through further such triangles if necessary. Triangles
/// without one are left out. Nothing if cancelled. Two runs.
std::optional<std::map<Index, LedgerLine>> originDecisions(const PointSet& points,
                                                           const Params& params,
                                                           std::span<const Index> triangles,
                                                           const Progress& progress = {});

}  // namespace se
