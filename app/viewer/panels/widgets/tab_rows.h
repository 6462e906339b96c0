/// Tabs in as many rows as their names need; if there is no room for that, the rest of them is
/// in a list, opened by a button at their end.
#pragma once

#include <span>

#include "panels/panel.h"

namespace se::view {

/// The tabs of a column, in order.
using ColumnTabs = std::span<const SidePanel* const>;

/// Draws the names; the panel whose tab is open.
const SidePanel* drawTabRows(const PanelContext& context, ColumnTabs tabs);

}  // namespace se::view
