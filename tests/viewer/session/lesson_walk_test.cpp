#include "session/lesson_walk.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

namespace {

/// The lesson The spiral at a step, from 0: 1 asks for points, 3 for a point, 5 for a number.
LessonWalk spiralAt(std::size_t step) {
    const Result<OpenedLesson> opened = openLesson("lesson:spiral", [](double) { return true; });
    REQUIRE(opened.ok());
    LessonWalk walk;
    walk.open(opened.value(), step);
    return walk;
}

}  // namespace

TEST_CASE("A lesson opens at a step, at most at the last one") {
    LessonWalk walk = spiralAt(3);
    CHECK(walk.step() == 3);
    CHECK(walk.setting().at == "1.ring.6");
    walk.goTo(99);
    CHECK(walk.step() + 1 == walk.lesson().steps.size());
    walk.close();
    CHECK_FALSE(walk.isOpen());
}

TEST_CASE("Marked points are an answer, by their names, and a second mark takes one back") {
    LessonWalk walk = spiralAt(1);
    REQUIRE(walk.takesPoints());
    walk.toggle(2);
    walk.toggle(6);
    CHECK(walk.state().typed == "3, 7");
    walk.toggle(2);
    CHECK(walk.state().typed == "7");
    CHECK(walk.state().given.points == std::vector<Index>{6});
    walk.type("3 4,5");
    CHECK(walk.state().given.points == std::vector<Index>{2, 3, 4});
    walk.type("nobody");
    CHECK_FALSE(walk.state().complaint.empty());
    walk.answer();
    CHECK(walk.state().tries == 0);
}

TEST_CASE("Of a question for one point the last click counts") {
    LessonWalk walk = spiralAt(3);
    walk.toggle(4);
    walk.toggle(1);
    CHECK(walk.state().given.points == std::vector<Index>{1});
}

TEST_CASE("A wrong answer leaves the question open, a right one shows it, and tries are counted") {
    LessonWalk walk = spiralAt(1);
    walk.type("3, 4, 8");
    walk.answer();
    CHECK(walk.asks());
    REQUIRE(walk.state().grade.has_value());
    CHECK_FALSE(walk.state().grade->right);
    walk.addSeconds(12.0);
    walk.type("7, 6, 5, 4, 3");
    walk.answer();
    CHECK_FALSE(walk.asks());
    REQUIRE(walk.result().answers.size() == 1);
    const teach::GivenAnswer& answer = walk.result().answers.front();
    CHECK(answer.right);
    CHECK(answer.tries == 2);
    CHECK(answer.step == 2);
    CHECK(answer.seconds == doctest::Approx(12.0));
    CHECK(walk.result().hash == walk.lesson().hash);
}

TEST_CASE("Showing the answer grades what was given, and records nothing if nothing was") {
    LessonWalk walk = spiralAt(1);
    walk.showAnswer();
    CHECK_FALSE(walk.asks());
    CHECK_FALSE(walk.hasAnswers());
    walk.goTo(5);
    walk.type("2");
    walk.showAnswer();
    REQUIRE(walk.result().answers.size() == 1);
    CHECK_FALSE(walk.result().answers.front().right);
}

TEST_CASE("Hands of a room are one answer, with the share of those who were right") {
    LessonWalk walk = spiralAt(1);
    walk.setHands({6, 3, 1});
    walk.showAnswer();
    REQUIRE(walk.result().answers.size() == 1);
    const teach::GivenAnswer& answer = walk.result().answers.front();
    CHECK(answer.counts == std::vector<std::size_t>{6, 3, 1});
    CHECK(answer.rightOption == 0);
    CHECK(answer.score == doctest::Approx(0.6));
}

TEST_CASE("Answers stay when other steps are shown, in the order of the steps") {
    LessonWalk walk = spiralAt(5);
    walk.type("1");
    walk.answer();
    CHECK_FALSE(walk.asks());
    walk.goTo(1);
    CHECK(walk.asks());
    walk.type("3");
    walk.showAnswer();
    REQUIRE(walk.result().answers.size() == 2);
    CHECK(walk.result().answers[0].step == 2);
    CHECK(walk.result().answers[1].step == 6);
    walk.goTo(5);
    CHECK_FALSE(walk.asks());
}

TEST_CASE("A lesson that is not there, or is faulty, is refused with its name") {
    const auto go = [](double) { return true; };
    const Result<OpenedLesson> unknown = openLesson("lesson:nothing", go);
    REQUIRE_FALSE(unknown.ok());
    CHECK(unknown.error().message.find("lesson:nothing") != std::string::npos);
    CHECK_FALSE(openLesson("/no/such.lesson.md", go).ok());
    CHECK_FALSE(openLesson("lesson:spiral", [](double) { return false; }).ok());
}
