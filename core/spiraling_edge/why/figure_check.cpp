/// Runs of a figure, and the decisions at the addresses of its expectations.
#include "spiraling_edge/why/figure_check.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string_view>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se {
namespace {

std::string ringText(const RingEvidence& e) {
    const std::string status = e.status < 0    ? "DONE"
                               : e.status == 0 ? "UNUSED"
                                               : "USED " + std::to_string(e.status);
    return (e.inserted ? "enters, " : "leaves, ") + status;
}

/// The words that effectText() begins with.
constexpr std::array<std::string_view, 11> kEffectWords{
    "made",   "enters",     "leaves", "passed over", "splits into", "joins",
    "closed", "next pivot", "seed",   "stranded",    "freed"};

/// The effect of an event that is no test.
std::string effectText(const Event& event) {
    return std::visit(Overloaded{[](const EmitEvidence&) { return std::string("made"); },
                                 [](const RingEvidence& e) { return ringText(e); },
                                 [](const SkipEvidence&) { return std::string("passed over"); },
                                 [](const SplitEvidence& e) {
                                     return "splits into " + std::to_string(e.activeLength) +
                                            " and " + std::to_string(e.stackedLength);
                                 },
                                 [](const JoinEvidence& e) {
                                     return "joins, a ring of " + std::to_string(e.length);
                                 },
                                 [](const CloseEvidence&) { return std::string("closed"); },
                                 [](const AdvanceEvidence&) { return std::string("next pivot"); },
                                 [](const SeedEvidence&) { return std::string("seed"); },
                                 [](const StrandEvidence&) { return std::string("stranded"); },
                                 [](const FreeEvidence&) { return std::string("freed"); },
                                 [](const auto&) { return std::string(); }},
                      event.evidence);
}

/// The points that an expectation about the event names.
std::string pointsText(const Event& event, std::span<const PointName> names) {
    if (const auto* emit = as<EmitEvidence>(event)) {
        const Triangle& t = emit->corners;
        return nameOf(t.a, names) + " " + nameOf(t.b, names) + " " + nameOf(t.c, names);
    }
    if (const auto* insert = as<InsertEvidence>(event)) return nameOf(insert->third, names);
    const Index point = subjectOf(event);
    return point == kNone ? std::string() : nameOf(point, names);
}

PointSet pointsOf(const Figure& figure) {
    assert(figure.hasScene());
    Result<Prepared> prepared = prepare(figure.scene.build(), {});
    assert(prepared.ok());
    return std::move(prepared.value().points);
}

/// A run of a figure.
struct FigureRun {
    std::vector<CheckedExpectation> expectations;
    std::vector<CheckedExpectation> without;
    std::vector<Triangle> mesh;
};

/// The expectations before a run: those of no decision hold until it is found.
std::vector<CheckedExpectation> unseen(std::span<const FigureExpectation> expectations) {
    std::vector<CheckedExpectation> all;
    for (const FigureExpectation& each : expectations)
        all.push_back({each, each.outcome.empty(), {}});
    return all;
}

FigureRun runOf(const Figure& figure, const PointSet& points, const Params& params) {
    FigureRun run{unseen(figure.expectations), unseen(figure.without), {}};
    const std::vector<PointName> names = figure.pointNames();
    const auto note = [&](const Event& event) {
        const std::string address = toString(event.address);
        for (auto* list : {&run.expectations, &run.without}) {
            for (CheckedExpectation& each : *list) {
                if (each.expected.address != address) continue;
                each.found = describe(event, names);
                each.holds = outcomeText(event) == each.expected.outcome &&
                             pointsText(event, names) == each.expected.points;
            }
        }
    };
    std::optional<State> end = sweep(points, params, [&](const SweptPivot& pivot) {
        for (const Event& event : pivot.events) note(event);
    });
    assert(end);
    run.mesh = end->mesh();
    return run;
}

Params withStart(const Figure& figure, Params params) {
    params.start = figure.scene.start != nullptr ? figure.scene.start() : GivenStart{};
    return params;
}

std::size_t countOf(FaultKind kind, const PointSet& points, const std::vector<Triangle>& mesh) {
    return countFaults(findFaults(points, mesh))[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string outcomeText(const Event& event) {
    const std::string_view verdict = endingText(event);
    return verdict.empty() ? effectText(event) : std::string(verdict);
}

std::vector<std::string_view> outcomeWords() {
    std::vector<std::string_view> words;
    for (const VerdictRow& row : verdictTable()) words.push_back(row.text);
    words.insert(words.end(), kEffectWords.begin(), kEffectWords.end());
    return words;
}

bool FigureCheck::holds() const {
    const auto hold = [](const std::vector<CheckedExpectation>& list) {
        return std::all_of(list.begin(), list.end(),
                           [](const CheckedExpectation& each) { return each.holds; });
    };
    return showsAbsence && hold(expectations) && hold(without);
}

std::vector<CheckedExpectation> expectationsOf(const Figure& figure, Params params) {
    return runOf(figure, pointsOf(figure), withStart(figure, std::move(params))).expectations;
}

Params withoutRule(const Figure& figure, Params params) {
    const RuleSetting* rule = findRuleSetting(figure.rule.name);
    assert(rule != nullptr && isValue(*rule, figure.rule.value));
    rule->set(params, figure.rule.value);
    return params;
}

FigureCheck checkFigure(const Figure& figure) {
    const PointSet points = pointsOf(figure);
    const Params params = withStart(figure, {});
    FigureRun with = runOf(figure, points, params);
    FigureRun without = runOf(figure, points, withoutRule(figure, params));
    FigureCheck check;
    check.brokenWithout = static_cast<std::size_t>(
        std::count_if(without.expectations.begin(), without.expectations.end(),
                      [](const CheckedExpectation& each) { return !each.holds; }));
    check.showsAbsence = check.brokenWithout > 0 && with.mesh != without.mesh;
    if (figure.fault) {
        check.faultsWith = countOf(*figure.fault, points, with.mesh);
        check.faultsWithout = countOf(*figure.fault, points, without.mesh);
        check.showsAbsence = check.showsAbsence && check.faultsWith == 0 && check.faultsWithout > 0;
    }
    check.expectations = std::move(with.expectations);
    check.without = std::move(without.without);
    return check;
}

}  // namespace se
