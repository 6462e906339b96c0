/// The search for the decision that an answer rests on: the run forks at each decision that may be
/// it, inverted, and the end tells whether the answer is another.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/inspected_run.h"
#include "spiraling_edge/why/proof.h"

namespace se {

/// The what-if that inverts a decision: keeps a refused point, drops a taken one, unlists an
/// inserted third point. Nothing where the event cannot be inverted or is no decision.
std::optional<WhatIf> inverseOf(const PointSet& points, const LedgerLine& decision);

/// A decision of the run with another one inverted.
struct FollowingDecision {
    Event event;
    WhatIf inverse;
};

/// A decision that can be inverted.
struct Invertible {
    std::size_t line;  ///< Position in Ledger::lines.
    WhatIf inverse;
    /// Nothing is inverted, but this point is listed by WhatIf::point; else kNone.
    Index listed = kNone;
    /// The pivot itself already changes the answer with the inversion.
    bool showsAtOnce = false;
    /// A second decision that is inverted with it.
    std::optional<FollowingDecision> second = {};
    /// A rule that is off as well: its steps after the last pivot undo the inversion.
    const RuleSetting* undoneBy = nullptr;
};

/// The decisions of a ledger that can be inverted: the cause, those that took a subject that is
/// present or refused one that is absent, and the indirect ones; the latest first, 200 at most.
std::vector<Invertible> invertibleOf(const PointSet& points, const Ledger& ledger);

/// The effect of an inversion on an answer.
enum class Effect : std::uint8_t {
    None,      ///< The answer stays.
    Replaced,  ///< A failure is gone, but another of its class is in its place.
    Changed,   ///< The answer is another.
};

/// The answer that an inversion is to change.
struct ProofAim {
    /// True for triangles made by one pivot that alone change the answer; may be empty.
    std::function<bool(std::span<const Triangle> made)> showsAtOnce = {};
    /// True if the triangles of the pivots of this run change the answer; may be empty.
    std::function<bool(const State& end)> changedByPivots = {};
    /// The decisions to invert in a fork of the run, whose answer is the same; lowers `left` by its
    /// steps. May be empty.
    std::function<std::vector<FollowingDecision>(const Params& forked, std::uint64_t& left)>
        following = {};
    /// Gets the rings that the run with an inversion leaves over; null: they are not needed.
    LeftOverRings* rings = nullptr;
    /// The effect on the answer of the run that ended so.
    std::function<Effect(const State& end)> effect;
    /// The effect where a rule or a preparation was changed; empty: as `effect`.
    std::function<Effect(const State& end)> effectOfChange = {};
    /// A rule or a preparation that changes the answer is looked for as well.
    bool findsChange = true;
};

/// False where a search is to end.
using GoesOn = std::function<bool()>;

/// Makes steps until `done`, or the run is finished, at most `left` of them, which it lowers. False
/// if cancelled.
bool advanceUntil(Stepper& stepper, std::uint64_t& left, const GoesOn& goesOn,
                  const std::function<bool()>& done);

/// As advanceUntil(), to the state before this pivot.
bool advanceTo(Stepper& stepper, std::uint32_t pivot, std::uint64_t& left, const GoesOn& goesOn);
/// True if this pivot is the next one, or past.
bool hasReached(const Stepper& stepper, std::uint32_t pivot);

/// Runs a fork of the run to its end, within `left` steps, which it lowers. Its effect on the
/// answer, None where the steps do not last: State::finished() is false then. Nothing if cancelled.
std::optional<Effect> effectOfRun(Stepper& fork, const PointSet& points, const ProofAim& aim,
                                  std::uint64_t& left, const GoesOn& goesOn);

/// The points of a fork at a pivot, its state copied, that take as long as a step of a run.
inline constexpr std::uint64_t kPointsOfForkPerStep = 8;

/// The length of a run.
struct RunLength {
    std::uint64_t steps = 0;   ///< Its pivots and the steps after the last one.
    std::uint32_t pivots = 0;  ///< Counters::pivots at its end.

    /// Takes the next pivot of the run.
    void add(const SweptPivot& pivot) {
        ++steps;
        pivots = pivot.after.counters.pivots;
    }
};

/// Proves a ledger by the inversions of `all`, unless Ledger::provedBy says that it needs none:
/// those whose forks take the steps of a run, but at least as many as may be run to the ends.
/// Their runs are made to the ends: those that show at once first, then that of the cause, of a
/// present subject those of the pivot of the cause, then the later ones; up to the first that
/// changes the answer. Where none does, the first that replaces a failure is taken. Two
/// inversions may change it, the second of a decision in the run with the first; they are tried
/// while the steps of three runs are left. At last, an inversion that steps after the last pivot
/// undo may change it while the rule of these steps is off. The cause becomes that of the proof,
/// and the answer the sentences about it, with the change that prevents it where
/// ProofAim::findsChange (addPrevention()). Requires Ledger::words of the cause so far. Fails if
/// cancelled.
Status conclude(const PointSet& points, const Params& params, const ProofAim& aim,
                std::vector<Invertible> all, const RunLength& length, const ProofScope& scope,
                Ledger& ledger, const Progress& progress);

/// Looks for the change that prevents a failure, or brings an absent subject in, and sets
/// Ledger::preventedBy and a sentence at the end of the answer, which is settled. The rules of
/// `robust` that are off, but `rim`, are run one at a time: first those that decide otherwise in a
/// step at the pivots of the cause and of the triangles in question, or after `last`, the number of
/// the last pivot of the run; where none changes the answer, the preparations. Of those that change
/// it the one with the best mesh is taken (isBetter()): all are judged in the same way;
/// or the first, where the steps do not last for a verdict. At most `left` steps; where they do not
/// last for any that changes it, nothing is said. Fails if cancelled, or as
/// ProofScope::alternatives does. Deterministic.
Status addPrevention(const PointSet& points, const Params& params, std::uint32_t last,
                     const ProofAim& aim, std::uint64_t left, const ProofScope& scope,
                     Ledger& ledger, const Progress& progress);

/// Adds to a ledger, as indirect lines at its end, the tests of a pivot that made any of these
/// triangles: those that took their corners or made way for them. sortLines() leaves out what the
/// ledger had before.
void addMakings(const PointSet& points, const Params& params, const SweptPivot& pivot,
                std::span<const Triangle> triangles, Ledger& ledger);

/// Puts the lines of a ledger into the order of their addresses, each once, of those with one
/// address the first; the cause stays.
void sortLines(Ledger& ledger);

}  // namespace se
