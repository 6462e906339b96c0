/// Keys of the blocks of a lesson, and the values that they can have: one table per block. A new
/// key is a member in lesson.h and a row here.
#pragma once

#include <string_view>
#include <vector>

#include "lesson.h"

namespace se::teach {

/// A fenced block of a lesson.
struct LessonBlock {
    std::string_view toml;
    std::size_t line = 0;  ///< Of its fence.
};

// Each reads a block into its target and appends what is wrong to `faults`.
void readLessonBlock(const LessonBlock& block, Lesson& lesson, std::vector<LessonFault>& faults);
void readStepBlock(const LessonBlock& block, LessonStep& step, std::vector<LessonFault>& faults);
void readAskBlock(const LessonBlock& block, Question& question, std::vector<LessonFault>& faults);

/// Faults of the values of a lesson that need no run: each value is one that its key can have.
std::vector<LessonFault> syntaxFaults(const Lesson& lesson);

/// The names of all keys, in the order of the tables.
std::vector<std::string_view> lessonKeys();

}  // namespace se::teach
