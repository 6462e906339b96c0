/// Runs of a lesson: each input is opened once under each of its settings, and its cursor goes to
/// any position.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "lesson.h"
#include "question.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/run/run_cursor.h"

namespace se::teach {

/// The points of scene:ID. Fails if there is no such scene.
Result<PointFile> buildScene(const std::string& source);

/// The points of an input: its own name, or for a lesson the input of that lesson. Fails if such
/// lessons form a cycle, or if one of them is faulty.
Result<std::string> pointsSource(std::string source);

/// The input of a lesson in the folder `folder` as a path for the program, or scene:ID.
std::string lessonSource(const std::string& input, const std::filesystem::path& folder);

/// Points and params of one run.
struct PreparedRun {
    SharedPoints points;
    Params params;
};

/// Prepares the points of `file`, which was read from `source`, for a run by `spec`. Fails as
/// prepare(), if there is no such set or rule, or if a what-if has no effect.
Result<PreparedRun> prepareRun(const PointFile& file, const std::string& source, RunSpec spec);

/// Moves `cursor` to an address, a share such as "50%", or "0", the start. Fails with a sentence
/// such as "pivot 9 has 4 decisions of sphere, not 5"; then the cursor stays.
Status goToPlace(RunCursor& cursor, std::string_view place);

/// The runs of one lesson.
class LessonRuns {
  public:
    /// `folder`: that of the lesson's file; `limit`, `unpack`: of each of its inputs.
    explicit LessonRuns(std::filesystem::path folder, const ByteLimit& limit = {},
                        Unpack unpack = nullptr);

    /// The cursor of the run of a setting; valid as long as this object. Fails as prepareRun().
    Result<RunCursor*> cursorOf(const StepSetting& setting);
    /// As cursorOf(), with other settings for the same input.
    Result<RunCursor*> cursorOf(const StepSetting& setting, const RunSpec& spec);

  private:
    /// The points of pointsSource().
    Result<PointFile> pointsOf(const std::string& source) const;

    std::filesystem::path folder_;
    ByteLimit limit_;
    Unpack unpack_;
    std::map<std::string, PointFile> files_;
    std::map<std::string, std::unique_ptr<RunCursor>> cursors_;
};

/// The part of the run between a question and its answer. Fails with a sentence if a position is
/// not in the run, or the second not after the first.
Result<RunRange> rangeOf(RunCursor& cursor, const StepSetting& setting, const Question& question);

/// The right answer of a question, with its words.
struct RightAnswer {
    Answer answer;
    std::string text;          ///< "q, 31"
    std::string reason;        ///< The sentence of the decision at `why`; empty without one.
    std::vector<Event> shown;  ///< The decisions from the question to the answer, in order.
};

/// The right answer to the question of step number `step`, from 0, found by running it. Requires a
/// step with a question. Fails as LessonRuns::cursorOf() and rangeOf().
Result<RightAnswer> rightAnswer(const Lesson& lesson, std::size_t step, LessonRuns& runs);

}  // namespace se::teach
