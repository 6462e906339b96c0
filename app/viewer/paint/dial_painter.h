/// The dial as a drawing: one disc of a tangent plane, and the smaller one of a ring point.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "layout/dial.h"
#include "painter.h"
#include "rows/pivot_dial.h"

namespace se::view {

/// A dial, the names of its points, and those that the user points at and has selected.
struct DialPicture {
    const Dial& dial;
    std::span<const PointName> names;
    Index hovered = kNone;
    Index selected = kNone;
};

/// The largest disc in `room` that leaves room for the names of all important points, tested or
/// not, so that it does not move during the decisions of a pivot.
DialCircle discOf(const Painter& painter, const DialPicture& picture, const Rect& room);
/// Draws the dial of the pivot, nothing outside of `room`. `taken`: the part of it that is used
/// already.
void drawDialDisc(Painter& painter, const DialPicture& picture, const DialCircle& disc,
                  const Rect& room, std::span<const Rect> taken = {});
/// The place of a neighbor on the disc.
glm::vec2 placeOf(const DialTick& tick, const DialCircle& disc);
/// Draws the second disc (Fig. 6): the pivot as seen from e, with the names of the ends of the
/// sector of e. Requires a reciprocal.
void drawReciprocalDial(Painter& painter, const DialPicture& picture, const Rect& room);

}  // namespace se::view
