#include "lesson_check.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "lesson_keys.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/explain/figure_check.h"
#include "spiraling_edge/explain/run_compare.h"
#include "spiraling_edge/mesh/mesh_compare.h"

namespace se::teach {
namespace {

/// Checks one step; each function is false after it has reported a fault.
class StepCheck {
  public:
    StepCheck(const Lesson& lesson, std::size_t number, LessonRuns& runs,
              std::vector<LessonFault>& faults)
        : lesson_(lesson),
          step_(lesson.steps[number]),
          number_(number),
          setting_(settingOf(lesson, number)),
          runs_(runs),
          faults_(faults) {}

    void run() {
        if (!open() || !checkNames() || !checkPlaces() || !checkExpected() || !checkCompared())
            return;
        if (step_.question) checkQuestion();
    }

  private:
    bool fault(FaultSort sort, std::size_t line, std::string key, std::string message) {
        faults_.push_back({sort, line, std::move(key), std::move(message)});
        return false;
    }
    bool malformed(const KeyLines& lines, const std::string& key, std::string message) {
        return fault(FaultSort::Malformed, lines.of(key), key, std::move(message));
    }
    bool disagrees(const KeyLines& lines, const std::string& key, std::string message) {
        return fault(FaultSort::Disagrees, lines.of(key), key, std::move(message));
    }

    /// The block that a fault of the input is in: this step or the lesson.
    const KeyLines& inputLines() const { return step_.input.empty() ? lesson_.lines : step_.lines; }

    bool open() {
        Result<RunCursor*> cursor = runs_.cursorOf(setting_);
        if (cursor) {
            cursor_ = cursor.value();
            return true;
        }
        if (!step_.rules.whatIfs.empty())
            return malformed(step_.lines, "what_if", cursor.error().message);
        return malformed(inputLines(), "input", cursor.error().message);
    }

    std::size_t pointCount() const { return cursor_->timeline().points().size(); }

    bool checkNames() {
        for (const NamedPoint& each : setting_.names) {
            if (each.point < pointCount()) continue;
            return malformed(inputLines(), "names",
                             each.name + " = " + std::to_string(each.point) + ": there are " +
                                 std::to_string(pointCount()) + " points, from 0");
        }
        return checkWords(step_.lines, "select", step_.select);
    }

    bool checkWords(const KeyLines& lines, const std::string& key,
                    const std::vector<std::string>& words) {
        for (const std::string& word : words) {
            const Index point = pointOf(word, setting_.names);
            if (point == kNone)
                return malformed(lines, key, word + ": no such name; add it to names");
            if (point >= pointCount())
                return malformed(
                    lines, key,
                    word + ": there are " + std::to_string(pointCount()) + " points, from 0");
        }
        return true;
    }

    bool checkPlace(std::size_t line, const std::string& key, const std::string& place) {
        if (place.empty()) return true;
        const Status moved = goToPlace(*cursor_, place);
        return moved || fault(FaultSort::Malformed, line, key, moved.error().message);
    }

    bool checkPlaces() {
        for (const LessonLink& link : step_.links) {
            if (!checkPlace(link.line, "", link.address)) return false;
        }
        const KeyLines& lines = step_.lines;
        return checkPlace(lines.of("until"), "until", step_.until) &&
               checkPlace(lines.of("at"), "at", step_.at);
    }

    /// `words` are empty or an outcome that some decision can have.
    bool checkOutcome(const KeyLines& lines, const std::string& key, const std::string& words) {
        if (words.empty() || isPossibleOutcome(words)) return true;
        const std::vector<std::string_view> known = outcomeWords();
        return malformed(lines, key,
                         inQuotes(words) + " is no outcome of a decision; the nearest is \"" +
                             std::string(nearestWord(known, words)) +
                             "\"; docs/lessons.md lists them");
    }

    bool checkExpected() {
        if (!checkOutcome(step_.lines, "expect", step_.expect)) return false;
        if (step_.expect.empty()) return true;
        const Status moved = goToPlace(*cursor_, step_.at.empty() ? setting_.at : step_.at);
        const Event* event = moved ? cursor_->event() : nullptr;
        const std::string found = event != nullptr ? outcomeText(*event) : "";
        if (isOutcome(step_.expect, found)) return true;
        return disagrees(step_.lines, "expect",
                         found.empty() ? "the decision there has no outcome"
                                       : "the outcome there is " + inQuotes(found));
    }

    bool checkCompared() {
        if (step_.compare.empty()) return true;
        const Result<RunSettings> settings = runSettings(setting_);
        if (!settings) return malformed(step_.lines, "rules", settings.error().message);
        const Result<RunSettings> other = comparedSettings(settings.value(), step_.compare);
        if (!other) return malformed(step_.lines, "compare", other.error().message);
        const Result<RunCursor*> b = runs_.cursorOf(setting_, other.value());
        if (!b) return malformed(step_.lines, "compare", b.error().message);
        const Result<MadeMesh> meshA = meshOf(*cursor_);
        const Result<MadeMesh> meshB = meshOf(*b.value());
        if (!meshA || !meshB) return malformed(step_.lines, "compare", "the run was stopped");
        const MeshDifference difference =
            compareMeshes(cursor_->timeline().points().position, meshA.value().triangles,
                          meshB.value().triangles);
        return !difference.same() ||
               disagrees(step_.lines, "compare", "both runs make the same triangles");
    }

    static Result<MadeMesh> meshOf(const RunCursor& cursor) {
        return makeMesh({cursor.timeline().points(), cursor.timeline().params()});
    }

    /// The words of a typed answer that name points.
    std::vector<std::string> pointWords(const Question& question) const {
        if (question.kind == "points" || question.kind == "point") return question.typed;
        std::vector<std::string> words;
        if (question.kind != "play") return words;
        for (const std::string& each : question.typed) {
            const Result<PlayMove> move = moveFromText(each, setting_.names);
            if (!move) continue;  // Reported with the answer as a whole.
            for (const Index point : move.value().points) words.push_back(std::to_string(point));
        }
        return words;
    }

    void checkQuestion() {
        const Question& question = *step_.question;
        const KeyLines& lines = question.lines;
        const bool hasPlaces = checkPlace(lines.of("at"), "at", setting_.at) &&
                               checkPlace(lines.of("until"), "until", question.until) &&
                               checkPlace(lines.of("why"), "why", question.why);
        if (!hasPlaces) return;
        if (!checkWords(lines, "answer", pointWords(question))) return;
        for (const std::string& words : question.verdicts) {
            if (!checkOutcome(lines, "verdicts", words)) return;
        }
        const Result<RunRange> range = rangeOf(*cursor_, setting_, question);
        if (!range) {
            malformed(lines, "until", range.error().message);
            return;
        }
        const Result<RightAnswer> right = rightAnswer(lesson_, number_, runs_);
        if (!right) {
            // A typed answer is wrong by its form, one of the run by what the run does.
            const bool isTyped = question.answer.empty();
            isTyped ? malformed(lines, "answer", right.error().message)
                    : disagrees(lines, "answer", right.error().message);
            return;
        }
        if (checkTyped(question, right.value().answer, range.value()))
            checkOptions(question, right.value());
    }

    /// A typed answer has to be one that the run gives there.
    bool checkTyped(const Question& question, const Answer& typed, const RunRange& range) {
        if (!question.answer.empty() || question.unchecked) return true;
        const QuestionKind& kind = *findQuestionKind(question.kind);
        const QuestionContext context{question, setting_.names};
        std::string found;
        for (const RunAnswer& row : runAnswers()) {
            if (row.kind != kind.name) continue;
            const Result<Answer> answer = kind.fromRun(row.find(range), context);
            if (answer && kind.grade(typed, answer.value(), question).right) return true;
            found += (found.empty() ? "" : "; ") + std::string(row.name) + ": " +
                     (answer ? kind.text(answer.value(), context) : answer.error().message);
        }
        return disagrees(question.lines, "answer",
                         kind.text(typed, context) + " is not what the run gives (" + found +
                             "); `unchecked = true` if it does not follow from the run");
    }

    void checkOptions(const Question& question, const RightAnswer& right) {
        if (question.options.empty()) return;
        if (rightOption({question, setting_.names}, right.answer)) return;
        disagrees(question.lines, "options",
                  "exactly one of them has to be the answer, which is " + right.text);
    }

    const Lesson& lesson_;
    const LessonStep& step_;
    std::size_t number_;
    StepSetting setting_;
    LessonRuns& runs_;
    std::vector<LessonFault>& faults_;
    RunCursor* cursor_ = nullptr;
};

bool isSameFault(const LessonFault& a, const LessonFault& b) {
    return a.line == b.line && a.key == b.key && a.message == b.message;
}

}  // namespace

std::vector<LessonFault> checkLesson(const Lesson& lesson, LessonRuns& runs) {
    std::vector<LessonFault> faults;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) StepCheck(lesson, i, runs, faults).run();
    // What the lesson says once, such as its input, is reported once.
    faults.erase(std::unique(faults.begin(), faults.end(), isSameFault), faults.end());
    return faults;
}

bool isMalformed(const std::vector<LessonFault>& faults) {
    return std::any_of(faults.begin(), faults.end(),
                       [](const LessonFault& each) { return each.sort == FaultSort::Malformed; });
}

}  // namespace se::teach
