/// The hits of log-only breakpoints, as a list of links.
#pragma once

#include "panels/panel.h"

namespace se::view {

/// Draws nothing if no breakpoint is log-only.
void drawBreakLog(const PanelContext& context);

}  // namespace se::view
