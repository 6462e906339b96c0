#include "teach/question.h"

#include <doctest/doctest.h>

#include "lesson_files.h"
#include "teach/lesson_read.h"
#include "teach/lesson_runs.h"

namespace se::teach {
namespace {

Question questionOf(const std::string& kind) {
    Question question;
    question.kind = kind;
    return question;
}

Answer pointsAnswer(std::vector<Index> points) {
    Answer answer;
    answer.points = std::move(points);
    return answer;
}

Answer numberAnswer(double number) {
    Answer answer;
    answer.number = number;
    return answer;
}

}  // namespace

TEST_CASE("points are graded by the share in common, in any order") {
    const Question question = questionOf("points");
    const Answer right = pointsAnswer({4, 2, 9});
    CHECK(gradeAnswer(question, pointsAnswer({9, 4, 2, 2}), right).right);
    const Grade half = gradeAnswer(question, pointsAnswer({2, 4, 7}), right);
    CHECK_FALSE(half.right);
    CHECK(half.score == doctest::Approx(0.5));
    CHECK(half.wrong == std::vector<Index>{7});
    CHECK(half.missing == std::vector<Index>{9});
    CHECK(gradeAnswer(question, {}, right).score == 0.0);
    CHECK(gradeAnswer(question, {}, {}).right);
}

TEST_CASE("one point, a choice and a number are right or wrong") {
    CHECK(gradeAnswer(questionOf("point"), pointsAnswer({3}), pointsAnswer({3})).score == 1.0);
    CHECK(gradeAnswer(questionOf("point"), pointsAnswer({3, 4}), pointsAnswer({3})).score == 0.0);
    Answer b;
    b.choice = 1;
    CHECK(gradeAnswer(questionOf("choice"), b, b).right);
    CHECK_FALSE(gradeAnswer(questionOf("choice"), {}, b).right);
    Question number = questionOf("number");
    CHECK_FALSE(gradeAnswer(number, numberAnswer(117), numberAnswer(118)).right);
    number.within = 1.0;
    CHECK(gradeAnswer(number, numberAnswer(117), numberAnswer(118)).right);
    CHECK_FALSE(gradeAnswer(number, {}, numberAnswer(118)).right);
}

TEST_CASE("played moves are graded up to the first that differs") {
    const Question play = questionOf("play");
    const QuestionContext context{play, {{46, "q"}, {9, "t"}}};
    const QuestionKind& kind = *findQuestionKind("play");
    const Answer right =
        kind.read({"keep t", "remove q", "fan 20 t 39", "next 39"}, context).value();
    CHECK(gradeAnswer(play, right, right).score == 1.0);
    Answer given = right;
    given.moves[1].kind = MoveKind::Keep;
    CHECK_FALSE(gradeAnswer(play, given, right).right);
    CHECK(gradeAnswer(play, given, right).score == doctest::Approx(0.25));
    CHECK(gradeAnswer(play, given, right).wrong == std::vector<Index>{46});
    given = right;
    given.moves[2].points = {20, 9, 46, 39};
    CHECK(gradeAnswer(play, given, right).wrong == std::vector<Index>{46});
    given = right;
    given.moves.pop_back();
    CHECK_FALSE(gradeAnswer(play, given, right).right);
    CHECK(kind.text(right, context) == "keep t; remove q; fan 20 t 39; next 39");
    CHECK(kind.read({"keep x"}, context).error().message ==
          "keep: \"x\" is no name and no number of a point");
}

TEST_CASE("the option of a room is that whose text is the answer") {
    Question question = questionOf("points");
    question.options = {"q", "t, s", "t s r"};
    const std::vector<PointName> names{{46, "q"}, {9, "t"}, {31, "s"}, {35, "r"}};
    const QuestionContext context{question, names};
    CHECK(rightOption(context, pointsAnswer({31, 9})) == 1);
    CHECK(rightOption(context, pointsAnswer({9, 31, 35})) == 2);
    CHECK_FALSE(rightOption(context, pointsAnswer({9})).has_value());
    question.options = {"t, s", "s, t"};
    CHECK_FALSE(rightOption(context, pointsAnswer({9, 31})).has_value());
}

TEST_CASE("each kind writes an answer that it reads back") {
    Question question = questionOf("choice");
    question.options = {"one", "two"};
    const std::vector<PointName> names{{46, "q"}};
    const QuestionContext context{question, names};
    const auto textOf = [&](std::string_view kind, const Answer& answer) {
        return findQuestionKind(kind)->text(answer, context);
    };
    Answer b;
    b.choice = 1;
    CHECK(textOf("choice", b) == "B: two");
    CHECK(textOf("choice", {}) == "none");
    CHECK(textOf("points", pointsAnswer({46, 3})) == "q, 3");
    CHECK(textOf("number", numberAnswer(0.5)) == "0.5");
    CHECK(findQuestionKind("choice")->read({"two"}, context).value() == b);
    CHECK(findQuestionKind("choice")->read({"B"}, context).value() == b);
    CHECK_FALSE(findQuestionKind("choice")->read({"C"}, context).ok());
    CHECK_FALSE(findQuestionKind("point")->read({"1", "2"}, context).ok());
    CHECK_FALSE(findQuestionKind("points")->read({"-1"}, context).ok());
    CHECK_FALSE(findQuestionKind("number")->read({"nan"}, context).ok());
    CHECK(findQuestionKind("word") == nullptr);
}

TEST_CASE("answers of a run: Figure 8") {
    struct Row {
        std::string kind, answer, text;
    };
    const std::vector<Row> table{
        {"points", "refused", "q"},       {"points", "kept", "t, s, r"},
        {"number", "count:refused", "1"}, {"number", "count:kept", "3"},
        {"point", "start", "first"},      {"point", "end", "last"},
    };
    for (const Row& row : table) {
        CAPTURE(row.answer);
        const std::string toml = "kind = \"" + row.kind + "\"\nat = \"9.limits.2\"\n" +
                                 "until = \"9.sphere.4\"\nanswer = \"" + row.answer + "\"";
        const LessonReading reading = readLesson(lessonWith(stepWith("ask", toml)), "x");
        REQUIRE(reading.ok());
        LessonRuns runs({});
        const Result<RightAnswer> right = rightAnswer(reading.lesson, 0, runs);
        REQUIRE(right.ok());
        CHECK(right.value().text == row.text);
        CHECK(right.value().shown.size() == 4);
        CHECK(std::string(toString(right.value().shown.back().address)) == "9.sphere.4");
    }
}

TEST_CASE("answers of a run: the fan, the next pivot and the ring") {
    struct Row {
        std::string kind, answer, until, text;
    };
    const std::vector<Row> table{
        {"points", "fan", "9.emit.4", "t, first, s, r, last"},
        {"point", "next", "9.advance.1", "last"},
        {"number", "count:triangles", "9.emit.4", "4"},
        {"number", "count:enter", "9.advance.1", "3"},
        {"number", "count:leave", "9.advance.1", "1"},
        {"number", "count:ring", "9.pivot.1", "14"},
        {"number", "count:stack", "9.pivot.1", "0"},
        {"number", "count:rings", "9.pivot.1", "1"},
    };
    for (const Row& row : table) {
        CAPTURE(row.answer);
        const std::string toml = "kind = \"" + row.kind + "\"\nat = \"8.advance.1\"\nuntil = \"" +
                                 row.until + "\"\nanswer = \"" + row.answer + "\"";
        const LessonReading reading = readLesson(lessonWith(stepWith("ask", toml)), "x");
        REQUIRE(reading.ok());
        LessonRuns runs({});
        const Result<RightAnswer> right = rightAnswer(reading.lesson, 0, runs);
        REQUIRE(right.ok());
        CHECK(right.value().text == row.text);
    }
}

}  // namespace se::teach
