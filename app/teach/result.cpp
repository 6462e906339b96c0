#include "result.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include "json_text.h"
#include "spiraling_edge/base/number_text.h"

namespace se::teach {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view kResultFormat = "spiraling-edge lesson result";

/// An answer in words that its kind reads back.
std::vector<std::string> answerWords(const Answer& answer, const std::vector<PointName>& names) {
    if (answer.choice) return {optionLetter(*answer.choice)};
    std::vector<std::string> moves;
    moves.reserve(answer.moves.size());
    for (const PlayMove& each : answer.moves) moves.push_back(moveText(each, names));
    if (!moves.empty()) return moves;
    if (!answer.number) return namesOf(answer.points, names);
    return {plainNumber(*answer.number)};
}

GivenAnswer emptyAnswer(const Lesson& lesson, std::size_t step) {
    assert(step < lesson.steps.size() && lesson.steps[step].question);
    GivenAnswer answer;
    answer.step = step + 1;
    answer.title = lesson.steps[step].title;
    answer.kind = lesson.steps[step].question->kind;
    return answer;
}

std::string withoutText(const std::string& what) { return "without " + what; }

/// FirstTry::mistakes of an answer that was graded; of a played pivot the first wrong move, or the
/// one that is missing.
std::vector<std::string> mistakesIn(const GivenAnswer& answer, const Answer& given,
                                    const Answer& right, const Grade& grade,
                                    const std::vector<PointName>& names) {
    if (answer.right) return {};
    if (answer.kind == "play") {
        const std::size_t alike = movesAlike(given.moves, right.moves);
        if (alike < given.moves.size()) return {moveText(given.moves[alike], names)};
        return {withoutText(moveText(right.moves[alike], names))};
    }
    std::vector<std::string> mistakes = answer.wrong;
    if (answer.kind != "points") return mistakes;
    for (const std::string& name : namesOf(grade.missing, names))
        mistakes.push_back(withoutText(name));
    return mistakes;
}

Json jsonOfAnswer(const GivenAnswer& each) {
    Json answer{{"step", each.step}, {"title", each.title}, {"kind", each.kind}};
    if (each.isOfRoom()) {
        answer["counts"] = each.counts;
        answer["right_option"] = optionLetter(each.rightOption);
    } else {
        answer["given"] = each.given;
        answer["wrong"] = each.wrong;
    }
    if (each.first)
        answer["first"] = {{"given", each.first->given}, {"mistakes", each.first->mistakes}};
    answer["right"] = each.right;
    answer["score"] = each.score;
    answer["seconds"] = each.seconds;
    if (each.tries > 0) answer["tries"] = each.tries;
    return answer;
}

/// Reads what a room answered.
void readRoom(const JsonEntry& entry, GivenAnswer& answer) {
    const JsonEntry counts = entry.at("counts");
    for (const JsonEntry& each : counts.items("a list of whole numbers from 0 on"))
        answer.counts.push_back(each.count());
    if (answer.counts.empty() || answer.counts.size() > 4) counts.fail("two to four numbers");
    const JsonEntry right = entry.at("right_option");
    while (optionLetter(answer.rightOption) != right.text()) {
        if (++answer.rightOption == answer.counts.size()) right.fail("the letter of an option");
    }
}

GivenAnswer givenAnswer(const JsonEntry& entry) {
    GivenAnswer answer;
    answer.step = entry.at("step").count();
    answer.title = entry.at("title").text();
    answer.kind = entry.at("kind").text();
    answer.right = entry.at("right").truth();
    answer.score = entry.at("score").number();
    answer.seconds = entry.at("seconds").number();
    answer.tries = entry.has("tries") ? entry.at("tries").count() : 0;
    if (entry.has("counts")) {
        readRoom(entry, answer);
    } else {
        answer.given = entry.at("given").texts();
        answer.wrong = entry.at("wrong").texts();
    }
    if (!entry.has("first")) return answer;
    const JsonEntry first = entry.at("first");
    answer.first = FirstTry{first.at("given").texts(), first.at("mistakes").texts()};
    return answer;
}

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

GivenAnswer gradedAnswer(const Lesson& lesson, std::size_t step, const Answer& given,
                         const RightAnswer& right) {
    GivenAnswer answer = emptyAnswer(lesson, step);
    const std::vector<PointName> names = settingOf(lesson, step).names;
    const Grade grade = gradeAnswer(*lesson.steps[step].question, given, right.answer);
    answer.given = answerWords(given, names);
    answer.wrong = namesOf(grade.wrong, names);
    const bool hasPoints = !given.points.empty() || !given.moves.empty();
    if (!grade.right && grade.wrong.empty() && !hasPoints) answer.wrong = answer.given;
    answer.right = grade.right;
    answer.score = grade.score;
    answer.first = FirstTry{answer.given, mistakesIn(answer, given, right.answer, grade, names)};
    return answer;
}

GivenAnswer roomAnswer(const Lesson& lesson, std::size_t step, std::vector<std::size_t> counts,
                       const RightAnswer& right) {
    GivenAnswer answer = emptyAnswer(lesson, step);
    const std::vector<PointName> names = settingOf(lesson, step).names;
    const Question& question = *lesson.steps[step].question;
    assert(counts.size() == question.options.size() && !counts.empty());
    answer.counts = std::move(counts);
    answer.rightOption = rightOption({question, names}, right.answer).value_or(0);
    const std::size_t all =
        std::accumulate(answer.counts.begin(), answer.counts.end(), std::size_t{0});
    const std::size_t good = answer.counts[answer.rightOption];
    answer.score = all == 0 ? 0.0 : static_cast<double>(good) / static_cast<double>(all);
    answer.right = all > 0 && good == all;
    return answer;
}

std::string resultJson(const LessonResult& result) {
    Json root{{"format", kResultFormat},
              {"version", 1},
              {"lesson", result.lesson},
              {"hash", result.hash}};
    if (!result.person.empty()) root["person"] = result.person;
    root["answers"] = Json::array();
    for (const GivenAnswer& each : result.answers) root["answers"].push_back(jsonOfAnswer(each));
    return jsonText(root);
}

Result<LessonResult> resultFromJson(std::string_view text, const std::string& name) {
    const Result<nlohmann::json> parsed = jsonFromText<nlohmann::json>(text, name);
    if (!parsed) return parsed.error();
    const JsonEntry root(parsed.value(), name);
    try {
        if (!root.has("format") || root.at("format").json() != kResultFormat)
            return Error{name + ": no result of a lesson: \"format\": \"" +
                         std::string(kResultFormat) + "\" is missing"};
        if (root.at("version").json() != 1) root.at("version").fail("1");
        LessonResult result;
        result.lesson = root.at("lesson").text();
        result.hash = root.at("hash").text();
        if (root.has("person")) result.person = root.at("person").text();
        for (const JsonEntry& each : root.at("answers").items("a list"))
            result.answers.push_back(givenAnswer(each));
        return result;
    } catch (const Error& fault) {
        return fault;
    }
}

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
