/// Signs of the tasks in the rail.
#pragma once

#include <imgui.h>

#include "panel_state/column.h"

namespace se::view {

/// Draws the sign of a task around `center`, `size` pixels high.
void drawRailIcon(ImDrawList* list, Task task, ImVec2 center, float size, ImU32 color);

}  // namespace se::view
