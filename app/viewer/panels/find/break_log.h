/// The hits of log-only breakpoints, as a list that leads to them.
#pragma once

#include "panels/panel.h"

namespace se::view {

/// Nothing where no breakpoint is one.
void drawBreakLog(const PanelContext& context);

}  // namespace se::view
