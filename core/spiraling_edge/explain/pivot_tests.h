/// The tests of a pivot that a triangle of its fan may come from.
#pragma once

#include <optional>
#include <vector>

#include "spiraling_edge/explain/ledger.h"

namespace se {

bool hasCorner(const Triangle& t, Index p);

/// The pivot's first and last are the only corners that are left, and make a triangle (§6.4).
bool fillsHole(const Event& event);

/// A candidate between two others went: they are neighbors on the rim of the fan now.
const SphereEvidence* closedGap(const Event& event);

/// The last test that took a corner of `made`, or took away what lay between two of them; nothing
/// if the fan is first and last alone. `decided` are the lines of the pivot, in order.
std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided,
                                       const Triangle& made);

/// The same for an edge of it: the last test that took one of its ends, the pivot not counted, or
/// that took away what lay between both.
std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided, Index a, Index b);

}  // namespace se
