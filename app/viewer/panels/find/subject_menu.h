/// The menu of a point, an edge or a triangle, in the view and in lists: what can be asked of it.
/// Whoever has such a thing calls `ui().subjectMenu.open(what)` on a right click.
#pragma once

#include "panels/panel.h"

namespace se::view {

void drawSubjectMenu(const PanelContext& context);

}  // namespace se::view
