/// A state machine per failure, by its kind: a point waits for its last refusal, a hole or a ring
/// for the last fan refused on it, a triangle for the tests that made its corners neighbors in a
/// fan. The last candidate for the cause is kept until the failure exists. O(1) per event, but for
/// triangles the tests of one pivot.
#include "spiraling_edge/why/moment_finder.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/why/origin_decisions.h"

namespace se {
namespace {

bool sameCorners(const Triangle& a, const Triangle& b) {
    return hasCorner(b, a.a) && hasCorner(b, a.b) && hasCorner(b, a.c);
}

/// True if a candidate was left out only for its angle: it lies where the pivot has triangles, or
/// will never have any.
bool liesOutside(const Event& event) {
    const auto* sort = as<SortEvidence>(event);
    return sort != nullptr &&
           (sort->verdict == Verdict::NotAfterStart || sort->verdict == Verdict::NotBeforeEnd);
}

/// True for two points that find only each other (§6.4), which can make no triangle.
bool isFullTurn(const Event& event) {
    const auto* two = as<TwoPointEvidence>(event);
    return two != nullptr && two->degrees > 359.9;
}

SharedLine sharedOf(const std::optional<LedgerLine>& line) {
    return line ? std::make_shared<const LedgerLine>(*line) : nullptr;
}

}  // namespace

void addTest(const LedgerLine& line, std::vector<LedgerLine>& tests) {
    const std::uint32_t pivot = line.event.address.pivot;
    if (!tests.empty() && tests.back().event.address.pivot != pivot) tests.clear();
    const bool taken = line.role == LineRole::Taken && testedPoint(line.event) != kNone;
    if (taken || closedGap(line.event) != nullptr || fillsHole(line.event)) tests.push_back(line);
}

MomentFinder::MomentFinder(const FinderInput& input, const MeshFailure& failure)
    : input_(input), failure_(failure), kind_(kindOf(failure)) {
    for (const Index i : failure.triangles) {
        assert(i < input.mesh.size());
        triangles_.push_back(input.mesh[i]);
    }
    points_ = failure.points;
    if (kind_ == Kind::Triangle) {
        for (const Triangle& t : triangles_) points_.insert(points_.end(), {t.a, t.b, t.c});
    }
    sortUnique(points_);
    watched_ = points_;
    if (kind_ != Kind::Point) return;
    for (const Index p : failure.points) {
        const auto list = input.points.neighbors[p];
        watched_.insert(watched_.end(), list.begin(), list.end());
    }
}

MomentFinder::Kind MomentFinder::kindOf(const MeshFailure& failure) {
    if (isLoop(failure)) return Kind::Hole;
    // Two points are left over when no fan took either of them.
    const bool pair = failure.points.size() == 2;
    if (failure.kind->find == nullptr) return pair ? Kind::Point : Kind::Ring;
    return failure.triangles.empty() ? Kind::Point : Kind::Triangle;
}

void MomentFinder::add(const SharedLine& shared) {
    if (!touched_ && touches(shared->event)) touched_ = shared;
    switch (kind_) {
        case Kind::Point:
            return addForPoint(shared);
        case Kind::Hole:
        case Kind::Ring:
            return addForRing(shared);
        case Kind::Triangle:
            return addForTriangle(shared);
    }
}

std::optional<FailureMoments> MomentFinder::found() const {
    if (!created_ || !touched_) return {};
    // A point that was never tested was lost with its last neighbor. Without any decision the
    // creation counts.
    for (const auto& decision : {decided_, alonePair_, outside_, deserted_}) {
        if (decision) return FailureMoments{*created_, *decision, *touched_};
    }
    return FailureMoments{*created_, *created_, *touched_};
}

bool MomentFinder::mine(Index p) const {
    return std::binary_search(points_.begin(), points_.end(), p);
}

bool MomentFinder::touches(const Event& event) const {
    if (const auto* seed = as<SeedEvidence>(event)) return mine(seed->first) || mine(seed->second);
    return mine(testedPoint(event));
}

void MomentFinder::addForPoint(const SharedLine& shared) {
    const LedgerLine& line = *shared;
    const Index p = testedPoint(line.event);
    if (p == kNone && mine(line.pivot) && line.role == LineRole::Refused)
        (isFullTurn(line.event) ? alonePair_ : decided_) = shared;
    const auto* ring = as<RingEvidence>(line.event);
    if (ring != nullptr && ring->status < 0 && !mine(p) && !created_) deserted_ = shared;
    if (!mine(p)) return;
    const auto* strand = as<StrandEvidence>(line.event);
    if (strand != nullptr || (ring != nullptr && ring->status < 0)) created_ = shared;
    const bool limit = isA<LimitEvidence>(line.event);
    if (line.role != LineRole::Refused || wasSettledBefore(line.event) || limit) return;
    const auto* drop = passedBy(line.event);
    const SharedLine move = drop != nullptr ? moveOver(*drop) : nullptr;
    (liesOutside(line.event) ? outside_ : decided_) = move ? move : shared;
}

/// The first move of start or end past the candidate; null if there is none.
SharedLine MomentFinder::moveOver(const DropEvidence& drop) const {
    const auto found =
        std::find_if(input_.moves.begin(), input_.moves.end(),
                     [&](const LedgerLine& move) { return passes(move.event, drop); });
    return found == input_.moves.end() ? nullptr : std::make_shared<const LedgerLine>(*found);
}

/// A loop exists once its last point is DONE, a ring once it is freed.
void MomentFinder::addForRing(const SharedLine& shared) {
    const LedgerLine& line = *shared;
    const Index tested = testedPoint(line.event);
    const auto* ring = as<RingEvidence>(line.event);
    if (kind_ == Kind::Hole && ring != nullptr && ring->status < 0 && mine(ring->point))
        created_ = shared;
    if (kind_ == Kind::Ring && created_) return;
    if (!mine(line.pivot) || line.role != LineRole::Refused) return;
    // None: the whole fan was refused.
    if (tested == kNone || (!wasSettledBefore(line.event) && mine(tested)))
        (liesOutside(line.event) ? outside_ : decided_) = shared;
}

/// Compares by number, and by corners where a step after the last pivot has replaced the triangle.
bool MomentFinder::isOne(const EmitEvidence& made) const {
    if (made.triangle < input_.mesh.size() && sameCorners(input_.mesh[made.triangle], made.corners))
        return std::binary_search(failure_.triangles.begin(), failure_.triangles.end(),
                                  made.triangle);
    return std::any_of(triangles_.begin(), triangles_.end(),
                       [&](const Triangle& t) { return sameCorners(made.corners, t); });
}

/// True if the failure exists although not all of its triangles are made.
bool MomentFinder::isThere() const {
    const std::string_view kind = failure_.kind->name;
    if (kind == "duplicate_triangles") return made_.size() > 1;
    if (kind == "non_manifold_edges") return made_.size() > 2;
    if (kind != "inconsistent_edges") return false;
    const Index low = failure_.points[0];
    const Index high = failure_.points[1];
    const auto up = std::count_if(made_.begin(), made_.end(), [&](const Triangle& t) {
        return (t.a == low && t.b == high) || (t.b == low && t.c == high) ||
               (t.c == low && t.a == high);
    });
    return up > 1 || static_cast<std::ptrdiff_t>(made_.size()) - up > 1;
}

bool MomentFinder::isRepair(const Event& event) const {
    if (!editsMesh(event)) return false;
    if (const auto* flip = as<FlipEvidence>(event)) return mine(flip->x) && mine(flip->y);
    if (const auto* hole = as<CloseHoleEvidence>(event))
        return mine(hole->first) && mine(hole->second);
    if (const auto* remesh = as<RemeshEvidence>(event))
        return mine(remesh->faulty.a) && mine(remesh->faulty.b) && mine(remesh->faulty.c);
    return mine(testedPoint(event));
}

/// The decision that made a faulty edge or point: the last test that took an end of it.
std::optional<LedgerLine> MomentFinder::decisionForPart(const Triangle& made) const {
    const std::string_view kind = failure_.kind->name;
    const bool edge = kind == "non_manifold_edges" || kind == "inconsistent_edges";
    if (!edge && kind != "non_manifold_vertices") return {};
    const auto end = [&](Index p) { return p == made.a ? kNone : p; };
    return lastDecision(input_.tests, end(failure_.points.front()), end(failure_.points.back()));
}

/// The decision that made the triangle. The filling of first and last alone (§6.4) counts where
/// there is no other.
std::optional<LedgerLine> MomentFinder::decisionFor(const Triangle& made) const {
    const std::vector<LedgerLine>& tests = input_.tests;
    if (const auto tested = lastDecision(tests, made)) return tested;
    const auto found = std::find_if(tests.rbegin(), tests.rend(), [&](const auto& line) {
        return fillsHole(line.event) && hasCorner(made, line.pivot);
    });
    return found == tests.rend() ? std::nullopt : std::optional(*found);
}

/// Waits for the triangle that completes the failure: of an edge of five the third, of two that
/// cross the second.
void MomentFinder::addForTriangle(const SharedLine& line) {
    if (isRepair(line->event)) {
        created_ = decided_ = line;
        alone_ = kNone;
        return;
    }
    const auto* emit = as<EmitEvidence>(line->event);
    if (emit == nullptr || complete_ || !isOne(*emit)) return;
    made_.push_back(emit->corners);
    complete_ = isThere();
    created_ = line;
    // Without a test of that edge it existed before, and was bound to get this triangle.
    if (const auto part = sharedOf(decisionForPart(emit->corners))) part_ = part;
    const SharedLine decision = part_ ? part_ : sharedOf(decisionFor(emit->corners));
    decided_ = decision ? decision : line;
    alone_ = fillsHole(decided_->event) ? emit->triangle : kNone;
}

}  // namespace se
