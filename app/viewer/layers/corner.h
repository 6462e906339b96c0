/// A corner of the edge ring: the free angle at one of its points.
#pragma once

#include "disc.h"

namespace se::view {

/// From `before` counterclockwise to `after` at `point`.
struct RingCorner {
    Index before = kNone;
    Index point = kNone;
    Index after = kNone;
    bool concave = false;
};

/// Filled where the ring is concave, hollow where it is convex (§6.1, Figs. 4 and 5).
void addCorner(const LayerInput& in, const RingCorner& corner, DrawList& out);

/// The angle of a position on a disc, in [0, 360).
double degreesOn(const Disc& disc, const glm::vec3& place);

}  // namespace se::view
