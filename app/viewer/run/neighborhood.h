/// The points that a decision involves, for cameras and labels.
#pragma once

#include <vector>

#include "spiraling_edge/replay/pivot_replay.h"

namespace se::view {

/// The points that the decisions of a pivot involve: the pivot, its ends, the candidates that are
/// left, and other points named by the last event; in order, none twice. Without a pivot: the point
/// under test, if there is one.
std::vector<Index> neighborhoodOf(const DecisionState& picture);

}  // namespace se::view
