/// Checks of a lesson that need no run: each value is one that its key can have.
#pragma once

#include <string_view>
#include <vector>

#include "lesson.h"

namespace se::teach {

/// True for an address, a share such as "50%", and "0", the start of the run.
bool isPlaceText(std::string_view text);

/// Faults of the values of a lesson.
std::vector<LessonFault> syntaxFaults(const Lesson& lesson);

}  // namespace se::teach
