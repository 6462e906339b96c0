#include "open_lesson.h"

#include <utility>

#include "run/packed_file.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/sampling/gzip.h"
#include "teach/embedded_lessons.h"
#include "teach/lesson_check.h"
#include "teach/lesson_read.h"
#include "teach/lesson_text.h"
#include "teach/practice.h"

namespace se::view {

namespace {

Result<teach::LessonReading> readingOf(const std::string& source) {
    if (const auto seed = teach::practiceSeed(source))
        return teach::readLesson(teach::practiceLesson(*seed), source);
    if (isLessonFile(source)) return teach::readLessonFile(source);
    if (isPacked(source)) {
        const Result<PackedFile> file = unpackedFile(source);
        if (!file) return file.error();
        teach::LessonReading reading = teach::readLesson(file.value().bytes, file.value().name);
        if (const std::string input = fileOfLesson(reading.lesson); !input.empty())
            return Error{file.value().name + ": a lesson inside a link has scenes alone, not " +
                         inQuotes(input) + "."};
        return reading;
    }
    const std::string id = source.substr(kLessonPrefix.size());
    const teach::EmbeddedLesson* lesson = teach::findEmbeddedLesson(id);
    if (lesson == nullptr)
        return Error{source + ": no such lesson; spiraling-edge lesson list shows all."};
    return teach::readLesson(lesson->text, id + std::string(teach::kLessonExtension));
}

/// The first fault, and the number of the others.
Error faultsError(const std::vector<teach::LessonFault>& faults, const std::string& name) {
    std::string text = teach::faultText(faults.front(), name);
    if (faults.size() > 1) text += " (and " + std::to_string(faults.size() - 1) + " more)";
    return Error{text};
}

LessonEntry entryOf(const teach::EmbeddedLesson& embedded) {
    const teach::Lesson lesson = teach::readLesson(embedded.text, std::string(embedded.id)).lesson;
    LessonEntry entry{
        embeddedLessonSource(embedded.id), lesson.title, {}, lesson.minutes(), lesson.input, {}};
    const auto blocks = teach::textBlocks(lesson.text);
    if (!blocks.empty()) entry.text = teach::plainTextOf({blocks.front()});
    for (const teach::LessonStep& step : lesson.steps) {
        if (entry.at.empty() && !step.at.empty()) entry.at = step.at;
    }
    return entry;
}

}  // namespace

const std::vector<LessonEntry>& lessonEntries() {
    static const std::vector<LessonEntry> entries = [] {
        std::vector<LessonEntry> list;
        for (const teach::EmbeddedLesson& each : teach::embeddedLessons())
            list.push_back(entryOf(each));
        return list;
    }();
    return entries;
}

bool isLessonFile(std::string_view source) {
    return !source.starts_with(kLessonPrefix) && !isPacked(source) &&
           source.ends_with(teach::kLessonExtension);
}

bool isLesson(std::string_view source) {
    return source.starts_with(kLessonPrefix) || teach::practiceSeed(source) ||
           isLessonFile(source) || packedName(source).ends_with(teach::kLessonExtension);
}

std::string fileOfLesson(const teach::Lesson& lesson) {
    const auto isFile = [](const std::string& input) {
        return !input.empty() && !isScene(input) && !teach::practiceSeed(input);
    };
    if (isFile(lesson.input)) return lesson.input;
    for (const teach::LessonStep& step : lesson.steps) {
        if (isFile(step.input)) return step.input;
    }
    return {};
}

Result<SharedLesson> openLesson(const std::string& source, const Progress& progress) {
    const Error cancelled{"Cancelled."};
    Result<teach::LessonReading> reading = readingOf(source);
    if (!reading) return reading.error();
    teach::Lesson& lesson = reading.value().lesson;
    const std::string name = lesson.name;
    if (!reading.value().ok()) return faultsError(reading.value().faults, name);
    OpenedLesson opened;
    opened.source = source;
    if (isLessonFile(source)) opened.folder = std::filesystem::path(source).parent_path();
    teach::LessonRuns runs(opened.folder, {}, unpackGzip);
    if (!progress(0.1)) return cancelled;
    const std::vector<teach::LessonFault> faults = teach::checkLesson(lesson, runs);
    if (!faults.empty()) return faultsError(faults, name);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        if (!progress(0.5 +
                      0.5 * static_cast<double>(i) / static_cast<double>(lesson.steps.size())))
            return cancelled;
        opened.right.emplace_back();
        if (!lesson.steps[i].question) continue;
        Result<teach::RightAnswer> right = teach::rightAnswer(lesson, i, runs);
        if (!right) return right.error();
        opened.right.back() = std::move(right.value());
    }
    opened.lesson = std::move(lesson);
    return std::make_shared<const OpenedLesson>(std::move(opened));
}

Result<SharedLesson> lessonOfSource(const std::string& source) {
    std::error_code error;
    const bool isId =
        teach::findEmbeddedLesson(source) != nullptr && !std::filesystem::exists(source, error);
    const std::string named = isId ? embeddedLessonSource(source) : source;
    if (!isLesson(named) || teach::practiceSeed(named)) return SharedLesson();
    return openLesson(named, [](double) { return true; });
}

Result<RunSpec> inputOfStep(const teach::StepSetting& setting,
                            const std::filesystem::path& folder) {
    const Result<std::string> source =
        teach::pointsSource(teach::lessonSource(setting.input, folder));
    if (!source) return source.error();
    Result<RunSpec> spec = teach::runSpec(setting);
    if (!spec) return spec;
    spec.value().source = source.value();
    return spec;
}

}  // namespace se::view
