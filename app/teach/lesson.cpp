#include "lesson.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/scenes/figures.h"

namespace se::teach {
namespace {

/// The id of the scene that an input is; empty if it is none.
std::string_view sceneOf(std::string_view input) {
    return isScene(input) ? input.substr(kScenePrefix.size()) : std::string_view{};
}

/// Opens an input: names are those given with it, or of the figure.
void openInput(StepSetting& setting, const std::string& input,
               const std::vector<PointName>& names) {
    setting.input = input;
    setting.names = names;
    if (const Figure* figure = figureOfScene(sceneOf(input)); figure != nullptr && names.empty())
        setting.names = figure->pointNames();
    const std::string_view address = addressOfScene(sceneOf(input));
    setting.at = address.empty() ? "0" : address;
}

/// Rules of a step in addition to those of the lesson; a set replaces them.
SpecChange added(SpecChange rules, const SpecChange& step) {
    if (!textOf(step, "rules").empty()) rules.clear();
    rules.insert(rules.end(), step.begin(), step.end());
    return rules;
}

}  // namespace

std::string faultText(const LessonFault& fault, std::string_view name) {
    std::string text(name);
    if (fault.line > 0) text += ":" + std::to_string(fault.line);
    text += ": ";
    if (!fault.key.empty()) text += fault.key + ": ";
    return text + fault.message;
}

std::size_t KeyLines::of(std::string_view key) const {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const auto& each) { return each.first == key; });
    return found == keys.end() ? block : found->second;
}

double Lesson::minutes() const {
    return std::accumulate(steps.begin(), steps.end(), 0.0,
                           [](double sum, const LessonStep& step) { return sum + step.minutes; });
}

std::size_t Lesson::questions() const {
    return static_cast<std::size_t>(
        std::count_if(steps.begin(), steps.end(),
                      [](const LessonStep& step) { return step.question.has_value(); }));
}

const std::vector<LessonView>& lessonViews() {
    static const std::vector<LessonView> views{
        {"front", {0.0, -1.0, 0.0}}, {"back", {0.0, 1.0, 0.0}}, {"left", {-1.0, 0.0, 0.0}},
        {"right", {1.0, 0.0, 0.0}},  {"top", {0.0, 0.0, 1.0}},  {"bottom", {0.0, 0.0, -1.0}},
    };
    return views;
}

StepSetting settingOf(const Lesson& lesson, std::size_t step) {
    assert(step < lesson.steps.size());
    StepSetting setting;
    setting.view = lesson.view;
    openInput(setting, lesson.input, lesson.names);
    for (std::size_t i = 0; i <= step; ++i) {
        const LessonStep& each = lesson.steps[i];
        if (!setting.answerPlace.empty()) setting.at = setting.answerPlace;
        if (!each.input.empty()) openInput(setting, each.input, each.names);
        if (!each.input.empty()) setting.view.clear();
        setting.run = added(lesson.rules, each.rules);
        if (!each.view.empty()) setting.view = each.view;
        if (!each.at.empty()) setting.at = each.at;
        setting.answerPlace = each.until;
        if (!each.question) continue;
        if (!each.question->at.empty()) setting.at = each.question->at;
        setting.answerPlace = each.question->until;
    }
    setting.run.insert(setting.run.end(), lesson.options.begin(), lesson.options.end());
    std::stable_sort(setting.run.begin(), setting.run.end(),
                     [](const FieldValue& a, const FieldValue& b) { return a.field < b.field; });
    return setting;
}

std::optional<Vec3> viewDirection(const StepSetting& setting) {
    if (const LessonView* view = findNamed(lessonViews(), setting.view)) return view->toEye;
    const Figure* figure = figureOfScene(sceneOf(setting.input));
    return figure != nullptr ? std::optional(figure->view) : std::nullopt;
}

Result<RunSpec> runSpec(const StepSetting& setting) {
    RunSpec spec;
    spec.source = setting.input;
    const Status valid = applyChange(setting.run, spec);
    return valid ? Result<RunSpec>(std::move(spec)) : valid.error();
}

Index pointOf(std::string_view word, const std::vector<PointName>& names) {
    if (const PointName* found = findNamed(names, word)) return found->point;
    return numberIn<Index>(word).value_or(kNone);
}

std::string absentPointText(const std::string& word, std::size_t count) {
    return word + ": there are " + std::to_string(count) + " points, from 0";
}

std::vector<std::string> namesOf(const std::vector<Index>& points,
                                 const std::vector<PointName>& names) {
    std::vector<std::string> words;
    words.reserve(points.size());
    for (const Index point : points) words.push_back(nameOf(point, names));
    return words;
}

std::string pointsText(const std::vector<Index>& points, const std::vector<PointName>& names) {
    return points.empty() ? "none" : wordList(namesOf(points, names), "");
}

}  // namespace se::teach
