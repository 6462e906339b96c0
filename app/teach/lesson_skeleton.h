/// A lesson to begin with: the first interesting decisions of an input, as a file to be edited.
#pragma once

#include <string>

#include "lesson_runs.h"

namespace se::teach {

/// The text of a lesson on `input`, as it shall stand there. It passes checkLesson(). Fails if the
/// run has no decision to show.
Result<std::string> lessonSkeleton(const std::string& input, const PreparedRun& run);

}  // namespace se::teach
