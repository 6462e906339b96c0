/// Pins over the finished mesh: places with faults that are too small on the screen to be seen, as
/// clusters with the number of their places. Plain arithmetic, in pixels.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "panel_rects.h"

namespace se::view {

/// Radius, in em, from which on a place is seen at its size and needs no pin.
inline constexpr float kSeenFrom = 0.9F;

/// A place on the screen.
struct PinPlace {
    glm::vec2 at{0.0F};
    float radius = 0.0F;
};

struct Pin {
    std::size_t place = 0;  ///< The most severe place of the cluster, in the list of places.
    std::size_t count = 0;  ///< Number of places of the cluster.
    glm::vec2 tip{0.0F};    ///< That of `place`.
    float strength = 1.0F;  ///< In (0, 1]: less where its places can nearly be seen.
};

/// The pins of those of `places` (the most severe first) that lie within `area` and have a radius
/// below kSeenFrom. Each pin is at the most severe place that no pin stands for yet, and stands for
/// all places near it, so that heads do not overlap. Equal input gives equal pins. About O(places).
std::vector<Pin> pinsOf(std::span<const PinPlace> places, const Rect& area, float em);

/// The head of a pin with a text of that width (0: no text): above its tip, or below it at the
/// upper edge of the area; it never covers the tip.
Rect headOf(const Pin& pin, float textWidth, const Rect& area, float em);

}  // namespace se::view
