/// Names around the rim of the dial: side by side where two points are at nearly the same angle.
/// Plain arithmetic, in pixels.
#pragma once

#include <vector>

#include "dial_fit.h"

namespace se::view {

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
std::vector<PlacedName> placeNames(const DialPlace& disc, const NameRoom& room,
                                   std::span<const DialName> names);

}  // namespace se::view
