#include "lesson_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/why/figure_check.h"
#include "spiraling_edge/why/run_compare.h"

namespace se::teach {
namespace {

/// A run that a claim is about, with its mesh.
struct ClaimedRun {
    const PointSet& points;
    const Params& params;
    std::vector<Triangle> mesh;
};

/// The runs of a step: its own, A, and that of its `compare`, B.
struct ClaimedRuns {
    ClaimedRun a;
    const std::optional<ClaimedRun>& b;
    const std::vector<PointName>& names;
};

/// Angle at `tip` between two points, degrees.
double degreesAt(const Vec3& tip, const Vec3& from, const Vec3& to) {
    constexpr double kHalfTurn = 180.0;
    const double cosine = glm::dot(glm::normalize(from - tip), glm::normalize(to - tip));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * kHalfTurn / std::numbers::pi;
}

/// A number of the mesh as a whole, by its name in the report of a run.
struct MeshNumber {
    std::string_view name;
    std::size_t MeshReport::*number;
};
constexpr std::array kMeshNumbers{
    MeshNumber{"points", &MeshReport::points},
    MeshNumber{"triangles", &MeshReport::triangles},
    MeshNumber{"components", &MeshReport::components},
    MeshNumber{"boundary_edges", &MeshReport::boundaryEdges},
    MeshNumber{"boundary_loops", &MeshReport::boundaryLoops},
};

/// The number of a name in kMeshNumbers, of a class of failures, or one of the four below; nothing
/// for any other subject.
std::optional<double> meshNumber(const std::string& subject, const ClaimedRun& run,
                                 const ClaimedRuns& runs) {
    const auto counted = [](auto count) { return static_cast<double>(count); };
    if (const MeshNumber* row = findNamed(kMeshNumbers, subject))
        return counted(reportMesh(run.points, run.mesh).*row->number);
    if (const FailureClass* kind = findFailureClass(subject)) {
        const std::ptrdiff_t row = kind - failureClasses().data();
        const MeshInspection inspected = inspectWithTotals(run.points, run.mesh);
        return counted(inspected.totals[static_cast<std::size_t>(row)].total);
    }
    if (subject == "closed_manifold")
        return counted(reportMesh(run.points, run.mesh).closedManifold());
    if (subject == "euler_characteristic")
        return counted(reportMesh(run.points, run.mesh).eulerCharacteristic);
    if (subject == "shared_triangles" && runs.b)
        return counted(compareMeshes(run.points.position, runs.a.mesh, runs.b->mesh).both);
    if (subject != "thin_triangles") return std::nullopt;
    constexpr double kCosine15 = 0.96592582628906831;  // Thin is an angle below 15 degrees.
    return counted(std::count_if(run.mesh.begin(), run.mesh.end(), [&](const Triangle& t) {
        return leastAngleCosine(run.points, t) > kCosine15;
    }));
}

/// "p t q": the angle at p between t and q, in whole degrees.
Result<double> angleOf(const std::string& words, const ClaimedRuns& runs) {
    const std::vector<Vec3>& all = runs.a.points.position;
    std::vector<Vec3> at;
    for (const std::string& word : io::wordsIn(words)) {
        const Index point = pointOf(word, runs.names);
        if (point >= all.size()) return Error{word + ": no such point"};
        at.push_back(all[point]);
    }
    if (at.size() != 3) return Error{"an angle is of three points, its tip first"};
    return std::round(degreesAt(at[0], at[1], at[2]));
}

/// The number that a claim is about, of one of the runs: that of the mesh, the value of a rule, an
/// angle, or how many decisions a query matches.
Result<double> valueOf(const std::string& subject, const ClaimedRun& run, const ClaimedRuns& runs) {
    constexpr std::string_view kAngle = "angle ";
    if (const auto number = meshNumber(subject, run, runs)) return *number;
    if (const RuleSetting* rule = findRuleSetting(subject)) return rule->get(run.params);
    if (subject.starts_with(kAngle)) return angleOf(subject.substr(kAngle.size()), runs);
    const Result<DecisionQuery> query = DecisionQuery::parse(subject);
    if (!query) return query.error();
    const auto found = findDecisions(run.points, run.params, query.value(), 0);
    if (!found) return found.error();
    return static_cast<double>(found.value().total);
}

/// A claim: "lost_points: 3", "B at=9 stage=emit: > A".
struct Claim {
    std::string subject;
    bool ofB = false;
    char relation = '=';  ///< Or < or >.
    std::string value;    ///< A number, or A or B for the subject in that run.
};
std::optional<Claim> readClaim(const std::string& text) {
    const std::size_t colon = text.rfind(": ");
    if (colon == std::string::npos || colon + 2 == text.size()) return std::nullopt;
    Claim claim;
    claim.ofB = text.starts_with("B ");
    const std::size_t from = claim.ofB ? 2 : 0;
    claim.subject = text.substr(from, colon - from);
    claim.value = text.substr(colon + 2);
    if (claim.value.starts_with("< ") || claim.value.starts_with("> ")) {
        claim.relation = claim.value.front();
        claim.value.erase(0, 2);
    }
    return claim;
}

/// The number that the subject is compared with.
Result<double> wantedBy(const Claim& claim, const ClaimedRuns& runs) {
    if (claim.value == "A") return valueOf(claim.subject, runs.a, runs);
    if (claim.value == "B") return valueOf(claim.subject, *runs.b, runs);
    const std::optional<double> number = numberIn<double>(claim.value);
    if (!number) return Error{claim.value + ": expected a number, A or B"};
    return *number;
}

/// The words of a text, with one blank between them.
std::string singleBlanks(const std::string& text) { return joined(io::wordsIn(text), " "); }

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
        if (!open() || !checkNames() || !checkPlaces() || !checkExpected() || !checkCompared() ||
            !checkFacts())
            return;
        if (step_.question) checkQuestion();
    }

  private:
    bool fault(FaultSort sort, std::size_t line, std::string key, std::string message) {
        faults_.push_back({line, std::move(key), std::move(message), sort});
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
        if (!textOf(step_.rules, "what_if").empty())
            return malformed(step_.lines, "what_if", cursor.error().message);
        return malformed(inputLines(), "input", cursor.error().message);
    }

    std::size_t pointCount() const { return cursor_->timeline().points().size(); }

    bool checkNames() {
        for (const PointName& each : setting_.names) {
            if (each.point < pointCount()) continue;
            return malformed(
                inputLines(), "names",
                each.name + " = " + absentPointText(std::to_string(each.point), pointCount()));
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
                return malformed(lines, key, absentPointText(word, pointCount()));
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
        if (!checkPlace(lines.of("until"), "until", step_.until)) return false;
        const auto end = placeInRun();
        if (!checkPlace(lines.of("at"), "at", step_.at.empty() ? setting_.at : step_.at))
            return false;
        return step_.until.empty() || step_.question || placeInRun() < end ||
               malformed(lines, "until", step_.until + " is not after " + setting_.at);
    }

    /// Pivot, and decisions of it up to the cursor: later in a run is greater.
    std::pair<std::uint32_t, std::ptrdiff_t> placeInRun() const {
        const Event* event = cursor_->event();
        if (event == nullptr) return {0, 0};
        const std::vector<Event>& events = cursor_->pivot().events;
        const auto found = std::find_if(events.begin(), events.end(), [&](const Event& each) {
            return each.address == event->address;
        });
        return {event->address.pivot, found - events.begin() + 1};
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
        // Both could be read: the lesson has no faults, and the run of the step is open.
        const RunSpec spec =
            otherRun(runSpec(setting_).value(), changeFromWords(step_.compare).value());
        const Result<RunCursor*> b = runs_.cursorOf(setting_, spec);
        if (!b) return malformed(step_.lines, "compare", b.error().message);
        compared_.emplace(claimedRun(*b.value()));
        const ClaimedRun a = claimedRun(*cursor_);
        return !compareMeshes(a.points.position, a.mesh, compared_->mesh).same() ||
               disagrees(step_.lines, "compare", "both runs make the same triangles");
    }

    static ClaimedRun claimedRun(const RunCursor& cursor) {
        const ComparedRun run{cursor.timeline().points(), cursor.timeline().params()};
        return {run.points, run.params, makeMesh(run).value().triangles};  // It cannot be canceled.
    }

    bool checkFacts() {
        if (step_.facts.empty()) return true;
        const ClaimedRuns runs{claimedRun(*cursor_), compared_, setting_.names};
        const std::string& intro = number_ == 0 ? lesson_.text : std::string();
        std::string text = singleBlanks(intro + " " + step_.title + " " + step_.text);
        if (step_.question) {
            for (const std::string& option : step_.question->options) text += " " + option;
        }
        return std::all_of(step_.facts.begin(), step_.facts.end(), [&](const LessonFact& fact) {
            if (text.find(fact.words) == std::string::npos)
                return fault(FaultSort::Disagrees, fact.line, "facts",
                             "\"" + fact.words + "\" is not in the text of the step");
            return std::all_of(
                fact.claims.begin(), fact.claims.end(),
                [&](const std::string& each) { return checkClaim(fact.line, each, runs); });
        });
    }

    bool checkClaim(std::size_t line, const std::string& text, const ClaimedRuns& runs) {
        const std::optional<Claim> claim = readClaim(text);
        if (!claim)
            return fault(FaultSort::Malformed, line, "facts", text + ": expected SUBJECT: NUMBER");
        if ((claim->ofB || claim->value == "B") && !runs.b)
            return fault(FaultSort::Malformed, line, "facts", text + ": there is no second run");
        const Result<double> found = valueOf(claim->subject, claim->ofB ? *runs.b : runs.a, runs);
        const Result<double> wanted = wantedBy(*claim, runs);
        if (!found || !wanted)
            return fault(FaultSort::Malformed, line, "facts",
                         text + ": " + (found ? wanted : found).error().message);
        const double value = found.value();
        if (claim->relation == '<'   ? value < wanted.value()
            : claim->relation == '>' ? value > wanted.value()
                                     : value == wanted.value())
            return true;
        std::string message = text + ": it is ";
        appendNumber(message, value);
        return fault(FaultSort::Disagrees, line, "facts", message);
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
            const Result<Answer> answer = row.find(range, context);
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
    std::optional<ClaimedRun> compared_;  ///< Nothing if the step compares no other run.
};

}  // namespace

std::vector<LessonFault> checkLesson(const Lesson& lesson, LessonRuns& runs) {
    std::vector<LessonFault> faults;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) StepCheck(lesson, i, runs, faults).run();
    // What the lesson says once, such as its input, is reported once.
    faults.erase(std::unique(faults.begin(), faults.end()), faults.end());
    return faults;
}

bool isMalformed(const std::vector<LessonFault>& faults) {
    return std::any_of(faults.begin(), faults.end(),
                       [](const LessonFault& each) { return each.sort == FaultSort::Malformed; });
}

}  // namespace se::teach
