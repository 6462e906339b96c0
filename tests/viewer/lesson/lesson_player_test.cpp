#include "lesson/lesson_player.h"

#include <doctest/doctest.h>

#include <fstream>

#include "commands/commands.h"
#include "headless_app.h"
#include "teach/embedded_lessons.h"
#include "teach/lesson_check.h"
#include "teach/lesson_read.h"
#include "teach/practice.h"

using namespace se;
using namespace se::view;

namespace {

struct LessonApp : test::HeadlessApp {
    LessonApp() : test::HeadlessApp("lesson-test") {}
    void settle() {
        lesson.waitUntilDone();
        waitUntilDone();
        lesson.poll();
        waitUntilDone();
    }
    void open(const std::string& source) {
        document.open(source);
        settle();
    }
    void goTo(std::size_t step) {
        lesson.toStep(step);
        settle();
    }
    /// Calls the player and waits.
    void call(void (LessonPlayer::*act)()) {
        (lesson.*act)();
        settle();
    }
    std::string place() { return session.event() ? toString(session.address()) : "0"; }
    LessonWalk& walk() { return ui.lesson.walk; }
};

/// A share, such as 100%, is no address.
bool isAddress(const std::string& place) { return addressFromString(place).has_value(); }

}  // namespace

TEST_CASE("Every step of every lesson is shown at its position, with its question open") {
    LessonApp app;
    for (const teach::EmbeddedLesson& each : teach::embeddedLessons()) {
        app.open(embeddedLessonSource(each.id));
        REQUIRE(app.walk().isOpen());
        for (std::size_t i = 0; i < app.walk().lesson().steps.size(); ++i) {
            CAPTURE(std::string(each.id));
            CAPTURE(i + 1);
            app.goTo(i);
            REQUIRE(app.walk().step() == i);
            const std::string& at = app.walk().setting().at;
            if (isAddress(at) && at != "0") CHECK(app.session.reached(*addressFromString(at)));
            CHECK(app.session.horizon().has_value() == app.walk().asks());
            CHECK_FALSE(app.session.messages().missed());
        }
    }
}

TEST_CASE("While a question is open no move passes it, until it is answered") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(1);
    CHECK(app.place() == "1.sort.12");
    app.session.moves().stepEvent(1);
    app.session.moves().toEnd();
    app.session.moves().stepPivot(5);
    app.session.moves().goToShare(0.5);
    app.session.moves().goToPoint(30);
    app.session.moves().finishPivot();
    app.waitUntilDone();
    CHECK(app.place() == "1.sort.12");
    app.session.moves().stepEvent(-3);
    CHECK(app.place() == "1.sort.9");
    app.session.moves().toEnd();
    app.waitUntilDone();
    CHECK(app.place() == "1.sort.12");

    app.walk().type("3, 4, 5, 6, 7");
    app.call(&LessonPlayer::answer);
    CHECK_FALSE(app.walk().asks());
    CHECK(app.playback.playing());
    REQUIRE(app.playback.until.has_value());
    CHECK(toString(*app.playback.until) == "1.sphere.11");
    app.session.moves().toEnd();
    app.waitUntilDone();
    CHECK(app.session.atEnd());
}

TEST_CASE("A way off the step is noticed, and leads back to position, rules and question") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(2);
    CHECK_FALSE(app.ui.lesson.away);
    app.session.moves().toEnd();
    app.settle();
    CHECK(app.ui.lesson.away);
    app.call(&LessonPlayer::returnToStep);
    CHECK(app.place() == "1.ring.6");
    app.session.rerun(withRule(app.session.input().rules(), "sphere", 0.0));
    app.settle();
    CHECK(app.ui.lesson.away);
    app.call(&LessonPlayer::returnToStep);
    CHECK(app.session.input().rules().choices.empty());
    CHECK_FALSE(app.ui.lesson.away);
}

TEST_CASE("While a question for points is open the neighbors of the pivot have labels") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(1);
    REQUIRE(app.walk().takesPoints());
    const Index pivot = app.session.picture().pivot;
    CHECK(app.session.highlights().labeled().size() ==
          app.session.shown().points.neighbors[pivot].size());
    app.goTo(2);
    CHECK(app.session.highlights().labeled().empty());
}

TEST_CASE("Points that the sort has left out as DONE are no possible answer") {
    LessonApp app;
    app.open("lesson:removal");
    app.goTo(1);
    REQUIRE(app.walk().takesPoints());
    const std::span<const Index> possible = app.session.highlights().labeled();
    CHECK(possible.size() >= 4);
    for (const Index point : possible) CHECK(app.session.picture().status[point] != kDone);
}

TEST_CASE("Hands of a room are counted for one question only") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(1);
    app.ui.lesson.countsHands = true;
    CHECK(app.ui.lesson.countsRoom());
    app.goTo(3);
    CHECK_FALSE(app.ui.lesson.countsRoom());
}

TEST_CASE("Names of the lesson are those of its points, and end with it") {
    LessonApp app;
    app.open("lesson:removal");
    REQUIRE_FALSE(app.session.names().empty());
    app.call(&LessonPlayer::close);
    CHECK_FALSE(app.walk().isOpen());
    app.document.open("scene:torus");
    app.settle();
    CHECK(app.session.names().empty());
}

TEST_CASE("Opening something else closes the lesson, a step with another input does not") {
    LessonApp app;
    app.open("lesson:neighbor-ring");
    for (std::size_t i = 0; i < app.walk().lesson().steps.size(); ++i) app.goTo(i);
    CHECK(app.walk().isOpen());
    app.document.open("scene:torus");
    app.settle();
    CHECK_FALSE(app.walk().isOpen());
    CHECK_FALSE(app.session.horizon().has_value());
    CHECK(app.session.model().name == "scene:torus");
}

TEST_CASE("A key just after something else was opened opens no step of the lesson before") {
    LessonApp app;
    app.open("lesson:tour");
    app.document.open("scene:figure-8");
    runCommand(*findCommand("lesson.next"), app.context);
    CHECK(app.session.messages().last().find("No lesson is open") == 0);
    app.settle();
    CHECK_FALSE(app.walk().isOpen());
    CHECK(app.session.model().name == "scene:figure-8");
}

TEST_CASE("A lesson that is opened just after something else opens") {
    LessonApp app;
    app.document.open("scene:figure-8");
    app.document.open("lesson:tour");
    app.settle();
    CHECK(app.walk().isOpen());
}

TEST_CASE("Calls that wait while the lesson is closed do nothing") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(1);
    app.ui.betweenFrames.beginDrawing();
    app.lesson.close();
    app.lesson.toStep(2);
    app.lesson.returnToStep();
    app.lesson.play();
    app.lesson.answer();
    app.lesson.showAnswer();
    app.ui.betweenFrames.endDrawing();
    CHECK_FALSE(app.walk().isOpen());
    CHECK_FALSE(app.lesson.moving());
    const std::string file = (app.folder / "none.json").string();
    app.lesson.saveResult(file);
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK(app.session.messages().last().find("No lesson is open") == 0);
}

TEST_CASE("Without an input there is no lesson of bookmarks to save") {
    LessonApp app;
    const std::string file = (app.folder / "none.lesson.md").string();
    app.lesson.saveLesson(file);
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK(app.session.messages().last() == "There is nothing open to save.");
}

TEST_CASE("A step that is left before it plays does not play the next one") {
    LessonApp app;
    app.open("lesson:tour");
    app.goTo(2);
    app.playback.pause();
    app.lesson.play();
    app.lesson.toStep(4);
    app.settle();
    REQUIRE(app.walk().step() == 4);
    CHECK_FALSE(app.playback.playing());
}

TEST_CASE("The offer of the tour ends where a lesson opens") {
    LessonApp app;
    app.ui.offersTour = true;
    app.open("lesson:spiral");
    CHECK_FALSE(app.ui.offersTour);
}

TEST_CASE("A faulty lesson is refused with file and line, and the one before stays") {
    LessonApp app;
    app.open("lesson:tour");
    const std::filesystem::path path = app.folder / "bad.lesson.md";
    std::ofstream(path) << "# Bad\n```se lesson\nversion = 1\ninput = \"scene:torus\"\n```\n"
                           "## Step\n```se step\nat = \"1.sphere.99\"\n```\n";
    app.open(path.string());
    CHECK(app.lesson.opening().complaint().find("bad.lesson.md:8: at: pivot 1 has") !=
          std::string::npos);
    CHECK(app.walk().source() == "lesson:tour");
}

TEST_CASE("Bookmarks are saved as a lesson that passes its check, with notes and cameras") {
    LessonApp app;
    app.document.open("scene:figure-8");
    app.waitUntilDone();
    app.session.rerun(withRule(app.session.input().rules(), "maxgap", 100.0));
    app.waitUntilDone();
    for (const char* at : {"9.sphere.2", "9.emit.1"}) {
        REQUIRE(app.session.moves().goToText(at).ok());
        app.waitUntilDone();
        toggleBookmark(app.ui.bookmarks, app.session.address(), app.camera.pose());
    }
    app.ui.bookmarks[0].note = "# q \"goes\"";
    app.ui.notes = "Why q goes.";
    const std::string path = (app.folder / "mine.lesson.md").string();
    app.lesson.saveLesson(path);
    const Result<teach::LessonReading> reading = teach::readLessonFile(path);
    REQUIRE(reading.ok());
    REQUIRE(reading.value().ok());
    const teach::Lesson& lesson = reading.value().lesson;
    REQUIRE(lesson.steps.size() == 2);
    CHECK(lesson.steps[0].title == "q \"goes\"");
    CHECK(lesson.steps[1].title == "9.emit.1");
    CHECK(lesson.rules == specChange({{"switches", "maxgap=100"}}));
    CHECK(lesson.text.find("Why q goes.") != std::string::npos);
    CHECK(viewPositionFromText(lesson.steps[0].camera).value().camera == app.camera.pose());
    teach::LessonRuns runs(app.folder);
    CHECK(teach::checkLesson(lesson, runs).empty());
}

TEST_CASE("While a question is open only commands work that tell nothing of what follows") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(1);
    for (const char* id : {"file.savemesh", "ask.charts", "step.alert.next", "run.compare",
                           "step.mark.next", "run.play", "edit.rules.reset", "file.copycommand"}) {
        CAPTURE(id);
        CHECK_FALSE(isAllowedDuringQuestion(*findCommand(id)));
        app.session.messages().clear();
        runCommand(*findCommand(id), app.context);
        CHECK(app.session.messages().last().find("Answer the question") != std::string::npos);
    }
    for (const char* id : {"view.frame", "layer.labels", "lesson.next", "file.quit", "help.keys"})
        CHECK(isAllowedDuringQuestion(*findCommand(id)));
}

TEST_CASE("In Present the key for the next step shows the answer first") {
    LessonApp app;
    app.ui.layoutPreset = LayoutPreset::Present;
    app.open("lesson:spiral");
    CHECK(app.ui.layoutPreset == LayoutPreset::Present);
    app.goTo(1);
    app.call(&LessonPlayer::next);
    CHECK(app.walk().step() == 1);
    CHECK_FALSE(app.walk().asks());
    app.call(&LessonPlayer::next);
    CHECK(app.walk().step() == 2);
}

TEST_CASE("A step that compares opens the layout Compare, and the next one returns") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(app.walk().lesson().steps.size() - 1);
    CHECK(app.ui.layoutPreset == LayoutPreset::Compare);
    REQUIRE(app.compare.comparison().chosen());
    CHECK(differenceText(app.session.input().spec(), app.compare.comparison().with().run) ==
          "sphere off");
    app.call(&LessonPlayer::previous);
    CHECK(app.ui.layoutPreset == LayoutPreset::Debug);
    CHECK_FALSE(app.compare.comparison().chosen());
}

TEST_CASE("In Present a step that compares shows the second view there") {
    LessonApp app;
    app.ui.layoutPreset = LayoutPreset::Present;
    app.open("lesson:spiral");
    app.goTo(app.walk().lesson().steps.size() - 1);
    CHECK(app.ui.layoutPreset == LayoutPreset::Present);
    CHECK(app.compare.comparison().chosen());
    CHECK(app.ui.compare.isIn(LayoutPreset::Present));
    app.call(&LessonPlayer::previous);
    CHECK(app.ui.layoutPreset == LayoutPreset::Present);
    CHECK_FALSE(app.ui.compare.isIn(LayoutPreset::Present));
    CHECK_FALSE(app.compare.comparison().chosen());
}

TEST_CASE("Letters choose an option of the open question, and Enter answers") {
    LessonApp app;
    app.open("lesson:removal");
    std::size_t step = 0;
    while (app.walk().lesson().steps[step].question == std::nullopt ||
           app.walk().lesson().steps[step].question->kind != "choice")
        ++step;
    app.goTo(step);
    REQUIRE(app.walk().asks());
    const KeyChord enter{key::kEnter, kNoMods};
    CHECK(answerByKey(enter, app.context));
    CHECK(app.walk().state().tries == 0);
    CHECK(app.session.messages().last() == "Give an answer first, or show it.");
    CHECK_FALSE(answerByKey({'Z', kNoMods}, app.context));
    CHECK_FALSE(answerByKey({'B', kCtrl}, app.context));
    CHECK(answerByKey({'B', kNoMods}, app.context));
    CHECK(app.walk().state().given.choice == 1);
    CHECK(answerByKey(enter, app.context));
    CHECK(app.walk().state().tries == 1);
    app.call(&LessonPlayer::showAnswer);
    CHECK_FALSE(answerByKey({'B', kNoMods}, app.context));
}

TEST_CASE("A letter chooses an option that is the name of a point") {
    LessonApp app;
    app.open("lesson:class");
    app.goTo(1);
    REQUIRE(app.walk().question()->kind == "point");
    CHECK(answerByKey({'C', kNoMods}, app.context));
    CHECK(app.walk().chosen() == 2);
    CHECK(app.walk().state().complaint.empty());
    CHECK(app.walk().state().typed == "7");
    CHECK(app.walk().givenPoints().size() == 1);
}

TEST_CASE("A number is typed by keys, and the next one replaces a wrong one") {
    LessonApp app;
    app.open("lesson:removal");
    std::size_t step = 0;
    const auto& steps = app.walk().lesson().steps;
    while (!steps[step].question || steps[step].question->kind != "number") ++step;
    app.goTo(step);
    for (const char digit : {'9', '9', '8'}) CHECK(answerByKey({digit, kNoMods}, app.context));
    CHECK(answerByKey({key::kBackspace, kNoMods}, app.context));
    CHECK(app.walk().state().typed == "99");
    app.call(&LessonPlayer::answer);
    REQUIRE(app.walk().asks());
    CHECK(answerByKey({'7', kNoMods}, app.context));
    CHECK(app.walk().state().typed == "7");
    CHECK_FALSE(answerByKey({'F', kNoMods}, app.context));
}

TEST_CASE("A pivot to practice opens at its beginning, and the next one is another") {
    LessonApp app;
    app.open("practice:7");
    REQUIRE(app.walk().isOpen());
    const teach::PracticeTask task = teach::practiceTask(7);
    CHECK(app.place() == toString(task.address));
    CHECK(app.session.model().points.position == task.points->position);
    CHECK(app.walk().asks());
    CHECK_FALSE(app.ui.lesson.away);
    app.walk().showAnswer();
    app.call(&LessonPlayer::returnToStep);
    CHECK_FALSE(app.ui.lesson.away);
    actions::openPractice(app.context);
    app.settle();
    CHECK(app.walk().source() == "practice:8");
}

TEST_CASE("A lesson opens after something else was open, and a click there closes it at once") {
    LessonApp app;
    app.document.open("scene:torus");
    app.settle();
    app.open("lesson:tour");
    CHECK(app.walk().isOpen());
    app.goTo(1);
    // The horizon of the question does not reach into what is opened next.
    app.open("lesson:spiral");
    app.goTo(1);
    app.document.open("scene:figure-8");
    app.settle();
    CHECK_FALSE(app.walk().isOpen());
    CHECK(app.place() == "9.sphere.2");
}

TEST_CASE("Going on before an input is open shows the last step that was chosen") {
    LessonApp app;
    app.open("lesson:removal");
    std::size_t other = 1;
    while (app.walk().lesson().steps[other].input.empty()) ++other;
    app.goTo(other - 1);
    const std::string before = app.session.model().name;
    for (const std::size_t step : {other, other - 1}) {
        app.lesson.toStep(step);
    }
    app.settle();
    CHECK(app.walk().step() == other - 1);
    CHECK(app.session.model().name == before);
    CHECK_FALSE(app.ui.lesson.away);
}

TEST_CASE("An input of a step that does not open leaves a way back to the step") {
    LessonApp app;
    app.open("lesson:removal");
    std::size_t other = 1;
    while (app.walk().lesson().steps[other].input.empty()) ++other;
    app.lesson.toStep(other);
    app.session.cancelOpening();
    app.settle();
    CHECK(app.ui.lesson.away);
    CHECK_FALSE(app.ui.lesson.hides());
    CHECK_FALSE(app.lesson.moving());
    app.call(&LessonPlayer::returnToStep);
    CHECK_FALSE(app.ui.lesson.away);
}

TEST_CASE("A lesson leaves layers, layout and playback as the user had them") {
    LessonApp app;
    modeOf(app.ui.settings.layers, LayerId::Normals) = LayerMode::PinnedOff;
    const LayerModes layers = app.ui.settings.layers;
    app.playback.setUnit(PlayUnit::Event);
    app.playback.setRate(15.0);
    app.open("practice:3");
    CHECK(app.ui.settings.layers != layers);
    CHECK(app.ui.layoutPreset == LayoutPreset::Debug);
    app.walk().showAnswer();
    app.call(&LessonPlayer::returnToStep);
    CHECK(app.playback.playing());
    app.call(&LessonPlayer::close);
    CHECK(app.ui.settings.layers == layers);
    CHECK(app.ui.layoutPreset == LayoutPreset::Debug);
    CHECK(app.playback.unit() == PlayUnit::Event);
    CHECK(app.playback.rate() == 15.0);
    CHECK_FALSE(app.playback.playing());
}

TEST_CASE("Returning to a step that compares begins its comparison again") {
    LessonApp app;
    app.open("lesson:spiral");
    app.goTo(app.walk().lesson().steps.size() - 1);
    app.compare.stop();
    app.call(&LessonPlayer::returnToStep);
    CHECK(app.compare.comparison().chosen());
    CHECK(app.ui.layoutPreset == LayoutPreset::Compare);
}

TEST_CASE("Play starts at the position of the step, again once it has played") {
    LessonApp app;
    app.open("lesson:tour");
    app.goTo(4);
    for (int i = 0; i < 2; ++i) {
        app.call(&LessonPlayer::play);
        CHECK(app.place() == "200.split.1");
        CHECK(app.playback.playing());
        REQUIRE(app.session.moves().goToText("200.advance.1").ok());
        app.playback.pause();
        app.settle();
    }
}

TEST_CASE("Answers stay when a lesson is read again unchanged, and go to one file") {
    LessonApp app;
    const std::string file = (app.folder / "mine.result.json").string();
    Options options;
    options.lesson = "lesson:spiral";
    options.lessonStep = 1;
    options.resultFile = file;
    app.lesson.begin(options);
    app.settle();
    app.walk().type("3, 4, 5, 6, 7");
    app.call(&LessonPlayer::answer);
    REQUIRE(std::filesystem::exists(file));
    app.open("lesson:spiral");
    CHECK(app.walk().step() == 1);
    CHECK(app.walk().hasAnswers());
    const auto size = std::filesystem::file_size(file);
    app.open("practice:1");
    app.walk().type("next 0");
    app.call(&LessonPlayer::answer);
    CHECK(std::filesystem::file_size(file) == size);
}
