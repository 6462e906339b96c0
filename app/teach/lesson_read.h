/// Reader of lessons: CommonMark in which `##` begins a step, and blocks fenced as `se lesson`, `se
/// step` and `se ask` hold TOML (docs/lessons.md).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lesson.h"
#include "spiraling_edge/base/result.h"

namespace se::teach {

/// Longest file that is read, in bytes.
inline constexpr std::size_t kLongestLesson = 1'000'000;

/// Maximum number of steps.
inline constexpr std::size_t kMaxLessonSteps = 200;

/// A lesson and what is wrong with it; without faults it is complete and each key has a valid
/// value. Addresses, points and answers are not looked up yet (lesson_check.h).
struct LessonReading {
    Lesson lesson;
    std::vector<LessonFault> faults;  ///< In the order of the file.
    bool ok() const { return faults.empty(); }
};

/// Reads a lesson; `name` is that of its file, for messages. Never fails otherwise than by faults.
LessonReading readLesson(std::string_view text, const std::string& name);

/// Reads the file of a lesson. Fails if it cannot be read as a file, or is over kLongestLesson. An
/// image or input that is a device, a pipe, or a link out of the folder of the lesson is a fault.
Result<LessonReading> readLessonFile(const std::filesystem::path& path);

}  // namespace se::teach
