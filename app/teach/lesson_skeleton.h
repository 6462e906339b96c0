/// A lesson to begin with: the first interesting decisions of an input, as a file to be edited.
#pragma once

#include <string>
#include <vector>

#include "lesson_runs.h"

namespace se::teach {

/// The text of a lesson on `input`, as it shall stand there. It passes checkLesson(). Fails if the
/// run has no decision to show.
Result<std::string> lessonSkeleton(const std::string& input, const PreparedRun& run);

/// A position with a note, which becomes a step.
struct NotedPosition {
    std::string address;
    std::string note;    ///< The heading; empty: the address.
    std::string camera;  ///< JSON as of LessonStep::camera; empty: none.
};

/// The text of a lesson with a step for each position, in their order. Requires a position.
std::string lessonOfNotes(const std::string& input, const RunSpec& spec, const std::string& intro,
                          const std::vector<NotedPosition>& notes);

}  // namespace se::teach
