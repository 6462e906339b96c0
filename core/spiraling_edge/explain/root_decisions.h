/// Where the triangles come from that fill what is left between three points (§6.4).
#pragma once

#include <map>
#include <optional>
#include <span>

#include "spiraling_edge/explain/ledger.h"

namespace se {

/// Of triangles that are the whole fan of their pivot, by their number: the decision that the last
/// of their edges comes from, in an earlier pivot; through such triangles again, if need be. Those
/// without one are left out. Nothing if cancelled. Two runs.
std::optional<std::map<Index, LedgerLine>> rootDecisions(const PointSet& points,
                                                         const Params& params,
                                                         std::span<const Index> triangles,
                                                         const Progress& progress = {});

}  // namespace se
