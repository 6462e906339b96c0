/// Context menu of a point, an edge or a triangle, in the view and in lists. Opened by
/// `state<SubjectMenu>().open(what)` on a right click.
#pragma once

#include "panels/panel.h"

namespace se::view {

void drawSubjectMenu(const PanelContext& context);

}  // namespace se::view
