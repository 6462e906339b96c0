#include "lesson/lesson_walk.h"

#include <doctest/doctest.h>

#include "teach/practice.h"

using namespace se;
using namespace se::view;

namespace {

/// The lesson The spiral at a step, from 0: 1 asks for points, 3 for a point, 5 for a number.
LessonWalk spiralAt(std::size_t step) {
    const Result<SharedLesson> opened = openLesson("lesson:spiral", [](double) { return true; });
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
    REQUIRE(answer.first.has_value());
    CHECK(answer.first->given == std::vector<std::string>{"3", "4", "8"});
    CHECK(answer.first->mistakes ==
          std::vector<std::string>{"8", "without 5", "without 6", "without 7"});
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
    const Result<SharedLesson> unknown = openLesson("lesson:nothing", go);
    REQUIRE_FALSE(unknown.ok());
    CHECK(unknown.error().message.find("lesson:nothing") != std::string::npos);
    CHECK_FALSE(openLesson("/no/such.lesson.md", go).ok());
    CHECK_FALSE(openLesson("lesson:spiral", [](double) { return false; }).ok());
}

namespace {

LessonWalk practiceOf(std::uint64_t seed) {
    const Result<SharedLesson> opened = openLesson(
        std::string(teach::kPracticePrefix) + std::to_string(seed), [](double) { return true; });
    REQUIRE(opened.ok());
    LessonWalk walk;
    walk.open(opened.value(), 0);
    return walk;
}

}  // namespace

TEST_CASE("A pivot is played by clicks: moves stand in the order of the algorithm") {
    LessonWalk walk = practiceOf(7);
    REQUIRE(walk.takesPoints());
    walk.chooseMove(teach::MoveKind::Keep);
    walk.toggle(5);
    walk.toggle(9);
    walk.chooseMove(teach::MoveKind::MoveStart);
    walk.toggle(2);
    CHECK(walk.state().typed == "start 2; keep 5; keep 9");
    walk.chooseMove(teach::MoveKind::Remove);
    walk.toggle(5);
    CHECK(walk.state().typed == "start 2; remove 5; keep 9");
    walk.chooseMove(teach::MoveKind::Fan);
    for (const Index point : {2U, 9U, 11U}) walk.toggle(point);
    walk.chooseMove(teach::MoveKind::NextPivot);
    walk.toggle(4);
    walk.toggle(9);
    CHECK(walk.state().typed == "start 2; remove 5; keep 9; fan 2 9 11; next 9");
    walk.removeMove(1);
    CHECK(walk.state().typed == "start 2; keep 9; fan 2 9 11; next 9");
    walk.type("start 2; stop 3");
    CHECK_FALSE(walk.state().complaint.empty());
}

TEST_CASE("A wrong move of a played pivot is answered by the decision of the run against it") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        CAPTURE(seed);
        const teach::PracticeTask task = teach::practiceTask(seed);
        LessonWalk walk = practiceOf(seed);
        std::string right, wrong;
        for (const teach::RunMove& each : task.solution) {
            const bool kept = each.move.kind == teach::MoveKind::Keep;
            teach::PlayMove other = each.move;
            if (kept) other.kind = teach::MoveKind::Remove;
            right += teach::moveText(each.move) + "; ";
            wrong += teach::moveText(other) + "; ";
        }
        walk.type(wrong);
        walk.answer();
        REQUIRE(walk.asks());
        const Event* against = walk.decisionAgainstTry();
        REQUIRE(against != nullptr);
        const teach::PracticeGrade grade = teach::gradePractice(task, walk.state().given.moves);
        CHECK(toString(against->address) == grade.address);
        walk.type(right);
        walk.answer();
        CHECK_FALSE(walk.asks());
        CHECK(walk.decisionAgainstTry() == nullptr);
    }
}

TEST_CASE("A wrong try of a played pivot is never told the move that is still to find") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        CAPTURE(seed);
        const teach::PracticeTask task = teach::practiceTask(seed);
        std::string right;
        for (std::size_t i = 0; i < task.solution.size(); ++i) {
            // The first moves, and those with one left out.
            const auto& next = task.solution[i];
            LessonWalk walk = practiceOf(seed);
            for (const std::string& last : {std::string(), std::string("; fan none; next none")}) {
                if (right.empty() && last.empty()) continue;
                walk.type(right + last);
                walk.answer();
                if (!walk.asks()) continue;
                const Event* against = walk.decisionAgainstTry();
                if (against != nullptr && !isA<AdvanceEvidence>(*against))
                    CHECK(toString(against->address) != toString(next.event.address));
            }
            right += (right.empty() ? "" : "; ") + teach::moveText(next.move);
        }
    }
}

TEST_CASE("A point that the input does not have is no answer") {
    LessonWalk walk = spiralAt(1);
    walk.setPointCount(76);
    walk.type("99999");
    CHECK(walk.state().complaint == "There is no point 99999.");
    CHECK(walk.givenPoints().empty());
}

TEST_CASE("The time of a question is counted over several visits") {
    LessonWalk walk = spiralAt(1);
    walk.addSeconds(5.0);
    walk.goTo(2);
    walk.goTo(1);
    walk.addSeconds(7.0);
    walk.type("3");
    walk.answer();
    CHECK(walk.result().answers.front().seconds == doctest::Approx(12.0));
}
