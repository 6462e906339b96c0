#include "result.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "json_text.h"
#include "spiraling_edge/base/number_text.h"

namespace se::teach {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view kResultFormat = "spiraling-edge lesson result";

std::vector<std::string> namesOf(const std::vector<Index>& points,
                                 const std::vector<NamedPoint>& names) {
    const std::vector<PointName> list = pointNames(names);
    std::vector<std::string> words;
    words.reserve(points.size());
    for (const Index point : points) words.push_back(nameOf(point, list));
    return words;
}

/// An answer in words that its kind reads back.
std::vector<std::string> answerWords(const Answer& answer, const std::vector<NamedPoint>& names) {
    if (answer.choice) return {optionLetter(*answer.choice)};
    std::vector<std::string> moves;
    moves.reserve(answer.moves.size());
    for (const PlayMove& each : answer.moves) moves.push_back(moveText(each, names));
    if (!moves.empty()) return moves;
    if (!answer.number) return namesOf(answer.points, names);
    std::string text;
    appendPlainNumber(text, *answer.number);
    return {text};
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

/// The first wrong move, or the one that is missing.
std::vector<std::string> wrongMoves(const Answer& given, const Answer& right,
                                    const std::vector<NamedPoint>& names) {
    const std::size_t alike = movesAlike(given.moves, right.moves);
    if (alike < given.moves.size()) return {moveText(given.moves[alike], names)};
    return {withoutText(moveText(right.moves[alike], names))};
}

/// FirstTry::mistakes of an answer that was graded.
std::vector<std::string> mistakesIn(const GivenAnswer& answer, const Grade& grade,
                                    const std::vector<NamedPoint>& names) {
    if (answer.right) return {};
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

/// Reads the fields of an object; remembers the first that is not as expected.
class FieldReader {
  public:
    FieldReader(const Json& object, std::string name) : object_(object), name_(std::move(name)) {}

    void text(const char* field, std::string& out) {
        if (const Json* value = find(field, "a text", &Json::is_string))
            out = value->get<std::string>();
    }
    void number(const char* field, double& out) {
        if (const Json* value = find(field, "a number", &Json::is_number))
            out = value->get<double>();
        if (!(out >= 0.0) || !std::isfinite(out)) complain(field, "a number from 0 on");
    }
    void count(const char* field, std::size_t& out) {
        const Json* value = find(field, "a whole number from 0 on", &Json::is_number_unsigned);
        if (value != nullptr) out = value->get<std::size_t>();
    }
    void truth(const char* field, bool& out) {
        if (const Json* value = find(field, "true or false", &Json::is_boolean))
            out = value->get<bool>();
    }
    void texts(const char* field, std::vector<std::string>& out) {
        readList(field, "a list of texts", &Json::is_string, out);
    }
    void counts(const char* field, std::vector<std::size_t>& out) {
        readList(field, "a list of whole numbers from 0 on", &Json::is_number_unsigned, out);
    }
    void complain(const char* field, const std::string& expected) {
        if (problem_.empty()) problem_ = name_ + ": \"" + field + "\": expected " + expected;
    }
    const std::string& problem() const { return problem_; }

  private:
    using Test = bool (Json::*)() const noexcept;

    const Json* find(const char* field, const char* expected, Test test) {
        const auto found = object_.find(field);
        if (found != object_.end() && ((*found).*test)()) return &*found;
        complain(field, expected);
        return nullptr;
    }
    template <typename Value>
    void readList(const char* field, const char* expected, Test test, std::vector<Value>& out) {
        const Json* list = find(field, expected, &Json::is_array);
        if (list == nullptr) return;
        for (const Json& each : *list) {
            if (!(each.*test)()) return complain(field, expected);
            out.push_back(each.get<Value>());
        }
    }

    const Json& object_;
    std::string name_;
    std::string problem_;
};

/// Reads what a room answered.
void readRoom(FieldReader& fields, GivenAnswer& answer) {
    std::string letter;
    fields.counts("counts", answer.counts);
    fields.text("right_option", letter);
    const std::size_t option = letter.size() == 1 ? static_cast<std::size_t>(letter[0] - 'A') : 99;
    if (answer.counts.empty() || answer.counts.size() > 4)
        fields.complain("counts", "two to four numbers");
    if (option >= answer.counts.size()) fields.complain("right_option", "the letter of an option");
    answer.rightOption = std::min(option, std::max<std::size_t>(answer.counts.size(), 1) - 1);
}

/// Reads the first try. Returns the problem; empty if there is none.
std::string readFirstTry(const Json& object, const std::string& name, GivenAnswer& answer) {
    if (!object.is_object()) return name + ": \"first\": expected given and mistakes";
    FieldReader fields(object, name + ": \"first\"");
    answer.first.emplace();
    fields.texts("given", answer.first->given);
    fields.texts("mistakes", answer.first->mistakes);
    return fields.problem();
}

/// Reads one answer. Returns the problem; empty if there is none.
std::string readGivenAnswer(const Json& object, const std::string& name, GivenAnswer& answer) {
    if (!object.is_object()) return name + ": \"answers\": expected objects";
    FieldReader fields(object, name);
    fields.count("step", answer.step);
    fields.text("title", answer.title);
    fields.text("kind", answer.kind);
    fields.truth("right", answer.right);
    fields.number("score", answer.score);
    fields.number("seconds", answer.seconds);
    answer.tries = 0;
    if (object.contains("tries")) fields.count("tries", answer.tries);
    if (object.contains("counts")) {
        readRoom(fields, answer);
    } else {
        fields.texts("given", answer.given);
        fields.texts("wrong", answer.wrong);
    }
    if (!fields.problem().empty() || !object.contains("first")) return fields.problem();
    return readFirstTry(object["first"], name, answer);
}

}  // namespace

GivenAnswer gradedAnswer(const Lesson& lesson, std::size_t step, const Answer& given,
                         const RightAnswer& right) {
    GivenAnswer answer = emptyAnswer(lesson, step);
    const std::vector<NamedPoint> names = settingOf(lesson, step).names;
    const Grade grade = gradeAnswer(*lesson.steps[step].question, given, right.answer);
    answer.given = answerWords(given, names);
    answer.wrong = namesOf(grade.wrong, names);
    const bool hasPoints = !given.points.empty() || !given.moves.empty();
    if (!grade.right && grade.wrong.empty() && !hasPoints) answer.wrong = answer.given;
    answer.right = grade.right;
    answer.score = grade.score;
    answer.first = FirstTry{answer.given, !grade.right && answer.kind == "play"
                                              ? wrongMoves(given, right.answer, names)
                                              : mistakesIn(answer, grade, names)};
    return answer;
}

GivenAnswer roomAnswer(const Lesson& lesson, std::size_t step, std::vector<std::size_t> counts,
                       const RightAnswer& right) {
    GivenAnswer answer = emptyAnswer(lesson, step);
    const std::vector<NamedPoint> names = settingOf(lesson, step).names;
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
    const Result<Json> parsed = jsonFromText<Json>(text, name);
    if (!parsed) return parsed.error();
    const Json& root = parsed.value();
    if (!root.is_object() || root.value("format", Json()) != kResultFormat)
        return Error{name + ": no result of a lesson: \"format\": \"" + std::string(kResultFormat) +
                     "\" is missing"};
    if (root.value("version", Json()) != 1) return Error{name + ": \"version\": expected 1"};
    LessonResult result;
    FieldReader fields(root, name);
    fields.text("lesson", result.lesson);
    fields.text("hash", result.hash);
    if (root.contains("person")) fields.text("person", result.person);
    if (!root.contains("answers") || !root["answers"].is_array())
        fields.complain("answers", "a list");
    if (!fields.problem().empty()) return Error{fields.problem()};
    for (const Json& each : root["answers"]) {
        const std::string problem = readGivenAnswer(each, name, result.answers.emplace_back());
        if (!problem.empty()) return Error{problem};
    }
    return result;
}

}  // namespace se::teach
