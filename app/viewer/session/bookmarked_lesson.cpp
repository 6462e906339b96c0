#include "bookmarked_lesson.h"

#include <utility>
#include <variant>
#include <vector>

#include "teach/lesson_skeleton.h"
#include "view_position.h"

namespace se::view {

namespace {

/// The input as it stands in a lesson in `folder`.
Result<std::string> inputFrom(const std::filesystem::path& folder, const std::string& source) {
    if (isSample(source) || isStandardInput(source))
        return Error{"A lesson begins with a scene or a file: save the points first."};
    if (isScene(source) || isPractice(source)) return source;
    const std::string input = std::filesystem::proximate(source, folder).generic_string();
    if (!input.starts_with("..")) return input;
    return Error{"The points of a lesson lie in its folder or below it: save it beside " + source +
                 "."};
}

teach::LessonOptions optionsOf(const NeighborOptions& lists) {
    teach::LessonOptions options;
    options.symmetric = lists.symmetric;
    if (!lists.recompute) return options;
    if (const auto* nearest = std::get_if<KNearest>(&lists.reach)) options.neighbors = nearest->k;
    if (const auto* within = std::get_if<WithinRadius>(&lists.reach))
        options.radius = within->radius;
    if (const auto* within = std::get_if<WithinSpacings>(&lists.reach))
        options.reach = within->spacings;
    return options;
}

teach::LessonRules rulesOfLesson(const InputSpec& spec) {
    teach::LessonRules rules;
    if (spec.rules != "paper") rules.set = spec.rules;
    for (const RuleValue& each : spec.choices) rules.rule.push_back(lineOf(each));
    for (const WhatIf& each : spec.whatIf) rules.whatIfs.push_back(lineOf(each));
    return rules;
}

}  // namespace

Result<std::string> lessonOfBookmarks(const InputSpec& spec, const Annotations& annotations,
                                      const std::filesystem::path& folder) {
    const Result<std::string> input = inputFrom(folder, spec.source);
    if (!input) return input.error();
    std::vector<teach::NotedPosition> positions;
    for (const Bookmark& each : annotations.bookmarks)
        positions.push_back({toString(each.address), each.note,
                             each.camera ? toText(ViewPosition{"", each.camera}) : std::string{}});
    return teach::lessonOfNotes(input.value(), optionsOf(spec.neighbors), rulesOfLesson(spec),
                                annotations.notes, positions);
}

}  // namespace se::view
