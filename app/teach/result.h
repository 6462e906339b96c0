/// Answers of one person or of one room to the questions of a lesson, as a file (.result.json), and
/// the results of many summed up per question.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson_runs.h"

namespace se::teach {

/// Extension of a result's file.
inline constexpr std::string_view kResultExtension = ".result.json";

/// The first answer of a person to a question.
struct FirstTry {
    std::vector<std::string> given;
    /// What is wrong with it: points, letters, numbers or the first wrong move; "without q" for a
    /// point or a move that is missing. Empty if it is right.
    std::vector<std::string> mistakes;
    bool isRight() const { return mistakes.empty(); }
};

/// The answer to one question.
struct GivenAnswer {
    std::size_t step = 0;  ///< Of the lesson, from 1.
    std::string title;     ///< Of the step.
    std::string kind;
    std::vector<std::string> given;  ///< Names of points, a letter, or a number; of a room, none.
    std::vector<std::string> wrong;  ///< Of `given`, those that do not belong to the answer.
    bool right = false;
    double score = 0.0;             ///< From 0 to 1.
    double seconds = 0.0;           ///< Until the last try.
    std::size_t tries = 1;          ///< 0: not counted.
    std::optional<FirstTry> first;  ///< Nothing if it is not known, and of a room.
    /// Of a room: how many chose A, B, C and D; else empty.
    std::vector<std::size_t> counts;
    std::size_t rightOption = 0;  ///< Of a room, from 0.

    bool isOfRoom() const { return !counts.empty(); }
};

/// All answers of one student or of a room.
struct LessonResult {
    std::string lesson;  ///< Title.
    std::string hash;    ///< Lesson::hash: answers to another text are another lesson's.
    std::string person;  ///< Empty unless the user typed a name.
    std::vector<GivenAnswer> answers;
};

/// Grades an answer, as the first one, to the question of step number `step`, from 0. Requires a
/// question there.
GivenAnswer gradedAnswer(const Lesson& lesson, std::size_t step, const Answer& given,
                         const RightAnswer& right);

/// The answer of a room: `counts` hands for each of the options. Requires as many as options.
GivenAnswer roomAnswer(const Lesson& lesson, std::size_t step, std::vector<std::size_t> counts,
                       const RightAnswer& right);

/// JSON of a result.
std::string resultJson(const LessonResult& result);
/// Reads resultJson(); `name` begins messages, which name the field and what was expected.
Result<LessonResult> resultFromJson(std::string_view text, const std::string& name);

/// One question over many results.
struct QuestionSummary {
    std::string lesson;
    std::string hash;
    std::size_t step = 0;
    std::string title;
    std::string kind;
    std::size_t people = 0;  ///< Answers: of a room, hands.
    std::size_t right = 0;
    double scores = 0.0;   ///< Sum.
    double seconds = 0.0;  ///< Sum over `timed`.
    std::size_t timed = 0;
    std::map<std::string, std::size_t> wrong;  ///< Wrong points, letters or numbers, with counts.
    std::size_t firsts = 0;  ///< Answers of which the first try is known: hands of a room, too.
    std::size_t rightAtFirst = 0;
    std::map<std::string, std::size_t> mistakes;  ///< FirstTry::mistakes, with counts.
    std::vector<std::size_t> counts;              ///< Of all rooms and choices together, A to D.

    double rightShare() const;
    /// The share of `firsts` that were right; nothing if none is known.
    std::optional<double> rightAtFirstShare() const;
    double meanScore() const;
    double meanSeconds() const;
};

/// The most frequent of QuestionSummary::wrong or QuestionSummary::mistakes; empty if there is
/// none.
std::string mostFrequentOf(const std::map<std::string, std::size_t>& words);

/// One row per question of each lesson, by title of the lesson, hash and step.
std::vector<QuestionSummary> summarize(std::span<const LessonResult> results);

/// The rows as a table for the terminal.
std::string summaryText(std::span<const QuestionSummary> rows);
/// The rows as CSV (RFC 4180), with a line of names.
std::string summaryCsv(std::span<const QuestionSummary> rows);

}  // namespace se::teach
