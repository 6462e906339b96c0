/// Kinds of questions: how an answer is read, written and graded; and the answers that a run gives:
/// refused, kept, next, fan, verdict and counts. A new kind, or answer, is a row with its
/// functions.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson.h"
#include "play_moves.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/run/run_cursor.h"

namespace se::teach {

/// An answer, given or right: the member of its kind.
struct Answer {
    std::vector<Index> points = {};          ///< Of `points`, in any order; of `point`, one.
    std::optional<std::size_t> choice = {};  ///< From 0, A.
    std::optional<double> number = {};
    std::vector<PlayMove> moves = {};  ///< Of `play`, in order.
    friend bool operator==(const Answer&, const Answer&) = default;
};

/// The result of comparing an answer with the right one.
struct Grade {
    bool right = false;
    double score = 0.0;  ///< From 0 to 1; of `points`, the share of the two sets in common.
    std::vector<Index>
        wrong;  ///< Points that do not belong to the answer; of the first wrong move.
    std::vector<Index> missing;  ///< Points of the answer that were not given.
};

/// A question with the names of its points.
struct QuestionContext {
    const Question& question;
    const std::vector<PointName>& names;
};

/// One kind of question.
struct QuestionKind {
    std::string_view name;     ///< "points"
    std::string_view task;     ///< "Mark a set of points."
    std::string_view answers;  ///< What `answer` can be, for messages.
    /// Reads an answer as it is typed: words of points, a number, a letter or the text of an
    /// option.
    Result<Answer> (*read)(const std::vector<std::string>& words, const QuestionContext& context);
    Grade (*grade)(const Answer& given, const Answer& right, const Question& question);
    /// "q, 31"; "B: It lies inside."; "118"
    std::string (*text)(const Answer& answer, const QuestionContext& context);
};
std::span<const QuestionKind> questionKinds();
/// Null if there is none of that name.
const QuestionKind* findQuestionKind(std::string_view name);

/// Grades an answer. Requires a question of a known kind.
Grade gradeAnswer(const Question& question, const Answer& given, const Answer& right);

/// The option, from 0, that is the right answer; nothing if there is none. For a room, which
/// chooses among options whatever the kind of the question.
std::optional<std::size_t> rightOption(const QuestionContext& context, const Answer& right);

/// The part of a run between the position of a question and that of its answer.
struct RunRange {
    DecisionState before;
    DecisionState after;
    std::vector<Event> events;  ///< After the first position, up to the second.
    std::size_t trianglesBefore = 0, trianglesAfter = 0;
};

/// True if `words` are an outcome, or its first words: "splits" of "splits into 19 and 13".
bool isOutcome(std::string_view words, std::string_view outcome);
/// True if some decision can have that outcome.
bool isPossibleOutcome(std::string_view words);

/// One row of the table of answers that a run gives.
struct RunAnswer {
    std::string_view name;  ///< "refused"
    std::string_view kind;  ///< The kind of question that it answers.
    /// Fails if the run has no such answer there, or if no option, or more than one, is it.
    Result<Answer> (*find)(const RunRange& range, const QuestionContext& context);
};
std::span<const RunAnswer> runAnswers();
/// Null if there is none of that name.
const RunAnswer* findRunAnswer(std::string_view name);

/// "A", "B", ...
std::string optionLetter(std::size_t option);

}  // namespace se::teach
