/// The change that prevents what an answer is about: a rule of `robust` that is off, or another
/// preparation of the points. Each rule is run from the start. Unless that takes half of the steps,
/// those come first that decide otherwise at one of the pivots in question, or edit the mesh after
/// the last one: that is found by steps from the states of one run.
#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/spec/run_spec.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/prover.h"

namespace se {
namespace {

// The work for each point in steps of a run, as measured on a million points.
constexpr std::uint64_t kStepsToPrepare = 1;
constexpr std::uint64_t kStepsToJudge = 5;  // Also to prepare the judge.

/// A rule that is off, and the params with it.
struct Candidate {
    const RuleSetting* rule;
    Params params;
    bool differs = false;
};

/// The rules that `robust` has on and `params` has off, in the order of the table, but `rim`: the
/// points would be others.
std::vector<Candidate> candidatesOf(const Params& params) {
    const Params robust = *paramsByName("robust");
    std::vector<Candidate> all;
    for (const RuleSetting& each : ruleSwitches()) {
        if (!each.isOn(robust) || each.isOn(params)) continue;
        Params with = params;
        each.turnOn(with);
        if (preparesAlike(with, params)) all.push_back({&each, with});
    }
    return all;
}

/// The state with the table of its edges.
State withEdges(State state) {
    state.edges = EdgeTable(state.status.size());
    for (const Triangle& t : state.triangles) state.edges.add(t);
    return state;
}

/// The aim where what is tried is a change of rules or of preparation.
ProofAim aimOfChange(ProofAim aim) {
    if (aim.effectOfChange) aim.effect = aim.effectOfChange;
    return aim;
}

class PreventionSearch {
  public:
    PreventionSearch(const PointSet& points, const Params& params, const ProofAim& aim,
                     std::uint64_t left, std::shared_ptr<const MeshJudge> judge,
                     const Progress& progress)
        : points_(points),
          judge_(std::move(judge)),
          params_(params),
          aim_(aimOfChange(aim)),
          left_(left),
          goesOn_([&progress] { return !progress || progress(0.0); }),
          candidates_(candidatesOf(params)) {}

    /// The rule or preparation that changes the answer, if one was found.
    const std::optional<FieldValue>& found() const { return found_; }
    /// The verdict on the mesh with it; nothing where the steps did not last for one.
    const std::optional<MeshVerdict>& verdict() const { return verdict_; }
    /// "No single rule of robust, and none of 4 other preparations"; empty if nothing was tried, or
    /// the steps did not last.
    std::string allTried() const {
        if (left_ == 0) return "";
        const std::string rules = candidates_.empty()  ? ""
                                  : params_.robust.rim ? "No single rule of robust"
                                                       : "No single rule of robust but rim";
        if (prepared_ == 0) return rules;
        return (rules.empty() ? "None of " : rules + ", and none of ") +
               counted(prepared_, "other preparation");
    }

    /// Runs with each rule, first with those that decide otherwise at one of these pivots, which
    /// ascend to the last one of the run. False if cancelled.
    bool runRules(const std::vector<std::uint32_t>& places) {
        const std::uint64_t comparing =
            places.size() * candidates_.size() * points_.size() / kPointsOfForkPerStep;
        if (comparing < left_ / 2) {
            left_ -= comparing;
            if (!compareAt(places)) return false;
        }
        std::stable_partition(candidates_.begin(), candidates_.end(),
                              [](const Candidate& each) { return each.differs; });
        const SpecField* switches = findSpecField("switches");
        for (const Candidate& each : candidates_) {
            const RuleValue on{std::string(each.rule->name)};
            if (!runWith({switches, lineOf(on)}, points_, each.params)) return false;
        }
        return true;
    }

    /// Runs with each of these preparations. False if cancelled.
    bool runPreparations(std::span<const OtherPreparation> all) {
        for (const OtherPreparation& each : all) {
            spend(kStepsToPrepare * points_.size());
            if (left_ == 0) break;
            const std::optional<PointSet> points =
                each.points([this](double) { return goesOn_(); });
            if (!goesOn_()) return false;
            if (!points) continue;
            ++prepared_;
            if (!runWith(each.change, *points, params_)) return false;
        }
        return true;
    }

  private:
    void spend(std::uint64_t steps) { left_ -= std::min(left_, steps); }

    /// Makes a run with a change, and keeps it if it changes the answer and its mesh is better
    /// than those before; the first one if the steps do not last for a verdict. False if cancelled.
    bool runWith(const FieldValue& change, const PointSet& points, const Params& params) {
        if (left_ == 0) return true;
        Stepper whole(points, params);
        const auto effect = effectOfRun(whole, points_, aim_, left_, goesOn_);
        if (!effect) return false;
        if (*effect != Effect::Changed) return true;
        const std::uint64_t judging = kStepsToJudge * points_.size();
        if (left_ <= judging) {
            left_ = 0;
            if (!found_) found_ = change;
            return true;
        }
        spend(judging);
        const MeshVerdict verdict = verdictOn(whole.state().mesh());
        if (found_ && !isBetter(verdict, *verdict_)) return true;
        found_ = change;
        verdict_ = verdict;
        return true;
    }

    MeshVerdict verdictOn(std::span<const Triangle> mesh) const {
        if (!judge_ || judge_ == points_.judge) return judgeMesh(points_, mesh).verdict;
        PointSet judged = points_;
        judged.judge = judge_;
        return judgeMesh(judged, mesh).verdict;
    }

    /// Finds the rules that decide otherwise. False if cancelled.
    bool compareAt(const std::vector<std::uint32_t>& places) {
        Stepper plain(points_, params_);
        for (const std::uint32_t place : places) {
            if (!advanceTo(plain, place, left_, goesOn_)) return false;
            if (hasReached(plain, place) && !compareHere(plain, place == places.back()))
                return false;
        }
        return true;
    }

    /// Steps with each rule, and then without it. After the last pivot the edits of the mesh
    /// follow. False if cancelled.
    bool compareHere(Stepper& plain, bool isLast) {
        const State before = plain.state();
        std::optional<State> edged;  // As a run has it whose rules examine finished triangles.
        const auto never = [] { return false; };
        plain.stepPivot();
        if (isLast && !advanceUntil(plain, left_, goesOn_, never)) return false;
        const std::uint64_t expected = stateHash(plain.state());
        for (Candidate& each : candidates_) {
            if (each.differs) continue;
            const bool needsEdges = each.params.robust.needsEdges() && before.edges.empty();
            if (needsEdges && !edged) edged = withEdges(before);
            Stepper fork(points_, each.params);
            fork.setState(needsEdges ? *edged : before);
            fork.stepPivot();
            if (isLast && !advanceUntil(fork, left_, goesOn_, never)) return false;
            each.differs = isLast ? fork.state().mesh() != plain.state().mesh()
                                  : stateHash(fork.state()) != expected;
        }
        return true;
    }

    const PointSet& points_;
    const std::shared_ptr<const MeshJudge> judge_;
    const Params& params_;
    const ProofAim aim_;
    std::uint64_t left_;
    const GoesOn goesOn_;
    std::vector<Candidate> candidates_;
    std::size_t prepared_ = 0;  ///< Other preparations that were run.
    std::optional<FieldValue> found_;
    std::optional<MeshVerdict> verdict_;
};

/// "The rule fill", "The option --derive-rim".
std::string nameOf(const FieldValue& change) {
    if (const RuleSetting* rule = ruleOf(change)) return "The rule " + std::string(rule->name);
    return "The option " + optionsOf({change}).front();
}

/// The pivots of the cause and of the triangles of a ledger, and the last one, in ascending order.
std::vector<std::uint32_t> placesOf(const Ledger& ledger, std::uint32_t last) {
    constexpr std::size_t kMostPlaces = 4;
    std::vector<std::uint32_t> places{ledger.lines[ledger.cause].event.address.pivot, last};
    for (const LedgerLine& each : ledger.lines) {
        if (each.role == LineRole::Made && places.size() < kMostPlaces)
            places.push_back(each.event.address.pivot);
    }
    sortUnique(places);
    return places;
}

}  // namespace

Status addPrevention(const PointSet& points, const Params& params, std::uint32_t last,
                     const ProofAim& aim, std::uint64_t left, const ProofScope& scope,
                     Ledger& ledger, const Progress& progress) {
    if (left == 0) return success();
    Alternatives alternatives;
    const std::uint64_t judging = kStepsToJudge * points.size();
    if (scope.alternatives && left > judging) {
        left -= judging;
        Result<Alternatives> found = scope.alternatives(partOf(progress, 0.0, 0.1));
        if (!found) return found.error();
        alternatives = std::move(found.value());
    }
    PreventionSearch search(points, params, aim, left, alternatives.judge, progress);
    const bool goneOn = search.runRules(placesOf(ledger, last)) &&
                        (search.found() || search.runPreparations(alternatives.preparations));
    if (!goneOn) return Error{"Cancelled."};
    ledger.preventedBy = search.found();
    const std::string does = ledger.present ? " prevents it" : " brings it in";
    if (ledger.preventedBy) {
        const std::optional<MeshVerdict>& with = search.verdict();
        ledger.answer +=
            " " + nameOf(*ledger.preventedBy) + does +
            (!with             ? "."
             : with->isSound() ? ", and leaves a sound mesh."
                               : ", and leaves faults at " + counted(with->places, "place") + ".");
    } else if (const std::string tried = search.allTried(); !tried.empty()) {
        ledger.answer += " " + tried + does + ".";
    }
    return success();
}

}  // namespace se
