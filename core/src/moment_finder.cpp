#include "moment_finder.h"

#include <algorithm>

#include "ledger_line.h"

namespace se {
namespace {

bool hasCorner(const Triangle& t, Index p) { return t.a == p || t.b == p || t.c == p; }

bool sameCorners(const Triangle& a, const Triangle& b) {
    return hasCorner(b, a.a) && hasCorner(b, a.b) && hasCorner(b, a.c);
}

/// The pivot's first and last are the only corners that are left, and make a triangle (§6.4).
bool fillsHole(const Event& event) {
    const auto* two = std::get_if<TwoPointEvidence>(&event.evidence);
    return two != nullptr && two->verdict == Verdict::Hole;
}

/// A candidate between two others went: they are neighbors on the rim of the fan now.
const SphereEvidence* closedGap(const Event& event) {
    const auto* sphere = std::get_if<SphereEvidence>(&event.evidence);
    return sphere != nullptr && sphere->verdict == Verdict::Removed ? sphere : nullptr;
}

}  // namespace

MomentFinder::MomentFinder(const FinderInput& input, const MeshFailure& failure)
    : input_(input), failure_(failure), kind_(kindOf(failure)) {
    for (const Index i : failure.triangles) triangles_.push_back(input.mesh[i]);
    points_ = failure.points;
    if (kind_ == Kind::Triangle) {
        for (const Triangle& t : triangles_) points_.insert(points_.end(), {t.a, t.b, t.c});
    }
    if (kind_ == Kind::Point) {
        for (const Index p : failure.points) {
            const auto list = input.points.neighbors[p];
            around_.insert(around_.end(), list.begin(), list.end());
        }
    }
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
}

MomentFinder::Kind MomentFinder::kindOf(const MeshFailure& failure) {
    if (failure.kind->name == "holes") return Kind::Hole;
    if (failure.kind->find == nullptr) return Kind::Ring;
    return failure.triangles.empty() ? Kind::Point : Kind::Triangle;
}

void MomentFinder::see(const LedgerLine& line) {
    if (!touched_ && touches(line.event)) touched_ = line;
    switch (kind_) {
        case Kind::Point:
            return seeForPoint(line);
        case Kind::Hole:
        case Kind::Ring:
            return seeForRing(line);
        case Kind::Triangle:
            return seeForTriangle(line);
    }
}

std::optional<FailureMoments> MomentFinder::found() const {
    if (!created_ || !touched_) return {};
    if (unavoidable_) return FailureMoments{*created_, *unavoidable_, *touched_};
    // A point that was never tested was lost with its last neighbor. Where nothing was decided at
    // all, making it was.
    return FailureMoments{*created_, deserted_.value_or(*created_), *touched_};
}

bool MomentFinder::mine(Index p) const {
    return std::binary_search(points_.begin(), points_.end(), p);
}

bool MomentFinder::touches(const Event& event) const {
    if (const auto* seed = std::get_if<SeedEvidence>(&event.evidence))
        return mine(seed->first) || mine(seed->second);
    return testedPoint(event) != kNone && mine(testedPoint(event));
}

void MomentFinder::seeForPoint(const LedgerLine& line) {
    const Index p = testedPoint(line.event);
    const bool ownFan = p == kNone && line.pivot != kNone && mine(line.pivot);
    if (ownFan && line.role == LineRole::Refused) unavoidable_ = line;
    const auto* ring = std::get_if<RingEvidence>(&line.event.evidence);
    if (ring != nullptr && ring->status < 0 && !mine(p) && !created_) deserted_ = line;
    if (p == kNone || !mine(p)) return;
    const auto* strand = std::get_if<StrandEvidence>(&line.event.evidence);
    if (strand != nullptr || (ring != nullptr && ring->status < 0)) created_ = line;
    const bool limit = std::holds_alternative<LimitEvidence>(line.event.evidence);
    if (line.role == LineRole::Refused && !wasSettledBefore(line.event) && !limit)
        unavoidable_ = line;
}

/// A loop is there once its last point is done with, a ring once it is freed.
void MomentFinder::seeForRing(const LedgerLine& line) {
    const Index tested = testedPoint(line.event);
    const bool pivots = line.pivot != kNone && mine(line.pivot);
    const auto* ring = std::get_if<RingEvidence>(&line.event.evidence);
    if (kind_ == Kind::Hole && ring != nullptr && ring->status < 0 && mine(ring->point))
        created_ = line;
    if (kind_ == Kind::Ring && created_) return;
    if (!pivots || line.role != LineRole::Refused) return;
    const bool wholeFan = tested == kNone;
    if (wholeFan || (!wasSettledBefore(line.event) && mine(tested))) unavoidable_ = line;
}

/// By its number, and by its corners where a step after the last pivot has put another triangle
/// into its place.
bool MomentFinder::isOne(const EmitEvidence& made) const {
    if (made.triangle < input_.mesh.size() && sameCorners(input_.mesh[made.triangle], made.corners))
        return std::binary_search(failure_.triangles.begin(), failure_.triangles.end(),
                                  made.triangle);
    return std::any_of(triangles_.begin(), triangles_.end(),
                       [&](const Triangle& t) { return sameCorners(made.corners, t); });
}

/// Failures that are there before all of their triangles are.
bool MomentFinder::isEarlyFailure() const {
    const std::string_view kind = failure_.kind->name;
    return kind == "duplicate_triangles" || kind == "non_manifold_edges" ||
           kind == "inconsistent_edges";
}

/// Are enough of its triangles made?
bool MomentFinder::isThere() const {
    const std::string_view kind = failure_.kind->name;
    if (kind == "duplicate_triangles") return made_.size() > 1;
    if (kind == "non_manifold_edges") return made_.size() > 2;
    const Index low = failure_.points[0];
    const Index high = failure_.points[1];
    const auto up = std::count_if(made_.begin(), made_.end(), [&](const Triangle& t) {
        return (t.a == low && t.b == high) || (t.b == low && t.c == high) ||
               (t.c == low && t.a == high);
    });
    return up > 1 || static_cast<std::ptrdiff_t>(made_.size()) - up > 1;
}

bool MomentFinder::mends(const Event& event) const {
    if (!mendsMesh(event)) return false;
    if (const auto* flip = std::get_if<FlipEvidence>(&event.evidence))
        return mine(flip->x) && mine(flip->y);
    return mine(testedPoint(event));
}

void MomentFinder::remember(const LedgerLine& line) {
    if (line.event.address.pivot != pivot_) decided_.clear();
    pivot_ = line.event.address.pivot;
    const Index tested = testedPoint(line.event);
    const bool taken = line.role == LineRole::Taken && tested != kNone && mine(tested);
    const SphereEvidence* gap = closedGap(line.event);
    const bool closed = gap != nullptr && mine(gap->t) && mine(gap->s);
    if (taken || closed || fillsHole(line.event)) decided_.push_back(line);
}

/// The last test that took a corner, or took away what lay between two of them. That first and last
/// alone are filled (§6.4) counts where nothing else was decided.
std::optional<LedgerLine> MomentFinder::decisionFor(const Triangle& made) const {
    const auto lastOf = [&](const auto& decides) {
        const auto found = std::find_if(decided_.rbegin(), decided_.rend(), decides);
        return found == decided_.rend() ? std::nullopt : std::optional(*found);
    };
    const auto tested = lastOf([&](const LedgerLine& line) {
        const SphereEvidence* gap = closedGap(line.event);
        if (gap != nullptr) return hasCorner(made, gap->t) && hasCorner(made, gap->s);
        return !fillsHole(line.event) && hasCorner(made, testedPoint(line.event));
    });
    if (tested) return tested;
    return lastOf([&](const LedgerLine& line) {
        return fillsHole(line.event) && hasCorner(made, line.pivot);
    });
}

/// Of several triangles the one that completes the failure: of an edge of five the third, of two
/// that cross the second.
void MomentFinder::seeForTriangle(const LedgerLine& line) {
    remember(line);
    if (mends(line.event)) {
        created_ = unavoidable_ = line;
        return;
    }
    const auto* emit = std::get_if<EmitEvidence>(&line.event.evidence);
    if (emit == nullptr || complete_ || !isOne(*emit)) return;
    made_.push_back(emit->corners);
    complete_ = isEarlyFailure() && isThere();
    created_ = line;
    unavoidable_ = decisionFor(emit->corners).value_or(line);
}

}  // namespace se
