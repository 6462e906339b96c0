/// The frames of a range of a run, and the points that one camera has to hold for all of them.
#pragma once

#include <string>
#include <vector>

#include "order.h"
#include "run/model.h"

namespace se::view {

/// Greatest number of frames of a range.
inline constexpr std::size_t kMaxFrames = 10'000;

/// The frames of a range, in the order of the run.
struct FramePlan {
    std::vector<std::string> places;  ///< Addresses; empty: the start of the run.
    std::vector<Index> points;        ///< Points of the decisions, ascending.
    std::vector<Index> pivots;        ///< Ascending.
};

/// Runs the input of `model` as far as the range goes. Fails with a sentence if a position is not
/// in the run, if the second lies before the first, or if there are no frames or too many.
Result<FramePlan> planFrames(const Model& model, const FrameRange& range);

}  // namespace se::view
