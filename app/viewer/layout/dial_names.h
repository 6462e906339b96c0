/// Names around the rim of the dial: side by side where two points stand at nearly the same angle.
/// Plain arithmetic, in pixels.
#pragma once

#include <vector>

#include "dial.h"

namespace se::view {

struct NameRoom {
    Rect area;                      ///< All names lie within it.
    std::span<const Rect> taken{};  ///< By other things.
    float gap = 5.0F;               ///< From the rim to a name.
    float line = 14.0F;             ///< From the first row of names outward to the second.
};

struct PlacedName {
    std::size_t name = 0;  ///< Its place in the list of names.
    Rect rect;
    /// From the rim to the name, where that does not stand right beside its point.
    bool leader = false;
};

/// The earlier in the list, the nearer to its place; a name without a place near by is left out.
std::vector<PlacedName> placeNames(const DialPlace& disc, const NameRoom& room,
                                   std::span<const DialName> names);

}  // namespace se::view
