#include "lesson_page.h"

#include <fmt/format.h>

#include <optional>

#include "spiraling_edge/base/shell_word.h"
#include "teach/lesson_text.h"

namespace se::cli {
namespace {

using teach::Lesson;
using teach::LessonStep;
using teach::Question;
using teach::RightAnswer;

constexpr std::size_t kPageWidth = 96;

/// Text broken between words, each line indented.
std::string wrappedLines(std::string_view text, const std::string& indent) {
    std::string page, line;
    const auto endLine = [&] {
        if (!line.empty()) page += indent + line + "\n";
        line.clear();
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
        const std::string word(text.substr(0, end));
        if (!line.empty() && indent.size() + line.size() + word.size() + 1 > kPageWidth) endLine();
        if (!word.empty()) line += (line.empty() ? "" : " ") + word;
        if (end < text.size() && text[end] == '\n') endLine();
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    endLine();
    return page;
}

std::string minutesText(double minutes) {
    return fmt::format("{} {}", minutes, minutes == 1.0 ? "minute" : "minutes");
}

std::string placeLine(const Lesson& lesson, std::size_t number) {
    const teach::StepSetting setting = teach::settingOf(lesson, number);
    const LessonStep& step = lesson.steps[number];
    std::string line =
        fmt::format("   {} --goto {}", shellPath(setting.input), shellQuoted(setting.at));
    if (!step.compare.empty()) line += " --with";
    for (const std::string& word : step.compare) line += " " + shellQuoted(word);
    return line + "\n";
}

std::string questionText(const Question& question) {
    std::string text =
        fmt::format("   Question: {}\n", teach::findQuestionKind(question.kind)->task);
    for (std::size_t i = 0; i < question.options.size(); ++i)
        text += fmt::format("     {}  {}\n", teach::optionLetter(i), question.options[i]);
    return text;
}

std::string answerText(const RightAnswer& right) {
    std::string text = wrappedLines("Answer: " + right.text, "   ");
    if (!right.reason.empty()) text += wrappedLines(right.reason, "     ");
    return text;
}

std::string stepText(const Lesson& lesson, std::size_t number) {
    const LessonStep& step = lesson.steps[number];
    std::string text =
        fmt::format("\n{}. {} ({})\n", number + 1, step.title, minutesText(step.minutes));
    text += placeLine(lesson, number);
    text += wrappedLines(teach::plainTextOf(teach::textBlocks(step.text)), "   ");
    if (step.question) text += questionText(*step.question);
    return text;
}

std::string headText(const Lesson& lesson) {
    const std::size_t questions = lesson.questions();
    return fmt::format("{}\n{}, {} steps, {} {}\n", lesson.title, minutesText(lesson.minutes()),
                       lesson.steps.size(), questions, questions == 1 ? "question" : "questions") +
           wrappedLines(teach::plainTextOf(teach::textBlocks(lesson.text)), "");
}

}  // namespace

std::string lessonPage(const Lesson& lesson) {
    std::string page = headText(lesson);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) page += stepText(lesson, i);
    return page;
}

Result<std::string> lessonPageWithAnswers(const Lesson& lesson, teach::LessonRuns& runs) {
    std::string page = headText(lesson);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        page += stepText(lesson, i);
        const std::optional<Question>& question = lesson.steps[i].question;
        if (!question) continue;
        const Result<RightAnswer> right = teach::rightAnswer(lesson, i, runs);
        if (!right) {
            return Error{fmt::format("{}:{}: {}", lesson.name, question->lines.block,
                                     right.error().message)};
        }
        page += answerText(right.value());
    }
    return page;
}

}  // namespace se::cli
