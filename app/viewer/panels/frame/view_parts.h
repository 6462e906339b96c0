/// What lies over the picture of the scene. Each says where it is, so that the next keeps off it.
#pragma once

#include <optional>
#include <span>

#include "layout/edge_arrow.h"
#include "layout/labels.h"
#include "panels/panel.h"

namespace se::view {

/// The way to the pivot, where it is outside of the view.
struct PivotArrow {
    EdgeArrow arrow;
    Rect rect;  ///< In pixels of the window.
    bool hovered = false;
};

/// The scene with what lies over it, in a window of that name.
void drawScene(const PanelContext& context, const char* window);

/// Takes clicks: they frame the pivot. To be called before the scene takes those that are left.
std::optional<PivotArrow> offerPivotArrow(const PanelContext& context);
void drawPivotArrow(const PanelContext& context, const PivotArrow& arrow);

/// What the marks mean, in a corner where it covers nothing of `taken` and leaves the pivot's
/// surroundings in sight; nothing if there is none.
std::optional<Rect> drawLegend(const PanelContext& context, std::span<const Rect> taken);

/// What the colors of the mesh mean, if they mean something.
std::optional<Rect> drawColorBar(const PanelContext& context, std::span<const Rect> taken);

/// Ctrl with a left drag draws a line around points; true while it does, and as it ends. To be
/// called right after the scene's own item.
bool handleLasso(const PanelContext& context);
void drawLasso(const PanelContext& context);

/// Where there is room for them beside `taken`.
void drawLabels(const PanelContext& context, std::span<const Rect> taken);

}  // namespace se::view
