/// Tabs in as many rows as their names need: where there is room for that, nothing is out of sight.
#pragma once

#include <span>

#include "panel.h"

namespace se::view {

/// The tabs of a column, in order.
using ColumnTabs = std::span<const SidePanel* const>;

/// False if the rows would take too much of what is left of the window.
bool tabRowsFit(const PanelContext& context, ColumnTabs tabs);
/// Draws the names; the panel whose tab is open.
const SidePanel* drawTabRows(const PanelContext& context, ColumnTabs tabs);

}  // namespace se::view
