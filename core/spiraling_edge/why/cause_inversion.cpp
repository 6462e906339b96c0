/// Test of causes by inversion: the run is forked just before the decision that made a failure
/// unavoidable, the decision inverted by a what-if, and the end inspected. A decision that is only
/// postponed to another pivot is followed up to twelve times. One run forward serves all failures,
/// in the order of their pivots; each costs a run from its fork and an inspection.
#include "spiraling_edge/why/cause_inversion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/inspected_run.h"
#include "spiraling_edge/why/remedy.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se {
namespace {

/// The reason why a decision without a what-if cannot be inverted.
std::string reasonFor(const LedgerLine& decision) {
    const auto verdict = verdictOf(decision.event);
    if (verdict == Verdict::NotAfterStart || verdict == Verdict::NotBeforeEnd ||
        verdict == Verdict::Outside)
        return "The point lies outside of the free sector.";
    if (verdict == Verdict::AlreadyDone) return "The point is DONE.";
    return decision.role == LineRole::Fact ? "Nothing is tested there."
                                           : "There is no what-if for such a decision.";
}

/// Runs `stepper` to the end and finds the failures of one class.
InspectedRun finishRun(Stepper& stepper, const PointSet& points, const FailureClass& kind) {
    if (kind.find != nullptr) {
        stepper.run();
        MeshInspection found = inspectWithTotals(points, stepper.state().mesh());
        return {std::move(found), stepper.state().mesh()};
    }
    // The list of this class is complete.
    MeshInspection found;
    found.totals.resize(failureClasses().size());
    FreedRings rings;
    EventLog log;
    stepper.setLog(&log);
    for (bool more = true; more;) {
        log.clear();
        more = stepper.stepPivot();
        for (const Event& event : log.events()) {
            if (const auto ring = rings.add(event))
                found.failures.push_back(failureOf(points, *ring));
        }
    }
    stepper.setLog(nullptr);
    return {std::move(found), stepper.state().mesh()};
}

/// True for a point that no fan took, or two that found only each other.
bool isLost(const MeshFailure& failure) {
    return failure.triangles.empty() && failure.points.size() <= 2;
}

/// True if `b` tests the same point as `a`, possibly at another pivot or stage; for a fan, if it
/// has the same pivot. For a lost point every test of it counts.
bool repeatsTest(const LedgerLine& a, const LedgerLine& b, const MeshFailure& failure) {
    const Index point = testedPoint(a.event);
    return isLost(failure) ||
           (point == testedPoint(b.event) && (point != kNone || a.pivot == b.pivot));
}

bool isSame(const MeshFailure& a, const MeshFailure& b) {
    return a.kind == b.kind && a.points == b.points;
}

/// Runs once from start to end and forks at the decisions to invert.
class CauseInverter {
  public:
    CauseInverter(const PointSet& points, const Params& params, std::span<const RunFailure> known)
        : points_(points), params_(params), known_(known), stepper_(points, params) {}

    /// Requires that pivots do not decrease from call to call.
    CauseInversion invert(const RunFailure& failure) {
        const std::uint32_t pivot = failure.moments.unavoidable.event.address.pivot;
        assert(stepper_.state().counters.pivots < pivot);
        while (stepper_.state().counters.pivots + 1 < pivot && stepper_.stepPivot()) {
        }
        CauseInversion inversion = inverted(failure.failure, failure.moments.unavoidable);
        if (inversion.outcome != Inversion::Replaced || failure.failure.triangles.size() != 2)
            return inversion;
        // Of two crossing triangles the earlier may be the wrong one.
        const auto earlier = decisionThatMade(failure.failure.triangles.front());
        if (!earlier) return inversion;
        CauseInversion other = inverted(failure.failure, *earlier);
        if (other.outcome > Inversion::Later) return inversion;
        other.outcome = Inversion::Earlier;
        other.reason = toString(earlier->event.address) + ": " + describe(earlier->event);
        return other;
    }

  private:
    /// Maximum number of repeated tests that are followed: a point can be tested by each of its
    /// neighbors.
    static constexpr std::size_t kMaxInverses = 12;

    /// Inverts a decision, and its repetition where it is only postponed.
    CauseInversion inverted(const MeshFailure& failure, const LedgerLine& decision) const {
        CauseInversion result;
        const auto inverse = inverseOf(points_, decision);
        if (!inverse) {
            result.reason = reasonFor(decision);
            return result;
        }
        result.inverses.push_back(*inverse);
        CauseInversion best = result;
        for (LedgerLine asked = decision; invertOnce(failure, asked, result);) {
            if (result.inverses.size() == 2 || result.outcome < best.outcome) best = result;
        }
        return result.outcome <= best.outcome ? result : best;
    }

    /// The decision that made a triangle.
    std::optional<LedgerLine> decisionThatMade(Index triangle) {
        if (mesh_.empty()) {
            Stepper whole(points_, params_);
            whole.run();
            mesh_ = whole.state().mesh();
        }
        MeshFailure alone;
        alone.kind = findFailureClass("flipped_triangles");
        alone.triangles = {triangle};
        const auto moments = momentsOf(points_, params_, alone, mesh_);
        return moments ? std::optional(moments.value().unavoidable) : std::nullopt;
    }

    /// A stepper just before the last of the turns; from the start if the run has passed one of
    /// them.
    Stepper forkedAt(const Params& forked, const std::vector<WhatIf>& inverses) const {
        Stepper fork(points_, forked);
        const std::uint32_t here = stepper_.state().counters.pivots;
        const bool ahead = std::all_of(inverses.begin(), inverses.end(),
                                       [&](const WhatIf& each) { return each.pivot > here; });
        if (ahead) fork.setState(stepper_.state());
        while (fork.state().counters.pivots + 1 < inverses.back().pivot && fork.stepPivot()) {
        }
        return fork;
    }

    /// Continues with the inversions of `result`. True if the last of them only postponed the
    /// decision: then `asked` is its repetition, and its inversion is added.
    bool invertOnce(const MeshFailure& failure, LedgerLine& asked, CauseInversion& result) const {
        Params forked = params_;
        forked.whatIf.insert(forked.whatIf.end(), result.inverses.begin(), result.inverses.end());
        Stepper fork = forkedAt(forked, result.inverses);
        if (Status can = checkLastWhatIf(points_, forked, fork.state()); !can) {
            if (result.inverses.size() == 1) result.outcome = Inversion::NotInvertible;
            result.reason = can.error().message;
            result.inverses.resize(std::max<std::size_t>(1, result.inverses.size() - 1));
            return false;
        }
        const InspectedRun run = finishRun(fork, points_, *failure.kind);
        const MeshFailure* successor = successorOf(failure, run.failures);
        result.reason.clear();
        if (successor == nullptr && !run.totalOf(*failure.kind).all()) {
            result.outcome = Inversion::NotInvertible;
            result.reason = "Then the mesh has more failures of this class than are looked for.";
            return false;
        }
        if (successor == nullptr) {
            result.outcome = result.inverses.size() > 1 ? Inversion::Later : Inversion::Gone;
            return false;
        }
        result.outcome = isSame(*successor, failure) ? Inversion::NoEffect : Inversion::Replaced;
        const auto moments = momentsOf(points_, forked, *successor, run.mesh);
        if (!moments) return false;
        const LedgerLine& next = moments.value().unavoidable;
        result.reason = "Then " + toString(next.event.address) + ": " + describe(next.event);
        const auto inverse = inverseOf(points_, next);
        const bool again = inverse &&
                           (isLost(failure) || inverse->kind == result.inverses.front().kind) &&
                           repeatsTest(asked, next, failure) &&
                           std::find(result.inverses.begin(), result.inverses.end(), *inverse) ==
                               result.inverses.end();
        if (!again || result.inverses.size() == kMaxInverses) return false;
        result.inverses.push_back(*inverse);
        asked = next;
        return true;
    }

    /// The failure itself, if it still exists, or a new one of its class in its place.
    const MeshFailure* successorOf(const MeshFailure& failure,
                                   const std::vector<MeshFailure>& left) const {
        const MeshFailure* successor = nullptr;
        for (const MeshFailure& each : left) {
            if (isSame(each, failure)) return &each;
            const bool alike = each.kind == failure.kind || (isLoop(each) && isLoop(failure));
            if (successor == nullptr && alike && isStillThere(failure, {each}) && !isKnown(each))
                successor = &each;
        }
        return successor;
    }
    bool isKnown(const MeshFailure& failure) const {
        return std::any_of(known_.begin(), known_.end(),
                           [&](const RunFailure& each) { return isSame(each.failure, failure); });
    }

    const PointSet& points_;
    const Params& params_;
    std::span<const RunFailure> known_;
    Stepper stepper_;
    std::vector<Triangle> mesh_;  ///< The mesh of the run, made when first needed.
};

std::uint32_t pivotOf(const RunFailure& failure) {
    return failure.moments.unavoidable.event.address.pivot;
}

}  // namespace

std::string_view inversionName(Inversion inversion) {
    constexpr std::array<std::string_view, 6> kNames{"gone",
                                                     "gone after a second inversion",
                                                     "gone with the earlier",
                                                     "another in its place",
                                                     "stays",
                                                     "cannot be turned"};
    return kNames[static_cast<std::size_t>(inversion)];
}

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
    const auto verdict = verdictOf(decision.event);
    const auto kind = verdict ? rowOf(*verdict).inverse : std::nullopt;
    if (!kind || at.stage == Stage::Guard) return {};
    const bool fan = at.stage == Stage::TwoPoint;
    return WhatIf{*kind,     at.pivot, at.stage, fan ? decision.pivot : testedPoint(decision.event),
                  Vec3(0.0), {}};
}

Result<std::vector<CauseInversion>> invertCauses(const PointSet& points, const Params& params,
                                                 std::span<const RunFailure> failures,
                                                 std::span<const std::size_t> chosen,
                                                 const Progress& progress) {
    std::vector<std::size_t> order(chosen.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return pivotOf(failures[chosen[a]]) < pivotOf(failures[chosen[b]]);
    });
    std::vector<CauseInversion> inversions(chosen.size());
    CauseInverter inverter(points, params, failures);
    std::size_t count = 0;
    for (const std::size_t i : order) {
        if (progress && !progress(double(count++) / double(order.size())))
            return Error{"Cancelled."};
        inversions[i] = inverter.invert(failures[chosen[i]]);
    }
    return inversions;
}

std::vector<std::size_t> sampleOfEach(std::span<const RunFailure> failures, std::size_t limit) {
    std::vector<std::size_t> chosen;
    for (const FailureClass& kind : failureClasses()) {
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < failures.size(); ++i) {
            if (failures[i].failure.kind == &kind) all.push_back(i);
        }
        const std::size_t count = std::min(limit, all.size());
        for (std::size_t i = 0; i < count; ++i) chosen.push_back(all[i * all.size() / count]);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

}  // namespace se
