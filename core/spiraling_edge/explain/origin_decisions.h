/// The origin of triangles that fill the gap between three points (§6.4).
#pragma once

#include <map>
#include <optional>
#include <span>

#include "spiraling_edge/explain/ledger.h"

namespace se {

/// For triangles that are the whole fan of their pivot, by number: the decision in an earlier pivot
/// that made the last of their edges, traced through further such triangles if necessary. Triangles
/// without one are left out. Nothing if cancelled. Two runs.
std::optional<std::map<Index, LedgerLine>> originDecisions(const PointSet& points,
                                                           const Params& params,
                                                           std::span<const Index> triangles,
                                                           const Progress& progress = {});

}  // namespace se
