/// The points that a decision involves, for cameras and labels, and how far it looked at them.
#pragma once

#include <vector>

#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

/// The points that the decisions of a pivot involve: the pivot, its ends, the candidates that are
/// left, and other points named by the last event; in order, none twice. Without a pivot: the point
/// under test, if there is one.
std::vector<Index> neighborhoodOf(const DecisionState& picture);

/// True if the test of §6.1 (Fig. 4) went so far that the angle and the turn of the next point on
/// the ring are known: otherwise both are 0 in the evidence.
bool isMeasured(const LimitEvidence& e);

}  // namespace se::view
