/// The tests of a pivot that determine a triangle of its fan.
#pragma once

#include <optional>
#include <vector>

#include "spiraling_edge/explain/ledger.h"

namespace se {

bool hasCorner(const Triangle& t, Index p);

/// True if only first and last are left and make a triangle (§6.4).
bool fillsHole(const Event& event);

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

}  // namespace se
