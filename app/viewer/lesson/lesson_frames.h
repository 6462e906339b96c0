/// The steps of a lesson as inputs and looks of the viewer.
#pragma once

#include "document/context.h"
#include "export/order.h"
#include "layers/layer.h"
#include "run/model.h"
#include "run/selection.h"
#include "teach/lesson_setting.h"

namespace se::view {

/// The lesson of an id or a file; null if `source` names none. Fails with the first fault of it.
Result<std::shared_ptr<const LessonFile>> lessonOfSource(const std::string& source);

/// "name:14: at: ": where a fault of a step is. `key`: of its block; empty: the heading.
std::string stepPlace(const LessonFile& file, std::size_t step, std::string_view key);

/// The input of a step, from 0, with its rules. Fails with a sentence.
Result<RunSpec> inputOfStep(const LessonFile& file, std::size_t step);

/// `layers` with those that the step pins and hides.
LayerModes layersOfStep(LayerModes layers, const teach::LessonStep& step);

/// `layers` of a window that shows the step, without what the step pins and hides there.
LayerModes layersWithout(LayerModes layers, const teach::LessonStep& step);

/// The points that a step selects; nothing if it selects none.
Selection selectionOfStep(const teach::LessonStep& step,
                          const std::vector<teach::NamedPoint>& names);

/// Camera of a step: its own, or one that frames the decision or all, from the direction of its
/// view. Fails if its own is no position.
Status aimAtStep(CommandContext& context, const teach::LessonStep& step,
                 const teach::StepSetting& setting);

}  // namespace se::view
