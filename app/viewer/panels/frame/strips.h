/// Shared parts of the three strips in the drawer.
#pragma once

#include "panels/panel.h"

namespace se::view {

/// Area of the bars of a strip: right of its name, in the middle of its height.
Rect barsOf(const PanelContext& context, const Rect& strip, float height, float top);
/// The name of a strip, in the margin to the left of its bars.
void stripName(const PanelContext& context, const char* name, const Rect& bars);
void drawRunStrip(const PanelContext& context, const Rect& area);
void drawPivotStrip(const PanelContext& context, const Rect& area);
void drawStageStrip(const PanelContext& context, const Rect& area);

}  // namespace se::view
