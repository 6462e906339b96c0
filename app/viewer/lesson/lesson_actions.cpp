#include "lesson_actions.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "document/actions.h"
#include "document/document.h"
#include "lesson_player.h"
#include "teach/practice.h"

namespace se::view {

bool isAllowedDuringQuestion(const Command& command) {
    constexpr std::array<std::string_view, 3> kGroups = {"View", "Layers", "Help"};
    constexpr std::array<std::string_view, 13> kOthers = {
        "file.open",           "file.screenshot", "file.quit",           "step.pivot.next",
        "step.pivot.previous", "step.event.next", "step.event.previous", "step.pivot.finish",
        "run.start",           "lesson.next",     "lesson.previous",     "lesson.return",
        "lesson.close"};
    const auto among = [](const auto& list, std::string_view word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    if (command.id == "view.layout.compare") return false;
    return among(kGroups, command.group) || among(kOthers, command.id);
}

namespace {

/// Adds a sign to the number that is the answer. One that was wrong is replaced by the next.
bool typeNumber(int key, LessonWalk& walk) {
    const bool sign = (key >= '0' && key <= '9') || key == '.' || key == '-';
    if (!sign && key != key::kBackspace) return false;
    std::string typed = walk.state().grade ? std::string{} : walk.state().typed;
    if (sign)
        typed += static_cast<char>(key);
    else if (!typed.empty())
        typed.pop_back();
    walk.type(std::move(typed));
    return true;
}

}  // namespace

bool answerByKey(const KeyChord& chord, CommandContext& context) {
    LessonPanel& panel = context.ui.lesson;
    if (chord.mods != kNoMods || !panel.hides() || panel.countsHands) return false;
    LessonWalk& walk = panel.walk;
    if (chord.key == key::kEnter || chord.key == key::kKeypadEnter) {
        if (walk.state().given == teach::Answer{})
            context.session.messages().say("Give an answer first, or show it.");
        else
            context.lesson.answer();
        return true;
    }
    if (walk.question()->kind == "number") return typeNumber(chord.key, walk);
    const std::size_t count = walk.question()->options.size();
    const auto option = static_cast<std::size_t>(chord.key - 'A');
    if (chord.key < 'A' || option >= count) return false;
    walk.choose(option);
    return true;
}

namespace actions {

void openTour(CommandContext& c) { c.document.open(embeddedLessonSource("tour")); }

void openPractice(CommandContext& c) {
    c.document.open(std::string(teach::kPracticePrefix) + std::to_string(c.ui.lesson.nextPractice));
}

void returnToLessonStep(CommandContext& c) {
    if (c.lesson.requireLesson()) c.lesson.returnToStep();
}

void closeLesson(CommandContext& c) {
    if (c.lesson.requireLesson()) c.lesson.close();
}

void saveResult(CommandContext& c) {
    if (!c.lesson.requireLesson()) return;
    if (!c.ui.lesson.walk.hasAnswers())
        return c.session.messages().say("No question of this lesson has been answered yet.");
    openBrowser(c, BrowserTask::SaveResult);
}

void saveLesson(CommandContext& c) {
    if (!c.session.ready()) return c.session.messages().say("There is nothing open to save.");
    if (c.ui.bookmarks.empty())
        return c.session.messages().say(
            "Set bookmarks first (Ctrl+B): each becomes a step of the lesson.");
    openBrowser(c, BrowserTask::SaveLesson);
}

}  // namespace actions

}  // namespace se::view
