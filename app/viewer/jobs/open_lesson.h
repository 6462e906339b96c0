/// Opening of a lesson: it is read, each of its steps is run, and the answers are found.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "run/model.h"
#include "spiraling_edge/base/result.h"
#include "teach/lesson.h"
#include "teach/lesson_runs.h"

namespace se::view {

/// Source of an embedded lesson: "lesson:tour".
inline constexpr std::string_view kLessonPrefix = "lesson:";
inline std::string embeddedLessonSource(std::string_view id) {
    return std::string(kLessonPrefix) + std::string(id);
}
/// True for "lesson:ID", "practice:SEED", and files and packed files that end with ".lesson.md".
bool isLesson(std::string_view source);
/// True if it is a file.
bool isLessonFile(std::string_view source);

/// A lesson of the program, as it is listed.
struct LessonEntry {
    std::string source;  ///< "lesson:tour"
    std::string title;
    std::string text;  ///< The first paragraph, without marks.
    double minutes = 0.0;
    std::string input;  ///< "scene:torus"
    std::string at;     ///< Position of the first step that has one.
};
/// All lessons of the program, in teaching order.
const std::vector<LessonEntry>& lessonEntries();

/// A lesson without faults.
struct OpenedLesson {
    std::string source;            ///< "lesson:ID", "practice:SEED", a path, or a packed file.
    std::filesystem::path folder;  ///< Its inputs are relative to it.
    teach::Lesson lesson;
    /// By step, the answer to its question; nothing for a step without one.
    std::vector<std::optional<teach::RightAnswer>> right;
};

using SharedLesson = std::shared_ptr<const OpenedLesson>;

/// The first input of a lesson that is a file; empty if it has none.
std::string fileOfLesson(const teach::Lesson& lesson);

/// Reads a lesson and runs its steps. Fails with its first fault, with file and line, or once
/// `progress` returns false.
Result<SharedLesson> openLesson(const std::string& source, const Progress& progress);
/// The lesson of an id or a source, opened; null if `source` names none. Fails as openLesson().
Result<SharedLesson> lessonOfSource(const std::string& source);

/// The input and options of a step of a lesson in `folder`. Fails if a rule or a what-if is not
/// known.
Result<RunSpec> inputOfStep(const teach::StepSetting& setting, const std::filesystem::path& folder);

}  // namespace se::view
