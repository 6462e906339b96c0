/// Turning, panning and zooming with the mouse, wherever there is a view.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>

#include "panels/panel.h"

namespace se::view {

/// By what the mouse does on the item drawn last, which must fill the view.
void moveCameraByMouse(const PanelContext& context);
/// A press of the button on the item drawn last that was no drag, when it ends. Goes after
/// moveCameraByMouse().
bool isClick(const PanelContext& context, ImGuiMouseButton button);
/// The three axes, in the lower left corner of the view, or where else there is room beside
/// `taken`: there, if anywhere.
std::optional<Rect> drawAxes(const PanelContext& context, std::span<const Rect> taken);

}  // namespace se::view
