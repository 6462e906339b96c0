#include "lesson_setting.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/scenes/figures.h"

namespace se::teach {
namespace {

constexpr std::string_view kSceneWord = "scene:";

/// The figure that an input is of; null if it is of none.
const Figure* figureOf(std::string_view input) {
    return input.starts_with(kSceneWord) ? figureOfScene(input.substr(kSceneWord.size())) : nullptr;
}

/// The names of the figure that an input is of; empty if it is of none.
std::vector<NamedPoint> figureNames(std::string_view input) {
    std::vector<NamedPoint> names;
    const Figure* figure = figureOf(input);
    if (figure == nullptr) return names;
    for (const PointName& each : figure->names)
        names.push_back({std::string(each.name), each.point});
    return names;
}

std::string firstPlace(std::string_view input) {
    const std::string_view address =
        input.starts_with(kSceneWord) ? addressOfScene(input.substr(kSceneWord.size())) : "";
    return address.empty() ? "0" : std::string(address);
}

/// Opens an input: names are those given with it, or of the figure.
void openInput(StepSetting& setting, const std::string& input,
               const std::vector<NamedPoint>& names) {
    setting.input = input;
    setting.names = names.empty() ? figureNames(input) : names;
    setting.at = firstPlace(input);
}

/// Rules of a step in addition to those of the lesson; a set replaces them.
LessonRules added(LessonRules rules, const LessonRules& step) {
    if (!step.set.empty()) rules = {};
    if (!step.set.empty()) rules.set = step.set;
    rules.rule.insert(rules.rule.end(), step.rule.begin(), step.rule.end());
    rules.whatIfs.insert(rules.whatIfs.end(), step.whatIfs.begin(), step.whatIfs.end());
    return rules;
}

// ---- words of another run ----

Status setRules(RunSettings& settings, const std::string& value) {
    if (!paramsByName(value)) return Error{"--rules " + excerpt(value) + ": no such set of rules"};
    settings.rules = value;
    settings.choices.clear();
    return success();
}
Status setRule(RunSettings& settings, const std::string& value) {
    const Result<RuleValue> rule = ruleValueFromText(value);
    if (!rule) return Error{"--rule " + excerpt(value) + ": " + rule.error().message};
    settings.choices.push_back(rule.value());
    return success();
}
Status setWhatIf(RunSettings& settings, const std::string& value) {
    const Result<WhatIf> whatIf = whatIfFromText(value);
    if (!whatIf) return Error{"--what-if: " + whatIf.error().message};
    settings.whatIf.push_back(whatIf.value());
    return success();
}
Status setNeighbors(RunSettings& settings, const std::string& value) {
    const auto count = numberIn<std::uint32_t>(value);
    if (!count || *count == 0) return Error{"--neighbors: expected a whole number from 1 on"};
    settings.prepare.neighbors.reach = KNearest{*count};
    settings.prepare.neighbors.recompute = true;
    return success();
}
Status setReach(RunSettings& settings, const std::string& value) {
    const auto reach = numberIn<double>(value);
    if (!reach || !(*reach > 0.0)) return Error{"--reach: expected a number above 0"};
    settings.prepare.neighbors.reach = WithinSpacings{*reach};
    settings.prepare.neighbors.recompute = true;
    return success();
}

/// An option of another run: a new one is a function and a row.
struct ComparedOption {
    std::string_view word;
    Status (*set)(RunSettings&, const std::string& value);
};
constexpr std::array kComparedOptions{
    ComparedOption{"--rules", setRules},    ComparedOption{"--rule", setRule},
    ComparedOption{"--what-if", setWhatIf}, ComparedOption{"--neighbors", setNeighbors},
    ComparedOption{"-k", setNeighbors},     ComparedOption{"--reach", setReach},
};

void applyOptions(const LessonOptions& options, NeighborOptions& lists) {
    if (options.neighbors > 0) lists.reach = KNearest{options.neighbors};
    if (options.radius > 0.0) lists.reach = WithinRadius{options.radius};
    if (options.reach > 0.0) lists.reach = WithinSpacings{options.reach};
    lists.symmetric = options.symmetric;
    lists.recompute = options.neighbors > 0 || options.radius > 0.0 || options.reach > 0.0;
}

}  // namespace

StepSetting settingOf(const Lesson& lesson, std::size_t step) {
    assert(step < lesson.steps.size());
    StepSetting setting;
    setting.options = lesson.options;
    setting.view = lesson.view;
    openInput(setting, lesson.input, lesson.names);
    for (std::size_t i = 0; i <= step; ++i) {
        const LessonStep& each = lesson.steps[i];
        if (!setting.answerPlace.empty()) setting.at = setting.answerPlace;
        if (!each.input.empty()) openInput(setting, each.input, each.names);
        if (!each.input.empty()) setting.view.clear();
        setting.rules = added(lesson.rules, each.rules);
        if (!each.view.empty()) setting.view = each.view;
        if (!each.at.empty()) setting.at = each.at;
        setting.answerPlace = each.until;
        if (!each.question) continue;
        if (!each.question->at.empty()) setting.at = each.question->at;
        setting.answerPlace = each.question->until;
    }
    return setting;
}

std::optional<Vec3> viewDirection(const StepSetting& setting) {
    for (const LessonView& each : lessonViews()) {
        if (each.name == setting.view) return each.toEye;
    }
    const Figure* figure = figureOf(setting.input);
    return figure != nullptr ? std::optional(figure->view) : std::nullopt;
}

Result<RunSettings> runSettings(const StepSetting& setting) {
    RunSettings settings;
    std::vector<std::string> words;
    if (!setting.rules.set.empty()) words = {"--rules", setting.rules.set};
    for (const std::string& each : setting.rules.rule) words.insert(words.end(), {"--rule", each});
    for (const std::string& each : setting.rules.whatIfs)
        words.insert(words.end(), {"--what-if", each});
    applyOptions(setting.options, settings.prepare.neighbors);
    return comparedSettings(std::move(settings), words);
}

Result<RunSettings> comparedSettings(RunSettings settings, const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const auto option =
            std::find_if(kComparedOptions.begin(), kComparedOptions.end(),
                         [&](const ComparedOption& each) { return each.word == words[i]; });
        if (option == kComparedOptions.end())
            return Error{excerpt(words[i]) +
                         ": expected --rules, --rule, --what-if, --neighbors or --reach"};
        if (i + 1 == words.size()) return Error{excerpt(words[i]) + ": its value is missing"};
        const Status set = option->set(settings, words[i + 1]);
        if (!set) return set.error();
    }
    return settings;
}

std::vector<PointName> pointNames(const std::vector<NamedPoint>& names) {
    std::vector<PointName> list;
    list.reserve(names.size());
    for (const NamedPoint& each : names) list.push_back({each.point, each.name});
    return list;
}

Index pointOf(std::string_view word, const std::vector<NamedPoint>& names) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const NamedPoint& each) { return each.name == word; });
    if (found != names.end()) return found->point;
    return numberIn<Index>(word).value_or(kNone);
}

std::string pointsText(const std::vector<Index>& points, const std::vector<NamedPoint>& names) {
    const std::vector<PointName> list = pointNames(names);
    std::string text;
    for (const Index point : points) text += (text.empty() ? "" : ", ") + nameOf(point, list);
    return text.empty() ? "none" : text;
}

}  // namespace se::teach
