/// Forks of the run at the decisions to invert. One pass forward leaves out the inversions that are
/// refused, and finds those that show at their own pivot: these are the likely ones. Each run to an
/// end is made from the start.
#include "spiraling_edge/why/prover.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se {

std::optional<WhatIf> inverseOf(const PointSet& points, const LedgerLine& decision) {
    const Address& at = decision.event.address;
    if (const auto* insert = as<InsertEvidence>(decision.event)) {
        if (insert->third == kNone) return {};
        WhatIf what{WhatIfKind::List, at.pivot, Stage::Pivot, insert->pivot, Vec3(0.0), {}};
        for (const Index q : points.neighbors[insert->pivot]) {
            if (q != insert->third) what.list.push_back(q);
        }
        return what;
    }
    const auto* sort = as<SortEvidence>(decision.event);
    if (sort != nullptr && sort->verdict == Verdict::SameAngle)
        return WhatIf{WhatIfKind::Drop, at.pivot, at.stage, sort->rival, Vec3(0.0), {}};
    if (const auto* guard = as<GuardEvidence>(decision.event)) {
        if (outcomeOf(decision.event) != Outcome::Refused) return {};
        const Index refused = guard->dropped == kNone ? decision.pivot : guard->dropped;
        return WhatIf{WhatIfKind::Keep, at.pivot, at.stage, refused, Vec3(0.0), {}};
    }
    const auto verdict = verdictOf(decision.event);
    const auto kind = verdict ? rowOf(*verdict).inverse : std::nullopt;
    if (!kind) return {};
    const bool fan = at.stage == Stage::TwoPoint;
    return WhatIf{*kind,     at.pivot, at.stage, fan ? decision.pivot : testedPoint(decision.event),
                  Vec3(0.0), {}};
}

namespace {

/// The number of decisions of an answer that may be inverted.
constexpr std::size_t kMostInvertible = 200;

}  // namespace

std::vector<Invertible> invertibleOf(const PointSet& points, const Ledger& ledger) {
    std::vector<Invertible> all;
    const LineRole direct = ledger.present ? LineRole::Taken : LineRole::Refused;
    for (std::size_t i = ledger.lines.size(); i-- > 0 && all.size() < kMostInvertible;) {
        const LedgerLine& line = ledger.lines[i];
        if (line.role != direct && line.role != LineRole::Indirect && i != ledger.cause) continue;
        const auto inverse = inverseOf(points, line);
        if (!inverse || std::any_of(all.begin(), all.end(), [&](const Invertible& each) {
                return each.inverse == *inverse;
            }))
            continue;
        all.push_back({i, *inverse});
    }
    return all;
}

namespace {

/// The result of a search for a proof.
struct Proof {
    std::optional<Invertible> found = {};
    Effect effect = Effect::None;  ///< Of `found`.
    std::size_t tried = 0;         ///< Inversions that were run, this one among them.
    std::size_t pairs = 0;         ///< Those of two decisions.
    bool complete = true;          ///< Not one was left out for the limits.
    std::uint64_t left = 0;        ///< Steps that were not made.
};

/// The steps of the runs of a scope, each of `steps`.
std::uint64_t stepsOf(const ProofScope& scope, std::uint64_t steps) {
    return static_cast<std::uint64_t>(scope.runs * static_cast<double>(steps));
}
/// The steps that inversions may take.
std::uint64_t proofStepsOf(const ProofScope& scope, std::uint64_t steps) {
    return std::max(kLeastProofSteps, stepsOf(scope, steps));
}
/// The steps for other rules and preparations.
std::uint64_t changeStepsOf(std::uint64_t steps, std::uint64_t left) {
    return std::max(left, kLeastChangeSteps - std::min(kLeastChangeSteps, stepsOf({}, steps)));
}

class Prover {
  public:
    Prover(const PointSet& points, const Params& params, const Ledger& ledger, const ProofAim& aim,
           std::vector<Invertible> all, const Progress& progress)
        : points_(points),
          params_(params),
          ledger_(ledger),
          aim_(aim),
          goesOn_([this, &progress] { return !progress || progress(share_); }),
          all_(std::move(all)) {}

    Result<Proof> run(std::uint64_t steps, const ProofScope& scope) {
        if (all_.empty()) return Proof{.left = proofStepsOf(scope, steps)};
        const std::size_t most =
            std::max<std::size_t>(scope.inversions, std::max(kLeastProofSteps, steps) *
                                                        kPointsOfForkPerStep / points_.size());
        const bool wasCut = all_.size() >= std::min(kMostInvertible, most);
        if (all_.size() > most) all_.resize(most);
        std::uint64_t looking = ~std::uint64_t{0};
        if (!lookAtPivots(params_, looking, all_)) return Error{"Cancelled."};
        sortByPromise();
        Proof proof{.left = proofStepsOf(scope, steps)};
        if (!runToEnds(scope, proof)) return Error{"Cancelled."};
        const std::vector<Invertible> singles = all_;
        const auto isOpen = [&] {
            return proof.effect == Effect::None && proof.complete &&
                   proof.left >= kRunsOfPair * steps;
        };
        for (std::size_t i = 0; i < singles.size() && i < kMostFirst && isOpen(); ++i) {
            if (aim_.following && !runPairs(singles[i], scope, proof)) return Error{"Cancelled."};
        }
        if (proof.effect == Effect::None && !runUndone(scope, proof)) return Error{"Cancelled."};
        if (wasCut) proof.complete = false;
        return proof;
    }

  private:
    Params with(const Invertible& inverted) const {
        Params forked = params_;
        forked.whatIf.push_back(inverted.inverse);
        if (inverted.second) forked.whatIf.push_back(inverted.second->inverse);
        if (inverted.undoneBy != nullptr) inverted.undoneBy->turnOff(forked);
        return forked;
    }
    /// The pivot of the last decision that is inverted.
    static std::uint32_t pivotOf(const Invertible& each) {
        return each.second ? each.second->inverse.pivot : each.inverse.pivot;
    }
    /// Leaves out inversions that are refused, and marks those that show at their pivot, the last
    /// one of each in a run with `params`. Takes `left` steps at most. False if cancelled.
    bool lookAtPivots(const Params& params, std::uint64_t& left, std::vector<Invertible>& list) {
        std::stable_sort(list.begin(), list.end(), [](const Invertible& a, const Invertible& b) {
            return pivotOf(a) < pivotOf(b);
        });
        Stepper stepper(points_, params);
        std::vector<Invertible> possible;
        for (Invertible& each : list) {
            if (!advanceTo(stepper, pivotOf(each), left, goesOn_) || !goesOn_()) return false;
            if (!hasReached(stepper, pivotOf(each))) continue;
            const auto made = madeWithLastWhatIf(points_, with(each), stepper.state());
            if (!made) continue;
            each.showsAtOnce = aim_.showsAtOnce && aim_.showsAtOnce(made.value());
            possible.push_back(each);
        }
        list = std::move(possible);
        return true;
    }

    /// Runs the pairs of an inversion and one of a later decision in the run with it; of an absent
    /// subject, those that show at once. False if cancelled.
    bool runPairs(const Invertible& first, const ProofScope& scope, Proof& proof) {
        const Params forked = with(first);
        std::vector<Invertible> pairs;
        for (const FollowingDecision& second : aim_.following(forked, proof.left)) {
            if (second.inverse.pivot < first.inverse.pivot || second.inverse == first.inverse)
                continue;
            pairs.push_back(first);
            pairs.back().second = second;
        }
        if (!lookAtPivots(forked, proof.left, pairs)) return false;
        if (aim_.showsAtOnce)
            std::erase_if(pairs, [](const Invertible& each) { return !each.showsAtOnce; });
        all_ = std::move(pairs);
        return runToEnds(scope, proof);
    }

    /// Those that show at once first, then that of the cause, then those of the pivot that made the
    /// subject; of equals the later.
    void sortByPromise() {
        const std::uint32_t making = ledger_.lines[ledger_.cause].event.address.pivot;
        const auto rank = [&](const Invertible& each) {
            return std::tuple(!each.showsAtOnce, each.line != ledger_.cause,
                              ledger_.present && each.inverse.pivot != making);
        };
        std::stable_sort(all_.begin(), all_.end(), [&](const Invertible& a, const Invertible& b) {
            if (rank(a) != rank(b)) return rank(a) < rank(b);
            return a.line > b.line;
        });
    }

    /// Runs the inversions that steps after the last pivot undo, each with one of the rules of such
    /// steps off. False if cancelled.
    bool runUndone(const ProofScope& scope, Proof& proof) {
        std::vector<Invertible> undone;
        for (const Invertible& each : undone_) {
            for (const StageRow& stage : stageTable()) {
                const RuleSetting* rule =
                    isRepair(stage.id) ? findRuleSetting(stage.name) : nullptr;
                if (rule == nullptr || !rule->isOn(params_)) continue;
                undone.push_back(each);
                undone.back().undoneBy = rule;
            }
        }
        all_ = std::move(undone);
        return runToEnds(scope, proof);
    }

    /// Runs the inversions up to the first that changes the answer. False if cancelled.
    bool runToEnds(const ProofScope& scope, Proof& proof) {
        constexpr double kLookShare = 0.3;
        for (const Invertible& each : all_) {
            share_ = kLookShare + (1.0 - kLookShare) * static_cast<double>(proof.tried) /
                                      static_cast<double>(scope.inversions);
            const bool isUndone = each.undoneBy != nullptr;
            if ((proof.tried == scope.inversions && !isUndone) || proof.left == 0) {
                proof.complete = false;
                break;
            }
            if (!goesOn_()) return false;
            Stepper fork(points_, with(each));
            const auto effect = effectOfRun(fork, points_, aim_, proof.left, goesOn_);
            if (!effect) return false;
            if (!fork.state().finished()) {
                proof.complete = false;
                break;
            }
            if (!isUndone) ++proof.tried;
            if (!isUndone && each.second) ++proof.pairs;
            if (*effect == Effect::None && !isUndone && undone_.size() < kMostUndone &&
                aim_.changedByPivots && aim_.changedByPivots(fork.state()))
                undone_.push_back(each);
            if (*effect <= proof.effect) continue;
            proof.found = each;
            proof.effect = *effect;
            if (*effect == Effect::Changed) break;
        }
        return true;
    }

    static constexpr std::size_t kMostUndone = 3;
    /// The inversions that others are tried with.
    static constexpr std::size_t kMostFirst = 6;
    /// A ledger takes two runs, and a pair one.
    static constexpr std::uint64_t kRunsOfPair = 3;

    const PointSet& points_;
    const Params& params_;
    const Ledger& ledger_;
    const ProofAim& aim_;
    const GoesOn goesOn_;
    std::vector<Invertible> all_;
    std::vector<Invertible> undone_;  ///< Pivots change the answer then, and the end does not.
    double share_ = 0.0;              ///< Of the work, for the progress.
};

/// The effect of the inversion: the words after the name.
std::string wordsOf(const Ledger& ledger, const Proof& proof) {
    if (proof.effect == Effect::Replaced)
        return ", and with this decision inverted another would be in its place: ";
    if (proof.found->listed != kNone)
        return ", and would be if " + std::to_string(proof.found->inverse.point) + " listed " +
               std::to_string(proof.found->listed) + ": ";
    const RuleSetting* const rule = proof.found->undoneBy;
    return std::string(", and would ") + (ledger.present ? "not be" : "be") + " with " +
           (proof.found->second ? "two decisions" : "this decision") + " inverted" +
           (rule == nullptr ? ""
                            : " and without the rule " + std::string(rule->name) +
                                  ", which undoes that after the last pivot") +
           ": ";
}

/// The end of an answer that is not proved.
std::string doubtOf(const Proof& proof) {
    if (proof.tried == 0)
        return proof.complete ? " Not proved: no decision about it can be inverted."
                              : " Not proved: the first inversion ran too long.";
    std::string count = counted(proof.tried - proof.pairs, "inversion");
    if (proof.pairs > 0) count += " and " + counted(proof.pairs, "pair");
    return " Not proved: " + (proof.complete ? count : "the first " + count) +
           (proof.tried == 1 ? " does" : " do") + " not change it.";
}

/// Makes the cause that of the proof, and the answer the sentence about it.
void settle(Ledger& ledger, const Proof& proof) {
    std::string between = ". ";
    if (proof.found) {
        const std::size_t line = proof.found->line;
        if (line != ledger.cause) ledger.words = describe(ledger.lines[line].event);
        ledger.cause = line;
        ledger.provedBy = ProvedBy::Inversion;
        ledger.inversions = {proof.found->inverse};
        ledger.undoneBy = proof.found->undoneBy;
        between = wordsOf(ledger, proof);
    } else if (ledger.provedBy == ProvedBy::Step) {
        between = std::string(", since a step after the last pivot ") +
                  (ledger.present ? "made" : "removed") + " it: ";
    }
    ledger.answer = answerText(ledger, between);
    if (ledger.provedBy == ProvedBy::Nothing) ledger.answer += doubtOf(proof);
    if (!proof.found || !proof.found->second) return;
    const FollowingDecision& second = *proof.found->second;
    ledger.inversions.push_back(second.inverse);
    ledger.answer +=
        " Then: " + describe(second.event) + " (" + toString(second.event.address) + ")";
}

}  // namespace

bool advanceUntil(Stepper& stepper, std::uint64_t& left, const GoesOn& goesOn,
                  const std::function<bool()>& done) {
    while (!done() && left > 0 && stepper.stepPivot()) {
        if (--left % kPivotsPerReport == 0 && !goesOn()) return false;
    }
    return true;
}

bool hasReached(const Stepper& stepper, std::uint32_t pivot) {
    return stepper.state().counters.pivots + 1 >= pivot;
}

bool advanceTo(Stepper& stepper, std::uint32_t pivot, std::uint64_t& left, const GoesOn& goesOn) {
    return advanceUntil(stepper, left, goesOn, [&] { return hasReached(stepper, pivot); });
}

std::optional<Effect> effectOfRun(Stepper& fork, const PointSet& points, const ProofAim& aim,
                                  std::uint64_t& left, const GoesOn& goesOn) {
    EventLog log;
    if (aim.rings != nullptr) {
        *aim.rings = {};
        fork.setLog(&log);
    }
    const auto visit = [&] {
        if (aim.rings == nullptr) return false;
        aim.rings->add(points, log.events());
        log.clear();
        return false;
    };
    const bool goneOn = advanceUntil(fork, left, goesOn, visit);
    if (goneOn) visit();
    fork.setLog(nullptr);
    if (!goneOn) return {};
    return fork.state().finished() ? aim.effect(fork.state()) : Effect::None;
}

Status conclude(const PointSet& points, const Params& params, const ProofAim& aim,
                std::vector<Invertible> all, const RunLength& length, const ProofScope& scope,
                Ledger& ledger, const Progress& progress) {
    constexpr double kProofShare = 0.7;
    if (ledger.provedBy != ProvedBy::Nothing) {
        settle(ledger, {});
        return success();
    }
    const Result<Proof> proof =
        Prover(points, params, ledger, aim, std::move(all), partOf(progress, 0.0, kProofShare))
            .run(length.steps, scope);
    if (!proof) return proof.error();
    settle(ledger, proof.value());
    if (!aim.findsChange) return success();
    const std::uint64_t left = changeStepsOf(length.steps, proof.value().left);
    return addPrevention(points, params, length.pivots, aim, left, scope, ledger,
                         partOf(progress, kProofShare, 1.0));
}

void addMakings(const PointSet& points, const Params& params, const SweptPivot& pivot,
                std::span<const Triangle> triangles, Ledger& ledger) {
    for (const Event& event : pivot.events) {
        const auto* emit = as<EmitEvidence>(event);
        if (emit == nullptr) continue;
        const Subject made = Subject::triangle(emit->corners.a, emit->corners.b, emit->corners.c);
        if (!isInMesh(triangles, made)) continue;
        for (LedgerLine line : linesAt(points, params, made, pivot)) {
            if (line.role != LineRole::Taken && line.role != LineRole::Indirect) continue;
            line.role = LineRole::Indirect;
            ledger.lines.push_back(line);
        }
    }
}

void sortLines(Ledger& ledger) {
    const auto address = [](const LedgerLine& line) { return line.event.address; };
    const Address cause = address(ledger.lines[ledger.cause]);
    std::stable_sort(ledger.lines.begin(), ledger.lines.end(), [&](const auto& a, const auto& b) {
        return isBefore(address(a), address(b));
    });
    const auto same = [&](const auto& a, const auto& b) { return address(a) == address(b); };
    ledger.lines.erase(std::unique(ledger.lines.begin(), ledger.lines.end(), same),
                       ledger.lines.end());
    ledger.cause = 0;
    while (address(ledger.lines[ledger.cause]) != cause) ++ledger.cause;
}

}  // namespace se
