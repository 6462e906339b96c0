/// Results of many persons and rooms, summed up per question.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "result.h"

namespace se::teach {

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
