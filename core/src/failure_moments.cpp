#include "spiraling_edge/failure_moments.h"

#include <algorithm>

#include "ledger_line.h"
#include "spiraling_edge/run_scan.h"

namespace se {
namespace {

bool among(const std::vector<Index>& sorted, Index p) {
    return std::binary_search(sorted.begin(), sorted.end(), p);
}

bool sameCorners(const Triangle& a, const Triangle& b) {
    const auto has = [&](Index p) { return b.a == p || b.b == p || b.c == p; };
    return has(a.a) && has(a.b) && has(a.c);
}

/// Goes through the run once and remembers what the failure's kind asks for.
class MomentFinder {
  public:
    MomentFinder(const PointSet& points, const Params& params, const MeshFailure& failure,
                 const std::vector<Triangle>& triangles)
        : points_(points), params_(params), failure_(failure), triangles_(triangles) {}

    void see(const ScannedPivot& pivot) {
        taken_.reset();
        for (const Event& event : pivot.events) {
            const LedgerLine line = lineOf(event, {points_, params_, pivot.point});
            if (!touched_ && touches(event)) touched_ = line;
            if (triangles_.empty()) {
                seeForPoint(line);
            } else if (failure_.kind->name == "holes") {
                seeForHole(line);
            } else {
                seeForTriangle(line);
            }
        }
    }

    Result<FailureMoments> found() const {
        if (!created_ || !touched_)
            return Error{"This failure does not come from this run: its points are never touched."};
        // Nothing was tested where a triangle is the only one possible: then making it decided.
        return FailureMoments{*created_, unavoidable_.value_or(*created_), *touched_};
    }

  private:
    bool touches(const Event& event) const {
        const auto mine = [&](Index p) { return among(failure_.points, p); };
        if (const auto* seed = std::get_if<SeedEvidence>(&event.evidence))
            return mine(seed->first) || mine(seed->second);
        return testedPoint(event) != kNone && mine(testedPoint(event));
    }

    void seeForPoint(const LedgerLine& line) {
        const Index p = testedPoint(line.event);
        const bool ownFan = p == kNone && line.pivot != kNone && among(failure_.points, line.pivot);
        if (ownFan && line.role == LineRole::Refused) unavoidable_ = line;
        if (p == kNone || !among(failure_.points, p)) return;
        const auto* ring = std::get_if<RingEvidence>(&line.event.evidence);
        const auto* strand = std::get_if<StrandEvidence>(&line.event.evidence);
        if (strand != nullptr || (ring != nullptr && ring->status < 0)) created_ = line;
        const bool limit = std::holds_alternative<LimitEvidence>(line.event.evidence);
        if (line.role == LineRole::Refused && !wasSettledBefore(line.event) && !limit)
            unavoidable_ = line;
    }

    /// The loop is there once its last point is done with.
    void seeForHole(const LedgerLine& line) {
        const Index tested = testedPoint(line.event);
        const bool pivots = line.pivot != kNone && among(failure_.points, line.pivot);
        const auto* ring = std::get_if<RingEvidence>(&line.event.evidence);
        if (ring != nullptr && ring->status < 0 && among(failure_.points, ring->point))
            created_ = line;
        if (!pivots || line.role != LineRole::Refused) return;
        const bool wholeFan = tested == kNone;
        if (wholeFan || (!wasSettledBefore(line.event) && among(failure_.points, tested)))
            unavoidable_ = line;
    }

    bool isOne(const Triangle& made) const {
        return std::any_of(triangles_.begin(), triangles_.end(),
                           [&](const Triangle& t) { return sameCorners(made, t); });
    }

    /// Of several triangles the one that was made last.
    void seeForTriangle(const LedgerLine& line) {
        const Event& event = line.event;
        if (line.role == LineRole::Taken && testedPoint(event) != kNone &&
            among(failure_.points, testedPoint(event)))
            taken_ = line;
        const auto* emit = std::get_if<EmitEvidence>(&event.evidence);
        const bool makes =
            (emit != nullptr && isOne(emit->corners)) || (mendsMesh(event) && touchesFlip(event));
        if (!makes) return;
        created_ = line;
        unavoidable_ = taken_.value_or(line);
    }
    bool touchesFlip(const Event& event) const {
        if (const auto* flip = std::get_if<FlipEvidence>(&event.evidence))
            return among(failure_.points, flip->x) && among(failure_.points, flip->y);
        return among(failure_.points, testedPoint(event));
    }

    const PointSet& points_;
    const Params& params_;
    const MeshFailure& failure_;
    const std::vector<Triangle>& triangles_;
    std::optional<LedgerLine> created_;
    std::optional<LedgerLine> unavoidable_;
    std::optional<LedgerLine> touched_;
    std::optional<LedgerLine> taken_;  ///< The last test of this pivot that took a corner.
};

}  // namespace

Result<FailureMoments> momentsOf(const PointSet& points, const Params& params,
                                 const MeshFailure& failure, const std::vector<Triangle>& mesh,
                                 const Progress& progress) {
    std::vector<Triangle> triangles;
    for (const Index i : failure.triangles) {
        if (i >= mesh.size()) return Error{"This failure is of another mesh."};
        triangles.push_back(mesh[i]);
    }
    MomentFinder finder(points, params, failure, triangles);
    const auto end = scanRun(
        points, params, [&](const ScannedPivot& pivot) { finder.see(pivot); }, progress);
    if (!end) return Error{"Cancelled."};
    return finder.found();
}

}  // namespace se
