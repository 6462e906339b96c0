/// Triangles that close a gap of three have no deciding test of their own: they are traced to the
/// last earlier triangle at their edges, until one has a test. Two runs: the first records the
/// decision of every triangle, the second returns the lines.
#include "spiraling_edge/why/origin_decisions.h"

#include <algorithm>

#include "spiraling_edge/run/sweep.h"

namespace se {
namespace {

/// The last line for which `isCorner` holds for the point it took, or for both sides of a gap.
template <typename Test>
std::optional<LedgerLine> lastOf(const std::vector<LedgerLine>& decided, const Test& isCorner) {
    const auto found = std::find_if(decided.rbegin(), decided.rend(), [&](const LedgerLine& line) {
        if (const SphereEvidence* gap = closedGap(line.event))
            return isCorner(gap->t) && isCorner(gap->s);
        return !fillsHole(line.event) && isCorner(testedPoint(line.event));
    });
    return found == decided.rend() ? std::nullopt : std::optional(*found);
}

/// A triangle as it was made; the pivot is its first corner.
struct MadeTriangle {
    Triangle corners;
    Address decision;  ///< Pivot 0: there is none.
    bool alone = false;
};

/// The triangles of a run with their decisions.
class TriangleDecisions {
  public:
    TriangleDecisions(const PointSet& points, const Params& params)
        : points_(points), params_(params), at_(points.size()) {
        for (const Triangle& given : params.start.triangles) add({given, {}, false});
    }

    bool read(const Progress& progress) {
        const auto onPivot = [&](const SweptPivot& pivot) {
            decided_.clear();
            for (const Event& event : pivot.events) note(event, pivot.point);
        };
        return sweep(points_, params_, onPivot, progress).has_value();
    }

    /// The decision that a triangle is traced to; pivot 0 if there is none.
    Address originOf(Index triangle) const {
        while (triangle < made_.size() && made_[triangle].alone) {
            const Index before = lastAtEdges(triangle);
            if (before == kNone) return {};
            triangle = before;
        }
        return triangle < made_.size() ? made_[triangle].decision : Address{};
    }

  private:
    void note(const Event& event, Index pivot) {
        const bool taken = outcomeOf(event) == Outcome::Taken && testedPoint(event) != kNone;
        if (taken || closedGap(event) != nullptr || fillsHole(event))
            decided_.push_back({event, pivot, LineRole::Taken, std::nullopt});
        const auto* emit = as<EmitEvidence>(event);
        if (emit == nullptr || emit->triangle != made_.size()) return;
        const Triangle& t = emit->corners;
        const auto decision = lastDecision(decided_, t);
        const bool alone =
            !decision && std::any_of(decided_.begin(), decided_.end(),
                                     [](const LedgerLine& each) { return fillsHole(each.event); });
        add({t, decision ? decision->event.address : Address{}, alone});
    }

    void add(const MadeTriangle& made) {
        const Triangle& t = made.corners;
        for (const Index p : {t.a, t.b, t.c}) at_[p].push_back(static_cast<Index>(made_.size()));
        made_.push_back(made);
    }

    /// The last earlier triangle that shares an edge of this one at its own pivot.
    Index lastAtEdges(Index triangle) const {
        const Triangle& t = made_[triangle].corners;
        Index last = kNone;
        for (const Index each : at_[t.a]) {
            if (each >= triangle) break;
            const Triangle& other = made_[each].corners;
            if (hasCorner(other, t.b) || hasCorner(other, t.c)) last = each;
        }
        return last;
    }

    const PointSet& points_;
    const Params& params_;
    std::vector<LedgerLine> decided_;     ///< Of the current pivot.
    std::vector<MadeTriangle> made_;      ///< By number.
    std::vector<std::vector<Index>> at_;  ///< Per point: its triangles, ascending.
};

}  // namespace

bool hasCorner(const Triangle& t, Index p) { return t.a == p || t.b == p || t.c == p; }

bool fillsHole(const Event& event) {
    const auto* two = as<TwoPointEvidence>(event);
    return two != nullptr && isTaken(two->verdict);
}

const DropEvidence* passedBy(const Event& event) {
    const auto* drop = as<DropEvidence>(event);
    return drop != nullptr && drop->verdict == Verdict::Outside ? drop : nullptr;
}

bool passes(const Event& move, const DropEvidence& candidate) {
    const auto& limit = std::get<LimitEvidence>(move.evidence);
    if (limit.side != candidate.side) return false;
    return limit.side == Side::Start ? limit.toDegrees >= candidate.degrees
                                     : limit.toDegrees <= candidate.degrees;
}

const SphereEvidence* closedGap(const Event& event) {
    const auto* sphere = as<SphereEvidence>(event);
    return sphere != nullptr && !isTaken(sphere->verdict) ? sphere : nullptr;
}

std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided,
                                       const Triangle& made) {
    return lastOf(decided, [&](Index p) { return hasCorner(made, p); });
}

std::optional<LedgerLine> lastDecision(const std::vector<LedgerLine>& decided, Index a, Index b) {
    return lastOf(decided, [&](Index p) { return p == a || p == b; });
}

std::optional<std::map<Index, LedgerLine>> originDecisions(const PointSet& points,
                                                           const Params& params,
                                                           std::span<const Index> triangles,
                                                           const Progress& progress) {
    std::map<Index, LedgerLine> found;
    TriangleDecisions decisions(points, params);
    if (!decisions.read(progress)) return {};
    std::multimap<Address, Index, decltype(&isBefore)> wanted(&isBefore);
    for (const Index each : triangles) {
        const Address origin = decisions.originOf(each);
        if (origin.pivot != 0) wanted.emplace(origin, each);
    }
    const auto onPivot = [&](const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            const auto [begin, end] = wanted.equal_range(event.address);
            for (auto at = begin; at != end; ++at)
                found.emplace(at->second, lineOf(event, {points, params, pivot.point}));
        }
    };
    if (!wanted.empty() && !sweep(points, params, onPivot, progress)) return {};
    return found;
}

}  // namespace se
