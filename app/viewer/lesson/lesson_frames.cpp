#include "lesson_frames.h"

#include <algorithm>
#include <array>

#include "document/camera_actions.h"
#include "jobs/open_lesson.h"
#include "session/view_position.h"
#include "teach/embedded_lessons.h"
#include "teach/lesson_read.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

void setMode(LayerModes& layers, const std::vector<std::string>& names, LayerMode mode) {
    for (const Layer& each : view::layers()) {
        if (std::find(names.begin(), names.end(), each.name) != names.end())
            modeOf(layers, each.id) = mode;
    }
}

Result<std::shared_ptr<const LessonFile>> checkedLesson(teach::LessonReading reading,
                                                        const std::string& name,
                                                        const fs::path& folder) {
    if (!reading.ok()) return Error{teach::faultText(reading.faults.front(), name)};
    return std::make_shared<const LessonFile>(LessonFile{std::move(reading.lesson), folder});
}

}  // namespace

Result<std::shared_ptr<const LessonFile>> lessonOfSource(const std::string& source) {
    std::error_code error;
    const bool file = fs::exists(source, error);
    const bool named = source.starts_with(kLessonPrefix);
    const teach::EmbeddedLesson* built =
        teach::findEmbeddedLesson(named ? source.substr(kLessonPrefix.size()) : source);
    if (!file && built != nullptr)
        return checkedLesson(teach::readLesson(built->text, source), source, {});
    if (!source.ends_with(teach::kLessonExtension)) return std::shared_ptr<const LessonFile>();
    Result<teach::LessonReading> reading = teach::readLessonFile(source);
    if (!reading) return reading.error();
    return checkedLesson(std::move(reading.value()), source, fs::path(source).parent_path());
}

std::string stepPlace(const LessonFile& file, std::size_t step, std::string_view key) {
    const teach::LessonStep& each = file.lesson.steps[step];
    const std::size_t line = key.empty() || each.lines.block == 0 ? each.line : each.lines.of(key);
    const std::string text = file.lesson.name + ":" + std::to_string(line) + ": ";
    return key.empty() ? text : text + std::string(key) + ": ";
}

Result<RunSpec> inputOfStep(const LessonFile& file, std::size_t step) {
    return inputOfStep(teach::settingOf(file.lesson, step), file.folder);
}

LayerModes layersOfStep(LayerModes layers, const teach::LessonStep& step) {
    setMode(layers, step.pin, LayerMode::PinnedOn);
    setMode(layers, step.hide, LayerMode::PinnedOff);
    return layers;
}

LayerModes layersWithout(LayerModes layers, const teach::LessonStep& step) {
    setMode(layers, step.pin, LayerMode::Automatic);
    setMode(layers, step.hide, LayerMode::Automatic);
    return layers;
}

Selection selectionOfStep(const teach::LessonStep& step,
                          const std::vector<teach::NamedPoint>& names) {
    std::vector<Index> points;
    points.reserve(step.select.size());
    for (const std::string& word : step.select) points.push_back(teach::pointOf(word, names));
    return Selection::of(points);
}

Status aimAtStep(CommandContext& context, const teach::LessonStep& step,
                 const teach::StepSetting& setting) {
    if (step.camera.empty()) {
        frameStep(context, step.frame == "all", teach::viewDirection(setting));
        return success();
    }
    const Result<ViewPosition> place = viewPositionFromText(step.camera);
    if (!place || !place.value().camera)
        return Error{"expected a position with its address, as Ctrl+C copies it"};
    context.camera.setPose(*place.value().camera);
    return success();
}

}  // namespace se::view
