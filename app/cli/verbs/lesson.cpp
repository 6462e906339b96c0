// spiraling-edge lesson: lists, prints, checks and begins lessons, and sums up results.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "input.h"
#include "output/sentences.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/gzip.h"
#include "teach/embedded_lessons.h"
#include "teach/lesson_check.h"
#include "teach/lesson_read.h"
#include "teach/lesson_runs.h"
#include "teach/lesson_skeleton.h"
#include "teach/lesson_text.h"
#include "teach/practice.h"
#include "teach/result.h"
#include "verbs.h"

namespace se::cli {
namespace {

namespace fs = std::filesystem;
using teach::Lesson;
using teach::LessonFault;
using teach::LessonReading;
using teach::LessonRuns;
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

/// "5 steps, 1 question".
std::string contentText(const Lesson& lesson) {
    return counted(lesson.steps.size(), "step") + ", " + counted(lesson.questions(), "question");
}

/// True if the viewer's options name the runs of a step without the lesson: the input is a scene or
/// a file of points, and no word of `compare` has a blank, at which the text of --with is split.
bool isNamedByOptions(const teach::StepSetting& setting, const LessonStep& step) {
    return !teach::practiceSeed(setting.input) &&
           !setting.input.ends_with(teach::kLessonExtension) &&
           io::wordsIn(joined(step.compare, " ")).size() == step.compare.size();
}

/// The words by which the viewer opens the run of a step at its position, and the other run beside
/// it. Requires a lesson without faults.
std::string placeLine(const Lesson& lesson, std::size_t number) {
    const teach::StepSetting setting = teach::settingOf(lesson, number);
    const LessonStep& step = lesson.steps[number];
    if (!isNamedByOptions(setting, step)) {
        const bool isBuiltIn = teach::findEmbeddedLesson(lesson.name) != nullptr;
        return fmt::format("   {}{} --step {}\n", isBuiltIn ? "lesson:" : "",
                           shellPath(lesson.name), number + 1);
    }
    const fs::path folder = fs::path(lesson.name).parent_path();
    std::string line = "   " + shellPath(teach::lessonSource(setting.input, folder));
    for (const std::string& option : optionsOf(valuesOf(teach::runSpec(setting).value())))
        line += " " + option;
    line += " --goto " + shellQuoted(setting.at);
    if (!step.compare.empty()) line += " --with " + shellQuoted(joined(step.compare, " "));
    return line + "\n";
}

std::string questionText(const Question& question) {
    std::string text =
        fmt::format("   Question: {}\n", teach::findQuestionKind(question.kind)->task);
    for (std::size_t i = 0; i < question.options.size(); ++i)
        text += fmt::format("     {}  {}\n", teach::optionLetter(i), question.options[i]);
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

/// Steps with minutes, text and questions; with the answers if there are runs to find them by.
/// Throws Failure(Input) if one of them cannot be found.
std::string lessonPage(const Lesson& lesson, LessonRuns* runs) {
    std::string page = fmt::format("{}\n{}, {}\n", lesson.title, minutesText(lesson.minutes()),
                                   contentText(lesson));
    page += wrappedLines(teach::plainTextOf(teach::textBlocks(lesson.text)), "");
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        page += stepText(lesson, i);
        const std::optional<Question>& question = lesson.steps[i].question;
        if (!question || runs == nullptr) continue;
        const std::string place = fmt::format("{}:{}: ", lesson.name, question->lines.block);
        const RightAnswer right =
            require(teach::rightAnswer(lesson, i, *runs), ExitCode::Input, place);
        page += wrappedLines("Answer: " + right.text, "   ") + wrappedLines(right.reason, "     ");
    }
    return page;
}

struct LessonArguments {
    std::string action;
    std::vector<std::string> names;
    std::string output;
    bool answers = false;
    bool json = false;
    ForceOption force;
    ByteLimit limit;
};

/// A lesson, its faults by reading, and the folder of its inputs.
struct OpenedLesson {
    LessonReading reading;
    fs::path folder;
};

/// Opens a lesson by its id or its file. Throws Failure(Input) if there is none.
OpenedLesson openLesson(const std::string& name) {
    if (const teach::EmbeddedLesson* built = teach::findEmbeddedLesson(name))
        return {teach::readLesson(built->text, name), {}};
    std::error_code ignored;
    if (!fs::exists(name, ignored)) {
        throw Failure(ExitCode::Input,
                      "{}: no such lesson or file; `spiraling-edge lesson list` lists them", name);
    }
    return {require(teach::readLessonFile(name), ExitCode::Input), fs::path(name).parent_path()};
}

/// The one name of an action. Throws Failure(Usage) otherwise.
const std::string& theName(const LessonArguments& arguments, const std::string& what) {
    if (arguments.names.size() == 1) return arguments.names.front();
    refuse("lesson {}: expected {}", arguments.action, what);
}

ExitCode listLessons(const LessonArguments& arguments) {
    if (!arguments.names.empty()) refuse("lesson list: takes no names");
    Answer answer{"", Json::array()};
    for (const teach::EmbeddedLesson& each : teach::embeddedLessons()) {
        const Lesson lesson = teach::readLesson(each.text, std::string(each.id)).lesson;
        answer.json.push_back({{"id", each.id},
                               {"title", lesson.title},
                               {"minutes", lesson.minutes()},
                               {"steps", lesson.steps.size()},
                               {"questions", lesson.questions()}});
        answer.text += fmt::format("{:<17} {:>4} min  {:>2} questions  {}\n", each.id,
                                   lesson.minutes(), lesson.questions(), lesson.title);
    }
    print(answer, arguments.json);
    return ExitCode::Good;
}

ExitCode showLesson(const LessonArguments& arguments) {
    const OpenedLesson opened = openLesson(theName(arguments, "the id or the file of a lesson"));
    const LessonReading& reading = opened.reading;
    if (!reading.ok()) {
        throw Failure(ExitCode::Input,
                      teach::faultText(reading.faults.front(), reading.lesson.name));
    }
    LessonRuns runs(opened.folder, arguments.limit, unpackGzip);
    printText(lessonPage(reading.lesson, arguments.answers ? &runs : nullptr));
    return ExitCode::Good;
}

Json faultJson(const LessonFault& fault, const std::string& name) {
    const bool malformed = fault.sort == teach::FaultSort::Malformed;
    return {{"file", name},
            {"line", fault.line},
            {"key", fault.key},
            {"sort", malformed ? "malformed" : "disagrees"},
            {"message", fault.message}};
}

ExitCode checkLessons(const LessonArguments& arguments) {
    if (arguments.names.empty()) refuse("lesson check: expected ids or files of lessons");
    Answer answer{"", Json::array()};
    ExitCode code = ExitCode::Good;
    for (const std::string& name : arguments.names) {
        const OpenedLesson opened = openLesson(name);
        std::vector<LessonFault> faults = opened.reading.faults;
        LessonRuns runs(opened.folder, arguments.limit, unpackGzip);
        if (faults.empty()) faults = teach::checkLesson(opened.reading.lesson, runs);
        for (const LessonFault& fault : faults) {
            answer.text += printable(teach::faultText(fault, name)) + "\n";
            answer.json.push_back(faultJson(fault, name));
        }
        if (teach::isMalformed(faults)) code = ExitCode::Input;
        if (!faults.empty() && code == ExitCode::Good) code = ExitCode::CheckFailed;
        if (!faults.empty()) continue;
        const Lesson& lesson = opened.reading.lesson;
        answer.text += fmt::format("{}: good: {}, {}\n", printable(name), contentText(lesson),
                                   minutesText(lesson.minutes()));
    }
    print(answer, arguments.json);
    return code;
}

/// The input as it stands in a lesson at `output`. Throws Failure(Usage) if it would leave the
/// folder.
std::string inputForLesson(const std::string& input, const std::string& output) {
    if (input.starts_with("scene:") || output == "-") return input;
    const fs::path folder = fs::absolute(output).parent_path();
    const fs::path path = fs::absolute(input).lexically_relative(folder);
    if (!path.empty() && *path.begin() != "..") return path.string();
    refuse("{}: not in the folder of {}; a lesson lies beside its inputs", input, output);
}

ExitCode newLesson(const LessonArguments& arguments) {
    const std::string& input = theName(arguments, "an input: a file with points, or scene:ID");
    if (input == kStandardInput)
        refuse("lesson new: standard input cannot be read again; name a file");
    const std::string output = arguments.output.empty() ? "-" : arguments.output;
    arguments.force.require({{"", input}}, {{"-o", output}});
    const std::string written = inputForLesson(input, output);
    const teach::PreparedRun run =
        require(teach::prepareRun(readInput(input, arguments.limit), input, {}), ExitCode::Input);
    writeOutput(output, require(teach::lessonSkeleton(written, run), ExitCode::Input));
    return ExitCode::Good;
}

ExitCode sumUpResults(const LessonArguments& arguments) {
    if (arguments.names.empty()) refuse("lesson results: expected files *.result.json");
    NamedFiles inputs;
    for (const std::string& name : arguments.names) inputs.push_back({"", name});
    arguments.force.require(std::move(inputs), {{"-o", arguments.output}});
    std::vector<teach::LessonResult> results;
    for (const std::string& name : arguments.names) {
        const std::string bytes = require(readBytes(name, kTextLimit), ExitCode::Input);
        results.push_back(require(teach::resultFromJson(bytes, name), ExitCode::Input));
    }
    const std::vector<teach::QuestionSummary> rows = teach::summarize(results);
    if (arguments.output != "-") printText(teach::summaryText(rows));
    if (!arguments.output.empty())
        writeOutput(arguments.output, printableLines(teach::summaryCsv(rows)));
    return ExitCode::Good;
}

/// An action of the verb: a new one is a function and a row.
struct LessonAction {
    std::string_view name;
    ExitCode (*run)(const LessonArguments&);
};
constexpr std::array kLessonActions{
    LessonAction{"list", listLessons},     LessonAction{"show", showLesson},
    LessonAction{"check", checkLessons},   LessonAction{"new", newLesson},
    LessonAction{"results", sumUpResults},
};

void addLessonOptions(CLI::App& app, LessonArguments& arguments) {
    app.add_option("ACTION", arguments.action, "list, show, check, new or results")->required();
    app.add_option("NAME", arguments.names,
                   "Ids of lessons, files .lesson.md or .result.json; of new: an input");
    app.add_flag("--answers", arguments.answers, "With show: the answers too, found by running it");
    app.add_flag("--json", arguments.json, "With list and check: as JSON");
    addByteLimit(app, arguments.limit);
    addOutputOption(app, "-o,--output", "TEXT", arguments.output,
                    "With new: write the lesson to this file; with results: the table as CSV");
    arguments.force.addTo(app);
}

}  // namespace

ExitCode lessonVerb(CLI::App& app, const Arguments& words) {
    LessonArguments arguments;
    addLessonOptions(app, arguments);
    if (const auto code = parseArguments(app, words)) return *code;
    const LessonAction* action = findNamed(kLessonActions, arguments.action);
    if (action == nullptr) {
        refuse("{}: expected list, show, check, new or results; see spiraling-edge lesson --help",
               arguments.action);
    }
    return action->run(arguments);
}

}  // namespace se::cli
