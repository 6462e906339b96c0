/// Overlays of the scene. Each reports its rectangle, so that the next one avoids it.
#pragma once

#include <optional>
#include <span>

#include "layout/edge_arrow.h"
#include "layout/labels.h"
#include "panels/panel.h"

namespace se::view {

/// The arrow to the pivot, if the pivot is outside of the view.
struct PivotArrow {
    EdgeArrow arrow;
    Rect rect;  ///< In pixels of the window.
    bool hovered = false;
};

/// The scene with its overlays, in a window of that name.
void drawScene(const PanelContext& context, const char* window);

/// Takes clicks, which frame the pivot. To be called before the scene takes the remaining ones.
std::optional<PivotArrow> offerPivotArrow(const PanelContext& context);
void drawPivotArrow(const PanelContext& context, const PivotArrow& arrow);

/// Legend of the marks, in a corner where it covers nothing of `taken` and leaves the pivot's
/// surroundings visible; nothing if there is none.
std::optional<Rect> drawLegend(const PanelContext& context, std::span<const Rect> taken);

/// Legend of the mesh colors, if they have a meaning.
std::optional<Rect> drawColorBar(const PanelContext& context, std::span<const Rect> taken);

/// Ctrl with a left drag draws a lasso around points; true while it does, and as it ends. To be
/// called right after the scene's own item.
bool handleLasso(const PanelContext& context);
void drawLasso(const PanelContext& context);

/// Labels, where there is room for them beside `taken`.
void drawLabels(const PanelContext& context, std::span<const Rect> taken);

}  // namespace se::view
