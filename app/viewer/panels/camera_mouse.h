/// Turning, panning and zooming with the mouse, wherever there is a view.
#pragma once

#include <optional>
#include <span>

#include "panel.h"

namespace se::view {

/// A press that moves by more than this share of the window's height is a drag.
inline constexpr float kClickShare = 0.01F;
/// By what the mouse does on the item drawn last, which must fill the view.
void moveCameraByMouse(const PanelContext& context);
/// A right click on the item drawn last that was no drag, when it ends.
bool rightClicked();
/// The three axes, in the lower left corner of the view, or where else there is room beside
/// `taken`: there, if anywhere.
std::optional<Rect> drawAxes(const PanelContext& context, std::span<const Rect> taken);

}  // namespace se::view
