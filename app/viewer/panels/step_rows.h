/// How a row of the panel Steps looks.
#pragma once

#include <imgui.h>

#include <string>

#include "panel.h"
#include "steps/step_tree.h"

namespace se::view {

/// The columns at the right end of a row; x of their right edges, 0 for one that is left out.
struct StepColumns {
    float triangles = 0.0F;
    float tests = 0.0F;
    float refused = 0.0F;
};
StepColumns stepColumns(const PanelContext& context, float left, float room);

/// Draws a row that begins at `at` and is `room` wide.
void drawStepRow(const PanelContext& context, const StepRow& row, ImVec2 at, float room);
std::string stepRowTooltip(const PanelContext& context, const StepRow& row);
/// How far a click opens or folds the row, from its left.
float stepArrowEnd(const PanelContext& context, const StepRow& row);
/// "1 pivot", "12 pivots".
std::string withS(std::size_t number, const char* word);

}  // namespace se::view
