/// §6.1, Fig. 3: the neighbors of the pivot, sorted by angle.
#include <algorithm>

#include "phases.h"

namespace se {
namespace {

/// Stable insertion sort by angle: lists are short, come nearest first, and so points of the same
/// angle stay in order of distance.
void sortByAngle(std::vector<Candidate>& candidates) {
    constexpr std::size_t kLong = 48;
    if (candidates.size() > kLong) {
        std::stable_sort(
            candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.angle.key < b.angle.key; });
        return;
    }
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const Candidate moving = candidates[i];
        std::size_t j = i;
        for (; j > 0 && candidates[j - 1].angle.key > moving.angle.key; --j) {
            candidates[j] = candidates[j - 1];
        }
        candidates[j] = moving;
    }
}

/// "If two neighboring points are found to have the same angle, the point closest to p is included
/// in the ring and the other point is eliminated from consideration."
void keepNearestOfEachAngle(StepContext& context) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool same =
            kept > 0 && all[i].angle.key - all[kept - 1].angle.key <= context.params.sameAngle;
        if (!same) {
            all[kept++] = all[i];
            continue;
        }
        if (all[i].lengthSq < all[kept - 1].lengthSq) std::swap(all[i], all[kept - 1]);
        note(context, Stage::Sort, [&] {
            return SortEvidence{all[i].point,
                                all[i].angle.cosine,
                                all[i].angle.key > kHalfTurnKey,
                                all[i].angle.degrees(),
                                context.state.pivot.endAngle.degrees(),
                                Verdict::SameAngle,
                                all[kept - 1].point};
        });
    }
    all.resize(kept);
}

/// May a listed neighbor enter the neighbor ring? Fills in the candidate as far as it gets.
Verdict testNeighbor(const StepContext& context, Index first, Index last, Candidate& c) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    const Index x = c.point;
    if (s.status[x] == kDone) return Verdict::AlreadyDone;
    if (x == first || x == last) return Verdict::OnRingEnd;
    c.offset = context.points.position[x] - n.frame.origin;
    // Beyond 180 degrees where the sector ends before: no need to know the angle, unless someone
    // wants to see it.
    if (context.log == nullptr && n.endAngle.key <= kHalfTurnKey &&
        glm::dot(n.frame.n, c.offset) < 0.0) {
        return Verdict::NotBeforeEnd;
    }
    c.lengthSq = glm::dot(c.offset, c.offset);
    c.angle = angleOf(n.frame, c.offset, c.lengthSq);
    const double tolerance = context.params.sameAngle;
    if (!(c.angle.key > n.startAngle.key + tolerance)) return Verdict::NotAfterStart;
    if (!strictlyBetween(c.angle, n.startAngle, n.endAngle, tolerance)) {
        return Verdict::NotBeforeEnd;
    }
    return Verdict::Kept;
}

}  // namespace

void phaseSort(StepContext& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    const Index p = s.rings.point(n.pivot);
    const Index first = s.rings.point(n.first);
    const Index last = s.rings.point(n.last);
    for (const Index x : context.points.neighbors[p]) {
        if (x == p) continue;
        Candidate c;
        c.point = x;
        const Verdict verdict = testNeighbor(context, first, last, c);
        note(context, Stage::Sort, [&] {
            return SortEvidence{x,
                                c.angle.cosine,
                                c.angle.key > kHalfTurnKey,
                                c.angle.degrees(),
                                n.endAngle.degrees(),
                                verdict,
                                kNone};
        });
        if (verdict == Verdict::Kept) n.candidates.push_back(c);
    }
    sortByAngle(n.candidates);
    keepNearestOfEachAngle(context);
    s.phase = Phase::Limits;
}

}  // namespace se
