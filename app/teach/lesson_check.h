/// Check of a lesson against its runs: every position, outcome, name and answer.
#pragma once

#include <vector>

#include "lesson_runs.h"

namespace se::teach {

/// Faults of a lesson that lesson_read.h found complete; empty if nothing is. Runs each
/// step. Stops at the first fault of a step, and goes on with the next step.
std::vector<LessonFault> checkLesson(const Lesson& lesson, LessonRuns& runs);

/// True if some fault is of a file that cannot be used.
bool isMalformed(const std::vector<LessonFault>& faults);

}  // namespace se::teach
