/// The three axes in a corner of a view; a click on an end looks from there.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "panels/panel.h"

namespace se::view {

/// An end of an axis.
struct AxisEnd {
    std::size_t axis = 0;  ///< 0 to 2: x, y, z.
    bool positive = true;
    glm::vec2 at{0.0F};  ///< Middle, in pixels of the window.
    float near = 0.0F;   ///< From -1, away from the eye, to 1, toward it.
    bool hovered = false;
};

struct AxisGizmo {
    Rect plate;                   ///< In pixels of the window.
    std::array<AxisEnd, 6> ends;  ///< The nearest to the eye first.
};

/// Takes clicks on the ends, in the lower left corner of the view, or in another one beside
/// `taken`; nothing if there is no room. To be called before the scene takes the remaining clicks.
std::optional<AxisGizmo> offerAxes(const PanelContext& context, std::span<const Rect> taken);
void drawAxes(const PanelContext& context, const AxisGizmo& gizmo);

}  // namespace se::view
