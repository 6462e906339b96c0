/// A lesson as a page for the terminal.
#pragma once

#include <string>

#include "teach/lesson_runs.h"

namespace se::cli {

/// Steps with minutes, text and questions.
std::string lessonPage(const teach::Lesson& lesson);

/// The same with the answers. Fails if one of them cannot be found.
Result<std::string> lessonPageWithAnswers(const teach::Lesson& lesson, teach::LessonRuns& runs);

}  // namespace se::cli
