/// The proofs of failures: what may have made one are the tests that made its triangles, and of a
/// loop or a ring, the tests between its points that ended without a triangle.
#include <algorithm>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/why/prover.h"

namespace se {
namespace {

/// The effect on a failure: None while it is there, Replaced by a new one in its place.
Effect effectOn(const MeshFailure& failure, std::span<const MeshFailure> known,
                const std::vector<MeshFailure>& left) {
    const auto isKnown = [&](const MeshFailure& each) {
        return std::any_of(known.begin(), known.end(),
                           [&](const MeshFailure& other) { return isSame(each, other); });
    };
    // A wide loop, or a piece, differs by a point or two: that is no other answer.
    constexpr std::size_t kMostPoints = 8;
    const bool wide = failure.points.size() > kMostPoints || failure.kind->name == "inward_pieces";
    Effect effect = Effect::Changed;
    for (const MeshFailure& each : left) {
        if (isSame(each, failure)) return Effect::None;
        if (isStillThere(failure, {&each, 1}) && !isKnown(each))
            effect = wide ? Effect::None : std::min(effect, Effect::Replaced);
    }
    return effect;
}

/// The effect on it in an inspected mesh. Undecided counts as unchanged.
Effect effectIn(const MeshInspection& mesh, const MeshFailure& failure,
                std::span<const MeshFailure> known) {
    const bool all = mesh.totals[rankOf(*failure.kind)].all();
    return all ? effectOn(failure, known, mesh.failures) : Effect::None;
}

/// Adds the tests and fans at the points of a loop that were refused.
void addRefusals(const MeshFailure& loop, const SweptPivot& pivot, const ReadingContext& context,
                 std::vector<LedgerLine>& lines) {
    const auto mine = [&](Index p) {
        return std::binary_search(loop.points.begin(), loop.points.end(), p);
    };
    if (!mine(pivot.point)) return;
    for (const Event& event : pivot.events) {
        const Index tested = testedPoint(event);
        if (!isAgainst(outcomeOf(event)) || (tested != kNone && !mine(tested))) continue;
        LedgerLine line = lineOf(event, context);
        line.role = LineRole::Indirect;
        lines.push_back(line);
    }
}

/// "lost point 7", "hole of points 6, 63 and 98", "opening of 64 points".
std::string nameOf(const MeshFailure& failure) {
    constexpr std::size_t kMostNamed = 4;
    const std::vector<Index>& of = failure.points;
    const std::string name(failure.kind->singular);
    if (of.size() > kMostNamed) return name + " of " + counted(of.size(), "point");
    if (of.size() == 1) return name + " " + std::to_string(of.front());
    std::string text = name + " of points ";
    for (std::size_t i = 0; i < of.size(); ++i)
        text += (i == 0 ? "" : i + 1 == of.size() ? " and " : ", ") + std::to_string(of[i]);
    return text;
}

}  // namespace

Ledger ledgerOf(const RunFailure& failure) {
    const FailureMoments& moments = failure.moments;
    Ledger ledger{.name = nameOf(failure.failure),
                  .present = true,
                  .where = failure.failure.kind->find != nullptr ? "in the mesh" : "in the run",
                  .lines = {moments.decided, moments.touched, moments.created}};
    ledger.words = describe(moments.decided.event);
    sortLines(ledger);
    if (editsMesh(moments.decided.event)) ledger.provedBy = ProvedBy::Step;
    ledger.answer = std::string(failure.failure.kind->meaning) +
                    " Last decided by: " + ledger.words + " (" +
                    toString(moments.decided.event.address) + ")";
    return ledger;
}

Result<Ledger> provedWhy(const PointSet& points, const Params& params, const RunFailure& asked,
                         std::span<const MeshFailure> known, const ProofScope& scope,
                         const Progress& progress) {
    const MeshFailure& failure = asked.failure;
    if (isLostPoint(failure))
        return provedWhy(points, params, Subject::point(failure.points.front()), scope, progress);
    constexpr double kLinesShare = 0.6;
    Ledger ledger = ledgerOf(asked);
    RunLength length;
    const auto visit = [&](const SweptPivot& pivot) {
        length.add(pivot);
        addMakings(points, params, pivot, asked.corners, ledger);
        if (isLoop(failure) || failure.triangles.empty())
            addRefusals(failure, pivot, {points, params, pivot.point}, ledger.lines);
    };
    if (ledger.provedBy == ProvedBy::Nothing) {
        if (!sweep(points, params, visit, partOf(progress, 0.0, kLinesShare)))
            return Error{"Cancelled."};
        sortLines(ledger);
    }
    LeftOverRings rings;
    ProofAim aim;
    if (failure.kind->find == nullptr) {
        aim.rings = &rings;
        aim.effect = [&](const State&) { return effectOn(failure, known, rings.found()); };
    } else {
        aim.effect = [&](const State& end) {
            return effectIn(inspectWithTotals(points, end.mesh()), failure, known);
        };
    }
    if (aim.rings == nullptr && failure.kind->fault) {
        // An opening in the place of a hole is no fault any more.
        aim.effectOfChange = [&](const State& end) {
            MeshInspection mesh = inspectWithTotals(points, end.mesh());
            std::erase_if(mesh.failures, [](const auto& each) { return !each.kind->fault; });
            return effectIn(mesh, failure, known);
        };
    }
    const Status done = conclude(points, params, aim, invertibleOf(points, ledger), length, scope,
                                 ledger, partOf(progress, kLinesShare, 1.0));
    if (!done.ok()) return done.error();
    return ledger;
}

}  // namespace se
