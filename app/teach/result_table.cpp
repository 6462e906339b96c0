#include "result_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "spiraling_edge/base/number_text.h"

namespace se::teach {
namespace {

constexpr std::size_t kLetters = 4;

double meanOf(double sum, std::size_t count) {
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

void addRoom(const GivenAnswer& answer, QuestionSummary& row) {
    row.counts.resize(std::max(row.counts.size(), answer.counts.size()));
    for (std::size_t i = 0; i < answer.counts.size(); ++i) {
        const std::size_t hands = answer.counts[i];
        row.counts[i] += hands;
        row.people += hands;
        if (i == answer.rightOption) {
            row.right += hands;
            row.scores += static_cast<double>(hands);
            row.rightAtFirst += hands;
        } else if (hands > 0) {
            row.wrong[optionLetter(i)] += hands;
            row.mistakes[optionLetter(i)] += hands;
        }
        row.firsts += hands;
    }
}

void addPerson(const GivenAnswer& answer, QuestionSummary& row) {
    row.people += 1;
    row.right += answer.right ? 1 : 0;
    row.scores += answer.score;
    row.seconds += answer.seconds;
    row.timed += 1;
    for (const std::string& each : answer.wrong) row.wrong[each] += 1;
    if (answer.first) {
        row.firsts += 1;
        row.rightAtFirst += answer.first->isRight() ? 1 : 0;
        for (const std::string& each : answer.first->mistakes) row.mistakes[each] += 1;
    }
    const bool isLetter = answer.kind == "choice" && answer.given.size() == 1 &&
                          answer.given[0].size() == 1 && answer.given[0][0] >= 'A' &&
                          answer.given[0][0] < static_cast<char>('A' + kLetters);
    if (!isLetter) return;
    const auto option = static_cast<std::size_t>(answer.given[0][0] - 'A');
    row.counts.resize(std::max(row.counts.size(), option + 1));
    row.counts[option] += 1;
}

/// A field of CSV: quoted where it must be. A leading = + - @ would be a formula to a spreadsheet.
std::string csvField(std::string text) {
    if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
        text.insert(0, "'");
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string percentText(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
}

using WordCounts = std::map<std::string, std::size_t>;

/// "t (3)"; "-" without any.
std::string frequentText(const WordCounts& words) {
    const std::string most = mostFrequentOf(words);
    return most.empty() ? "-" : most + " (" + std::to_string(words.at(most)) + ")";
}

/// Two fields of CSV: the most frequent word and its count.
std::string frequentFields(const WordCounts& words) {
    const std::string most = mostFrequentOf(words);
    return csvField(most) + ',' + std::to_string(most.empty() ? 0 : words.at(most));
}

}  // namespace

double QuestionSummary::rightShare() const { return meanOf(static_cast<double>(right), people); }
double QuestionSummary::meanScore() const { return meanOf(scores, people); }
double QuestionSummary::meanSeconds() const { return meanOf(seconds, timed); }

std::optional<double> QuestionSummary::rightAtFirstShare() const {
    if (firsts == 0) return std::nullopt;
    return meanOf(static_cast<double>(rightAtFirst), firsts);
}

std::string mostFrequentOf(const WordCounts& words) {
    const auto most =
        std::max_element(words.begin(), words.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == words.end() ? std::string() : most->first;
}

std::vector<QuestionSummary> summarize(std::span<const LessonResult> results) {
    std::map<std::tuple<std::string, std::string, std::size_t>, QuestionSummary> rows;
    for (const LessonResult& result : results) {
        for (const GivenAnswer& answer : result.answers) {
            QuestionSummary& row = rows[{result.lesson, result.hash, answer.step}];
            row.lesson = result.lesson;
            row.hash = result.hash;
            row.step = answer.step;
            row.title = answer.title;
            row.kind = answer.kind;
            answer.isOfRoom() ? addRoom(answer, row) : addPerson(answer, row);
        }
    }
    std::vector<QuestionSummary> list;
    list.reserve(rows.size());
    for (auto& [key, row] : rows) list.push_back(std::move(row));
    return list;
}

std::string summaryText(std::span<const QuestionSummary> rows) {
    std::string text;
    std::string lesson;
    for (const QuestionSummary& row : rows) {
        if (row.lesson + row.hash != lesson)
            text += row.lesson + " (" + row.hash +
                    ")\n  step  answers  right  wrong most often  right at first  "
                    "first mistake     question\n";
        lesson = row.lesson + row.hash;
        const std::optional<double> first = row.rightAtFirstShare();
        text += "  " + padded(std::to_string(row.step), 6) + padded(std::to_string(row.people), 9) +
                padded(percentText(row.rightShare()), 7) + padded(frequentText(row.wrong), 18) +
                padded(first ? percentText(*first) : "-", 16) +
                padded(frequentText(row.mistakes), 18) + row.title + "\n";
    }
    return text;
}

std::string summaryCsv(std::span<const QuestionSummary> rows) {
    std::string text =
        "lesson,hash,step,question,kind,answers,right,share_right,mean_score,mean_seconds,"
        "wrong_most_often,wrong_count,share_right_first,first_mistake,first_mistake_count,"
        "A,B,C,D\r\n";
    for (const QuestionSummary& row : rows) {
        const std::optional<double> first = row.rightAtFirstShare();
        text += csvField(row.lesson) + ',' + csvField(row.hash) + ',' + std::to_string(row.step) +
                ',' + csvField(row.title) + ',' + csvField(row.kind) + ',' +
                std::to_string(row.people) + ',' + std::to_string(row.right) + ',' +
                shortNumber(row.rightShare()) + ',' + shortNumber(row.meanScore()) + ',' +
                shortNumber(row.meanSeconds()) + ',' + frequentFields(row.wrong) + ',' +
                (first ? shortNumber(*first) : std::string()) + ',' + frequentFields(row.mistakes);
        for (std::size_t i = 0; i < kLetters; ++i)
            text += ',' + (i < row.counts.size() ? std::to_string(row.counts[i]) : std::string());
        text += "\r\n";
    }
    return text;
}

}  // namespace se::teach
