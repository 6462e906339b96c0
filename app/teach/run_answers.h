/// Answers that a run gives to questions: refused, kept, next, fan, verdict and counts. A new
/// answer is a function and a row.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "play_moves.h"
#include "spiraling_edge/run/run_cursor.h"

namespace se::teach {

/// The part of a run between the position of a question and that of its answer.
struct RunRange {
    DecisionState before;
    DecisionState after;
    std::vector<Event> events;  ///< After the first position, up to the second.
    std::size_t trianglesBefore = 0, trianglesAfter = 0;
};

/// The answer of a run: one of the members, by the kind of the question.
struct RunValue {
    std::vector<Index> points = {};  ///< Ascending; of the fan, in its order.
    std::optional<double> number = {};
    std::vector<PlayMove> moves = {};  ///< Of the pivot, if the range begins with it.
    std::string outcome = {};          ///< Words of outcomeText() in why/figure_check.h.
};

/// True if `words` are an outcome, or its first words: "splits" of "splits into 19 and 13".
bool isOutcome(std::string_view words, std::string_view outcome);
/// True if some decision can have that outcome.
bool isPossibleOutcome(std::string_view words);

/// One row of the table of answers.
struct RunAnswer {
    std::string_view name;  ///< "refused"
    std::string_view kind;  ///< The kind of question that it answers.
    std::string_view help;
    RunValue (*find)(const RunRange&);
};
std::span<const RunAnswer> runAnswers();
/// Null if there is none of that name.
const RunAnswer* findRunAnswer(std::string_view name);

}  // namespace se::teach
