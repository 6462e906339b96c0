#include "teach/result.h"

#include <doctest/doctest.h>

#include "lesson_files.h"
#include "teach/lesson_read.h"

namespace se::teach {
namespace {

Lesson figure8Lesson() {
    return readLesson(lessonWith(stepWith(
                          "ask",
                          "kind = \"points\"\nat = \"9.limits.2\"\nuntil = \"9.sphere.4\"\n"
                          "answer = \"refused\"\noptions = [\"t\", \"q\", \"s\", \"r\"]")),
                      "x")
        .lesson;
}

RightAnswer rightOf(const Lesson& lesson) {
    LessonRuns runs({});
    Result<RightAnswer> right = rightAnswer(lesson, 0, runs);
    REQUIRE(right.ok());
    return std::move(right.value());
}

LessonResult resultWith(const Lesson& lesson, const std::vector<Index>& points) {
    Answer given;
    given.points = points;
    LessonResult result;
    result.lesson = lesson.title;
    result.hash = lesson.hash;
    result.answers.push_back(gradedAnswer(lesson, 0, given, rightOf(lesson)));
    result.answers.back().seconds = 12.5;
    result.answers.back().tries = 2;
    return result;
}

}  // namespace

TEST_CASE("a result reads back as it was written") {
    const Lesson lesson = figure8Lesson();
    LessonResult result = resultWith(lesson, {46, 9});
    result.person = "Ada";
    result.answers.push_back(roomAnswer(lesson, 0, {3, 12, 1, 0}, rightOf(lesson)));
    const Result<LessonResult> back = resultFromJson(resultJson(result), "x");
    REQUIRE(back.ok());
    CHECK(resultJson(back.value()) == resultJson(result));
    const GivenAnswer& person = back.value().answers[0];
    CHECK(person.step == 1);
    CHECK(person.given == std::vector<std::string>{"q", "t"});
    CHECK(person.wrong == std::vector<std::string>{"t"});
    CHECK(person.score == doctest::Approx(0.5));
    CHECK(person.tries == 2);
    REQUIRE(person.first.has_value());
    CHECK(person.first->given == std::vector<std::string>{"q", "t"});
    CHECK(person.first->mistakes == std::vector<std::string>{"t"});
    CHECK_FALSE(back.value().answers[1].first.has_value());
    const GivenAnswer& room = back.value().answers[1];
    CHECK(room.counts == std::vector<std::size_t>{3, 12, 1, 0});
    CHECK(room.rightOption == 1);
    CHECK(room.score == doctest::Approx(0.75));
}

TEST_CASE("bad results are refused with the field") {
    const std::string good = resultJson(resultWith(figure8Lesson(), {46}));
    struct Bad {
        std::string from, to, field;
    };
    const std::vector<Bad> table{
        {"spiraling-edge lesson result", "other", "format"},
        {"\"version\": 1", "\"version\": 2", "version"},
        {"\"hash\"", "\"hush\"", "hash"},
        {"\"answers\": [", "\"answer\": [", "answers"},
        {"\"right\": true", "\"right\": 1", "right"},
        {"\"score\": 1.0", "\"score\": -1", "score"},
        {"\"seconds\": 12.5", "\"seconds\": \"long\"", "seconds"},
        {"\"tries\": 2", "\"tries\": -2", "tries"},
        {"\"given\": [", "\"given\": [3, ", "given"},
        {"\"mistakes\": [", "\"mistakes\": [3", "mistakes"},
        {"\"first\": {", "\"first\": 3, \"second\": {", "first"},
        {"\"right\":", "\"counts\": [1, 2], \"right_option\": \"C\", \"right\":", "right_option"},
        {"{", "", "line 2, column 11: expected JSON"},
    };
    CHECK(resultFromJson(good, "x").ok());
    for (const Bad& each : table) {
        CAPTURE(each.field);
        std::string text = good;
        const std::size_t at = text.find(each.from);
        REQUIRE(at != std::string::npos);
        text.replace(at, each.from.size(), each.to);
        const Result<LessonResult> result = resultFromJson(text, "x");
        REQUIRE_FALSE(result.ok());
        CHECK(result.error().message.find(each.field) != std::string::npos);
    }
}

TEST_CASE("results are summed up per question, persons and rooms together") {
    const Lesson lesson = figure8Lesson();
    std::vector<LessonResult> results{resultWith(lesson, {46}), resultWith(lesson, {46, 9}),
                                      resultWith(lesson, {9, 31})};
    const std::vector<QuestionSummary> persons = summarize(results);
    REQUIRE(persons.size() == 1);
    CHECK(persons[0].people == 3);
    CHECK(persons[0].right == 1);
    CHECK(mostFrequentOf(persons[0].wrong) == "t");
    CHECK(persons[0].wrong.at("t") == 2);
    CHECK(persons[0].meanSeconds() == 12.5);
    LessonResult room = results[0];
    room.answers = {roomAnswer(lesson, 0, {1, 5, 0, 1}, rightOf(lesson))};
    results.push_back(room);
    const std::vector<QuestionSummary> all = summarize(results);
    REQUIRE(all.size() == 1);
    CHECK(all[0].people == 10);
    CHECK(all[0].right == 6);
    CHECK(summaryText(all).find("60 %") != std::string::npos);
    CHECK(summaryCsv(all).find(",10,6,0.6,") != std::string::npos);
    CHECK(all[0].rightAtFirstShare() == doctest::Approx(0.6));
    CHECK(all[0].mistakes.at("t") == 2);
    CHECK(all[0].mistakes.at("without q") == 1);
    CHECK(mostFrequentOf(all[0].mistakes) == "t");
    CHECK(summaryCsv(all).find(",0.6,t,2,") != std::string::npos);
    results.push_back(results[0]);
    results.back().hash = "another";
    CHECK(summarize(results).size() == 2);
}

TEST_CASE("the first try of a person counts beside the last one") {
    const Lesson lesson = figure8Lesson();
    std::vector<LessonResult> results{resultWith(lesson, {46}), resultWith(lesson, {46})};
    results[0].answers[0].first = resultWith(lesson, {31}).answers[0].first;
    const std::vector<QuestionSummary> rows = summarize(results);
    CHECK(rows[0].rightShare() == 1.0);
    CHECK(rows[0].rightAtFirstShare() == 0.5);
    CHECK(rows[0].wrong.empty());
    CHECK(rows[0].mistakes == std::map<std::string, std::size_t>{{"s", 1}, {"without q", 1}});
}

TEST_CASE("fields of CSV are quoted, and are no formulas") {
    QuestionSummary row;
    row.lesson = "=1+1";
    row.title = "a \"b\", c";
    const std::string csv = summaryCsv({&row, 1});
    CHECK(csv.find("'=1+1,") != std::string::npos);
    CHECK(csv.find("\"a \"\"b\"\", c\"") != std::string::npos);
}

}  // namespace se::teach
