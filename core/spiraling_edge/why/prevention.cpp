/// Each rule is run from the start. Those come first that decide otherwise at one of the pivots in
/// question, or edit the mesh after the last one: that is found by steps from the states of one
/// run.
#include "spiraling_edge/why/prevention.h"

#include <algorithm>
#include <string>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/mesh/mesh_verdict.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se {
namespace {

/// A rule that is off, and the params with it.
struct Candidate {
    const RuleSetting* rule;
    Params params;
    bool differs = false;
};

/// The rules that `robust` has on and `params` has off, in the order of the table.
std::vector<Candidate> candidatesOf(const Params& params) {
    const Params robust = *paramsByName("robust");
    std::vector<Candidate> all;
    for (const RuleSetting& each : ruleSwitches()) {
        if (!each.isOn(robust) || each.isOn(params)) continue;
        all.push_back({&each, params});
        each.turnOn(all.back().params);
    }
    return all;
}

/// The state as a run has it whose rules examine finished triangles.
State withEdges(State state, const Params& params) {
    if (!params.robust.needsEdges() || !state.edges.empty()) return state;
    state.edges = EdgeTable(state.status.size());
    for (const Triangle& t : state.triangles) state.edges.add(t);
    return state;
}

class PreventionSearch {
  public:
    PreventionSearch(const PointSet& points, const Params& params, const ProofAim& aim,
                     std::uint64_t left, const Progress& progress)
        : points_(points),
          params_(params),
          aim_(aim),
          left_(left),
          goesOn_([&progress] { return !progress || progress(0.0); }),
          candidates_(candidatesOf(params)) {}

    /// True if there is no rule to try.
    bool empty() const { return candidates_.empty(); }
    /// The rule that changes the answer; null if none was found.
    const RuleSetting* found() const { return found_; }
    /// The verdict on the mesh with it.
    const MeshVerdict& verdict() const { return verdict_; }
    /// False if some rule was left out for the limit.
    bool complete() const { return complete_; }

    /// Looks at these pivots, in ascending order, the last of which is that of the run. False if
    /// cancelled.
    bool run(const std::vector<std::uint32_t>& places) {
        if (!compareAt(places)) return false;
        std::stable_partition(candidates_.begin(), candidates_.end(),
                              [](const Candidate& each) { return each.differs; });
        for (const Candidate& each : candidates_) {
            if (left_ == 0) break;
            Stepper whole(points_, each.params);
            const auto effect = effectOfRun(whole, points_, aim_, left_, goesOn_);
            if (!effect) return false;
            if (*effect != Effect::Changed) continue;
            const MeshVerdict verdict = judgeMesh(points_, whole.state().mesh()).verdict;
            if (found_ != nullptr && !hasFewerFaults(verdict, verdict_)) continue;
            found_ = each.rule;
            verdict_ = verdict;
        }
        complete_ = left_ > 0;
        return true;
    }

  private:
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
        const auto never = [] { return false; };
        plain.stepPivot();
        if (isLast && !advanceUntil(plain, left_, goesOn_, never)) return false;
        const std::uint64_t expected = stateHash(plain.state());
        for (Candidate& each : candidates_) {
            if (each.differs) continue;
            Stepper fork(points_, each.params);
            fork.setState(withEdges(before, each.params));
            fork.stepPivot();
            if (isLast && !advanceUntil(fork, left_, goesOn_, never)) return false;
            each.differs = isLast ? fork.state().mesh() != plain.state().mesh()
                                  : stateHash(fork.state()) != expected;
        }
        return true;
    }

    const PointSet& points_;
    const Params& params_;
    const ProofAim& aim_;
    std::uint64_t left_;
    const GoesOn goesOn_;
    std::vector<Candidate> candidates_;
    const RuleSetting* found_ = nullptr;
    MeshVerdict verdict_;
    bool complete_ = true;
};

/// The pivots of the cause and of the triangles of a ledger, and the last one, in ascending order.
std::vector<std::uint32_t> placesOf(const Ledger& ledger, std::uint32_t last) {
    constexpr std::size_t kMostPlaces = 4;
    std::vector<std::uint32_t> places{ledger.lines[ledger.cause].event.address.pivot, last};
    for (const LedgerLine& each : ledger.lines) {
        if (each.role == LineRole::Made && places.size() < kMostPlaces)
            places.push_back(each.event.address.pivot);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace

bool addPrevention(const PointSet& points, const Params& params, std::uint32_t last,
                   const ProofAim& aim, std::uint64_t left, Ledger& ledger,
                   const Progress& progress) {
    PreventionSearch search(points, params, aim, left, progress);
    if (search.empty()) return true;
    if (!search.run(placesOf(ledger, last))) return false;
    ledger.preventedBy = search.found();
    const std::string does = ledger.present ? " prevents it" : " brings it in";
    if (ledger.preventedBy != nullptr) {
        const MeshVerdict& with = search.verdict();
        ledger.answer +=
            " The rule " + std::string(ledger.preventedBy->name) + does +
            (with.isSound() ? ", and leaves a sound mesh."
                            : ", and leaves faults at " + counted(with.places, "place") + ".");
    } else if (search.complete()) {
        ledger.answer += " No single rule of robust" + does + ".";
    }
    return true;
}

}  // namespace se
