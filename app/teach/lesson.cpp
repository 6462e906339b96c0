#include "lesson.h"

#include <algorithm>
#include <numeric>

namespace se::teach {

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

}  // namespace se::teach
