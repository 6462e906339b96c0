/// Drawing of a row in the panel Steps.
#pragma once

#include <imgui.h>

#include <string>

#include "layout/step_columns.h"
#include "panels/panel.h"
#include "rows/step_tree.h"

namespace se::view {

/// The columns of all rows from `left`, `room` wide. O(components).
StepColumns stepColumns(const PanelContext& context, float left, float room);

/// Draws a row that begins at `at`.
void drawStepRow(const PanelContext& context, const StepRow& row, ImVec2 at,
                 const StepColumns& columns);
std::string stepRowTooltip(const PanelContext& context, const StepRow& row);
/// Width from the left in which a click opens or folds the row.
float stepArrowEnd(const PanelContext& context, const StepRow& row);

}  // namespace se::view
