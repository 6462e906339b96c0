/// Orbit, pan and zoom with the mouse, in any view.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>

#include "panels/panel.h"

namespace se::view {

/// Moves the camera by the mouse on the item drawn last, which must fill the view.
void moveCameraByMouse(const PanelContext& context);
/// A press of the button on the item drawn last that was no drag, when it ends. To be called after
/// moveCameraByMouse().
bool isClick(const PanelContext& context, ImGuiMouseButton button);
/// The three axes, in the lower left corner of the view, or in another place with room beside
/// `taken`; omitted if there is none.
std::optional<Rect> drawAxes(const PanelContext& context, std::span<const Rect> taken);

}  // namespace se::view
