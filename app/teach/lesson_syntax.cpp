#include "lesson_syntax.h"

#include <algorithm>
#include <array>
#include <set>

#include "json_text.h"
#include "lesson_setting.h"
#include "question.h"
#include "run_answers.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/stepper/event.h"

namespace se::teach {
namespace {

/// Faults of one block, by the lines of its keys.
class BlockFaults {
  public:
    BlockFaults(const KeyLines& lines, std::vector<LessonFault>& faults)
        : lines_(lines), faults_(faults) {}
    void add(std::string_view key, std::string message) {
        faults_.push_back(
            {FaultSort::Malformed, lines_.of(key), std::string(key), std::move(message)});
    }
    void place(std::string_view key, std::string_view text) {
        if (text.empty() || isPlaceText(text)) return;
        add(key, "expected PIVOT[.STAGE[.N]], such as 9.sphere.2, or a share such as 50%");
    }
    /// Reports a value that is none of `names`.
    template <typename Names>
    void oneOf(std::string_view key, std::string_view value, const Names& names) {
        if (value.empty() || std::find(names.begin(), names.end(), value) != names.end()) return;
        add(key, "expected one of " + wordList(names, ""));
    }
    void view(std::string_view value) {
        std::vector<std::string_view> names;
        for (const LessonView& each : lessonViews()) names.push_back(each.name);
        oneOf("view", value, names);
    }
    void names(const std::vector<NamedPoint>& names) {
        for (const NamedPoint& each : names) {
            const bool isWord = !each.name.empty() && each.name.size() <= 16 &&
                                each.name.find_first_of(" ,\t\n") == std::string::npos;
            if (!isWord) add("names", "a name is a short word, not " + inQuotes(each.name));
        }
    }

  private:
    const KeyLines& lines_;
    std::vector<LessonFault>& faults_;
};

constexpr std::size_t kMostOptions = 4;

std::size_t leastOptions(const Question& question) { return question.kind == "choice" ? 2 : 0; }

void checkOptions(const Question& question, BlockFaults& faults) {
    const std::size_t count = question.options.size();
    if (count < leastOptions(question) || count == 1 || count > kMostOptions)
        faults.add("options", "expected two to four answers, A to D");
    const std::set<std::string> different(question.options.begin(), question.options.end());
    if (different.size() < count) faults.add("options", "two of the answers are the same");
    if (!question.verdicts.empty() && question.verdicts.size() != count)
        faults.add("verdicts", "expected one for each of the options");
}

void checkAnswer(const Question& question, const QuestionKind& kind, BlockFaults& faults) {
    if (question.answer.empty() && question.typed.empty())
        faults.add("answer", "missing: " + std::string(kind.answers));
    const RunAnswer* row = findRunAnswer(question.answer);
    if (row != nullptr && row->kind != kind.name) {
        faults.add("answer", question.answer + " is an answer of questions of kind " +
                                 std::string(row->kind));
    }
}

void checkQuestion(const Question& question, std::vector<LessonFault>& all) {
    BlockFaults faults(question.lines, all);
    faults.place("at", question.at);
    faults.place("until", question.until);
    faults.place("why", question.why);
    std::vector<std::string_view> names;
    for (const QuestionKind& each : questionKinds()) names.push_back(each.name);
    if (question.kind.empty()) {
        faults.add("kind", "missing: points, point, choice, number or play");
        return;
    }
    faults.oneOf("kind", question.kind, names);
    checkOptions(question, faults);
    if (const QuestionKind* kind = findQuestionKind(question.kind))
        checkAnswer(question, *kind, faults);
}

void checkStep(const LessonStep& step, std::vector<LessonFault>& all) {
    constexpr std::array<std::string_view, 2> kFrames{"all", "pivot"};
    BlockFaults faults(step.lines, all);
    faults.place("at", step.at);
    faults.place("until", step.until);
    faults.view(step.view);
    faults.names(step.names);
    faults.oneOf("frame", step.frame, kFrames);
    if (step.select.size() > 3) faults.add("select", "expected one to three points");
    const auto camera = jsonFromText<nlohmann::json>(
        step.camera, "expected JSON, as Ctrl+C copies it in the viewer");
    if (!step.camera.empty() && !camera) faults.add("camera", camera.error().message);
    if (step.play && step.until.empty()) faults.add("play", "needs until, where it ends");
    if (!step.compare.empty()) {
        const Result<SpecChange> other = changeFromWords(step.compare);
        if (!other) faults.add("compare", other.error().message);
    }
    for (const LessonLink& link : step.links) {
        if (!isPlaceText(link.address)) {
            all.push_back(
                {FaultSort::Malformed, link.line, "",
                 "se:" + excerpt(link.address) + ": expected an address, such as se:9.sphere.2"});
        }
    }
    if (step.question) checkQuestion(*step.question, all);
}

}  // namespace

bool isPlaceText(std::string_view text) {
    if (text == "0") return true;
    if (text.ends_with('%')) {
        const auto share = numberIn<double>(text.substr(0, text.size() - 1));
        return share && *share >= 0.0 && *share <= 100.0;
    }
    return addressFromString(text).has_value();
}

std::vector<LessonFault> syntaxFaults(const Lesson& lesson) {
    constexpr std::array<std::string_view, 4> kLayouts{"debug", "learn", "present", "compare"};
    std::vector<LessonFault> all;
    BlockFaults faults(lesson.lines, all);
    if (lesson.lines.of("version") == lesson.lines.block)
        faults.add("version", "missing: write version = 1");
    if (lesson.input.empty()) faults.add("input", "missing: scene:ID, or the path of a file");
    faults.view(lesson.view);
    faults.names(lesson.names);
    faults.oneOf("layout", lesson.layout, kLayouts);
    for (const LessonStep& step : lesson.steps) checkStep(step, all);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const Result<RunSpec> spec = runSpec(settingOf(lesson, i));
        if (spec) continue;
        const KeyLines& lines =
            lesson.steps[i].rules.empty() ? lesson.lines : lesson.steps[i].lines;
        all.push_back({FaultSort::Malformed, lines.of("rules"), "rules", spec.error().message});
        break;
    }
    return all;
}

}  // namespace se::teach
