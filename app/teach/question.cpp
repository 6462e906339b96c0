#include "question.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>

#include "find_named.h"
#include "lesson_setting.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"

namespace se::teach {
namespace {

using Words = std::vector<std::string>;

std::vector<Index> sortedSet(std::vector<Index> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

// ---- points, point ----

Result<Answer> readPoints(const Words& words, const QuestionContext& context) {
    Answer answer;
    for (const std::string& word : words) {
        const Index point = pointOf(word, context.names);
        if (point == kNone) return Error{excerpt(word) + ": no name and no number of a point"};
        answer.points.push_back(point);
    }
    answer.points = sortedSet(std::move(answer.points));
    return answer;
}

Result<Answer> readPoint(const Words& words, const QuestionContext& context) {
    if (words.size() != 1) return Error{"expected one point"};
    return readPoints(words, context);
}

Result<Answer> pointsOfRun(const RunValue& value, const QuestionContext&) {
    return Answer{.points = sortedSet(value.points)};
}

Result<Answer> pointOfRun(const RunValue& value, const QuestionContext& context) {
    if (value.points.size() != 1) return Error{"the run names no point there"};
    return pointsOfRun(value, context);
}

/// The grade of an answer that has no parts.
Grade wholeGrade(bool right) { return {right, right ? 1.0 : 0.0, {}, {}}; }

Grade gradePoints(const Answer& given, const Answer& right, const Question&) {
    const std::vector<Index> a = sortedSet(given.points);
    const std::vector<Index> b = sortedSet(right.points);
    Grade grade;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(grade.wrong));
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(grade.missing));
    grade.right = a == b;
    const std::size_t common = a.size() - grade.wrong.size();
    const std::size_t all = b.size() + grade.wrong.size();
    grade.score = all == 0 ? 1.0 : static_cast<double>(common) / static_cast<double>(all);
    return grade;
}

Grade gradePoint(const Answer& given, const Answer& right, const Question& question) {
    Grade grade = gradePoints(given, right, question);
    grade.score = grade.right ? 1.0 : 0.0;
    return grade;
}

std::string textOfPoints(const Answer& answer, const QuestionContext& context) {
    return pointsText(answer.points, context.names);
}

// ---- choice ----

Result<Answer> readChoice(const Words& words, const QuestionContext& context) {
    const Words& options = context.question.options;
    Answer answer;
    if (words.size() != 1) return Error{"expected one of the options"};
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (words.front() == optionLetter(i) || words.front() == options[i]) answer.choice = i;
    }
    if (!answer.choice)
        return Error{excerpt(words.front()) + ": expected the letter of one of the options"};
    return answer;
}

Result<Answer> choiceOfRun(const RunValue& value, const QuestionContext& context) {
    const Words& verdicts =
        context.question.verdicts.empty() ? context.question.options : context.question.verdicts;
    const auto isThat = [&](const std::string& words) { return isOutcome(words, value.outcome); };
    if (std::count_if(verdicts.begin(), verdicts.end(), isThat) != 1)
        return Error{"the outcome is " + inQuotes(value.outcome) +
                     ", which is not one of the options"};
    const auto found = std::find_if(verdicts.begin(), verdicts.end(), isThat);
    return Answer{.choice = static_cast<std::size_t>(found - verdicts.begin())};
}

Grade gradeChoice(const Answer& given, const Answer& right, const Question&) {
    return wholeGrade(given.choice.has_value() && given.choice == right.choice);
}

std::string textOfChoice(const Answer& answer, const QuestionContext& context) {
    if (!answer.choice || *answer.choice >= context.question.options.size()) return "none";
    return optionLetter(*answer.choice) + ": " + context.question.options[*answer.choice];
}

// ---- number ----

Result<Answer> readNumberAnswer(const Words& words, const QuestionContext&) {
    if (words.size() != 1) return Error{"expected a number"};
    Answer answer;
    answer.number = numberIn<double>(words.front());
    if (!answer.number || !std::isfinite(*answer.number))
        return Error{excerpt(words.front()) + ": expected a number"};
    return answer;
}

Result<Answer> numberOfRun(const RunValue& value, const QuestionContext&) {
    if (!value.number) return Error{"the run has no number there"};
    return Answer{.number = value.number};
}

Grade gradeNumber(const Answer& given, const Answer& right, const Question& question) {
    return wholeGrade(given.number && right.number &&
                      std::abs(*given.number - *right.number) <= question.within);
}

std::string textOfNumber(const Answer& answer, const QuestionContext&) {
    std::string text;
    if (answer.number) appendPlainNumber(text, *answer.number);
    return text.empty() ? "none" : text;
}

// ---- play ----

Result<Answer> readPlay(const Words& words, const QuestionContext& context) {
    Answer answer;
    for (const std::string& word : words) {
        Result<PlayMove> move = moveFromText(word, context.names);
        if (!move) return move.error();
        answer.moves.push_back(std::move(move.value()));
    }
    return answer;
}

Result<Answer> playOfRun(const RunValue& value, const QuestionContext&) {
    if (value.moves.empty()) {
        return Error{
            "no pivot is played there; `at` has to be where an interior pivot begins, "
            "such as 9.pivot.1"};
    }
    return Answer{.moves = value.moves};
}

Grade gradePlay(const Answer& given, const Answer& right, const Question&) {
    const std::size_t alike = movesAlike(given.moves, right.moves);
    Grade grade;
    grade.right = given.moves == right.moves;
    grade.score = right.moves.empty()
                      ? 0.0
                      : static_cast<double>(alike) / static_cast<double>(right.moves.size());
    if (grade.right) return grade;
    // The points of a fan that belong to it are not wrong.
    const std::vector<Index> none;
    const auto& wrong = alike < given.moves.size() ? given.moves[alike].points : none;
    const auto& wanted = alike < right.moves.size() ? right.moves[alike].points : none;
    const bool isFan = alike < right.moves.size() && right.moves[alike].kind == MoveKind::Fan;
    for (const Index point : wrong) {
        const bool belongs = std::find(wanted.begin(), wanted.end(), point) != wanted.end();
        if (!(isFan && belongs)) grade.wrong.push_back(point);
    }
    return grade;
}

std::string textOfPlay(const Answer& answer, const QuestionContext& context) {
    std::string text;
    for (const PlayMove& each : answer.moves)
        text += (text.empty() ? "" : "; ") + moveText(each, context.names);
    return text.empty() ? "none" : text;
}

constexpr std::array kQuestionKinds{
    QuestionKind{"points", "Mark a set of points.",
                 "a list of points, or \"refused\", \"kept\" or \"fan\"", readPoints, pointsOfRun,
                 gradePoints, textOfPoints},
    QuestionKind{"point", "Mark one point.", "a point, or \"next\", \"start\" or \"end\"",
                 readPoint, pointOfRun, gradePoint, textOfPoints},
    QuestionKind{"choice", "Choose one of A to D.", "a letter, or \"verdict\"", readChoice,
                 choiceOfRun, gradeChoice, textOfChoice},
    QuestionKind{"number", "Give a number.", "a number, or \"count:triangles\" and the like",
                 readNumberAnswer, numberOfRun, gradeNumber, textOfNumber},
    QuestionKind{"play", "Play the whole pivot: start, end, keep, remove, fan, next.",
                 "a list of moves such as \"keep q\", or \"moves\"", readPlay, playOfRun, gradePlay,
                 textOfPlay},
};

}  // namespace

std::span<const QuestionKind> questionKinds() { return kQuestionKinds; }

const QuestionKind* findQuestionKind(std::string_view name) {
    return findNamed(kQuestionKinds, name);
}

Grade gradeAnswer(const Question& question, const Answer& given, const Answer& right) {
    const QuestionKind* kind = findQuestionKind(question.kind);
    assert(kind != nullptr);
    return kind->grade(given, right, question);
}

std::optional<std::size_t> rightOption(const QuestionContext& context, const Answer& right) {
    const QuestionKind* kind = findQuestionKind(context.question.kind);
    assert(kind != nullptr);
    if (right.choice) return right.choice;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < context.question.options.size(); ++i) {
        // "8, 9" names two points.
        const Words words = io::wordsIn(context.question.options[i], ',');
        const Result<Answer> option = kind->read(words, context);
        if (!option || !kind->grade(option.value(), right, context.question).right) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

std::string optionLetter(std::size_t option) {
    return std::string(1, static_cast<char>('A' + static_cast<int>(option)));
}

}  // namespace se::teach
