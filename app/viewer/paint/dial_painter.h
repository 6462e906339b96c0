/// The dial as a drawing: one disc of a tangent plane, and the smaller one of a ring point.
#pragma once

#include <cmath>
#include <glm/trigonometric.hpp>
#include <span>
#include <vector>

#include "layout/panel_rects.h"
#include "painter.h"
#include "rows/pivot_dial.h"

namespace se::view {

// The dial's disc and the names around its rim: the largest disc that leaves room for them, and
// names side by side where two points are at nearly the same angle. Plain arithmetic, in pixels.

/// A name at the rim of the disc, outside of it.
struct DialName {
    double degrees = 0.0;  ///< Counterclockwise, 0 to the right.
    glm::vec2 extent{0.0F};
};

/// The disc: angle 0 to the right, counterclockwise.
struct DialCircle {
    glm::vec2 center{0.0F};
    float radius = 0.0F;

    /// The place at an angle, `reach` radii from the center.
    glm::vec2 at(double degrees, float reach = 1.0F) const {
        const float a = glm::radians(static_cast<float>(degrees));
        return center + reach * radius * glm::vec2(std::cos(a), -std::sin(a));
    }
};

/// Position of the near corner of a name, for a rim point: at `gap` from it, away from the center.
glm::vec2 nameCorner(glm::vec2 rim, const DialName& name, float gap);
/// `margin` is left free around the disc in any case.
DialCircle fitDial(const Rect& room, std::span<const DialName> names, float gap, float margin);

struct NameRoom {
    Rect area;                      ///< All names lie within it.
    std::span<const Rect> taken{};  ///< Areas covered by other overlays.
    float gap = 5.0F;               ///< From the rim to a name.
    float line = 14.0F;             ///< From the first row of names outward to the second.
};

struct PlacedName {
    std::size_t name = 0;  ///< Its position in the list of names.
    Rect rect;
    /// From the rim to the name, if the name is not right beside its point.
    bool leader = false;
};

/// Earlier names in the list get closer positions; a name without a free position nearby is left
/// out.
std::vector<PlacedName> placeNames(const DialCircle& disc, const NameRoom& room,
                                   std::span<const DialName> names);

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
/// Draws a dial on a panel, with a heading and its caption; nothing if it is empty. A second disc
/// is left out.
void drawDialFigure(Painter& painter, const DialPicture& picture, const Rect& area);
/// The place of a neighbor on the disc.
glm::vec2 placeOf(const DialTick& tick, const DialCircle& disc);
/// Draws the second disc (Fig. 6): the pivot as seen from e, with the names of the ends of the
/// sector of e. Requires a reciprocal.
void drawReciprocalDial(Painter& painter, const DialPicture& picture, const Rect& room);

}  // namespace se::view
