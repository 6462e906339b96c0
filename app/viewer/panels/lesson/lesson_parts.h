/// Parts of the panel Lesson.
#pragma once

#include "panels/panel.h"

namespace se::view {

/// The question of the step: what to do, the answer given, and the right one once it is shown.
/// Requires a step with a question.
void drawQuestion(const PanelContext& context);

}  // namespace se::view
