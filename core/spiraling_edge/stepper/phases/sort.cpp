/// §6.1, Fig. 3: the listed neighbors between start and end, sorted by angle. Angles are keys
/// without an arccosine, and the inner loops avoid branches that could not be predicted. O(list),
/// plus the sort.
#include <algorithm>
#include <array>

#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// Lists are processed in pieces of this length, in arrays on the stack.
constexpr std::size_t kPieceOfList = 32;

/// Stable sort by angle: lists come nearest first, so points of the same angle stay in order of
/// distance. Short lists are sorted by counting, without branches to mispredict.
void sortByAngle(const std::vector<Candidate>& listed, std::vector<Candidate>& sorted) {
    const std::size_t count = listed.size();
    if (count > kPieceOfList) {
        sorted = listed;
        std::stable_sort(sorted.begin(), sorted.end(), [](const Candidate& a, const Candidate& b) {
            return a.angle.key < b.angle.key;
        });
        return;
    }
    std::array<unsigned, kPieceOfList> place;
    std::array<double, kPieceOfList> key;
    for (std::size_t i = 0; i < count; ++i) {
        key[i] = listed[i].angle.key;
        unsigned before = 0;
        for (std::size_t j = 0; j < i; ++j) {
            const unsigned after = key[j] > key[i] ? 1U : 0U;
            place[j] += after;
            before += 1U - after;
        }
        place[i] = before;
    }
    sorted.resize(count);
    for (std::size_t i = 0; i < count; ++i) sorted[place[i]] = listed[i];
}

SortEvidence sortEvidence(const StepContext& context, Index x, const Angle& angle,
                          Verdict verdict) {
    const double limit = context.state.pivot.endAngle.degrees();
    return {x, angle.cosine, angle.key > kHalfTurnKey, angle.degrees(), limit, verdict, kNone};
}

/// "If two neighboring points are found to have the same angle, the point closest to p is included
/// in the ring and the other point is eliminated from consideration."
void keepNearestOfEachAngle(AnyContext auto& context) {
    std::vector<Candidate>& all = context.state.pivot.candidates;
    const auto sameAngle = [&](const Candidate& a, const Candidate& b) {
        return b.angle.key - a.angle.key <= context.params.sameAngle;
    };
    const TieRule tie = paperRules(context).tie;
    const auto twin = std::adjacent_find(all.begin(), all.end(), sameAngle);
    if (twin == all.end() || tie == TieRule::Both) return;
    auto kept = static_cast<std::size_t>(twin - all.begin()) + 1;
    for (std::size_t i = kept; i < all.size(); ++i) {
        const bool same = sameAngle(all[kept - 1], all[i]);
        if (!same) {
            all[kept++] = all[i];
            continue;
        }
        const double farther = all[i].lengthSq - all[kept - 1].lengthSq;
        if (tie == TieRule::Nearest ? farther < 0.0 : farther > 0.0) {
            std::swap(all[i], all[kept - 1]);
        }
        note(context, Stage::Sort, [&] {
            SortEvidence e = sortEvidence(context, all[i].point, all[i].angle, Verdict::SameAngle);
            e.rival = all[kept - 1].point;
            e.farther = all[i].lengthSq - all[kept - 1].lengthSq;
            return e;
        });
    }
    all.resize(kept);
}

/// The angle that no candidate may reach: that of last, unless PaperRules::maxAngle is off.
const Angle& endOf(const AnyContext auto& context) {
    return paperRules(context).maxAngle ? context.state.pivot.endAngle : kFullTurn;
}

/// The verdict on a listed neighbor: Kept if it enters the neighbor ring.
Verdict explainNeighbor(const AnyContext auto& context, Index x, const Angle& angle) {
    const State& s = context.state;
    const NeighborRing& n = s.pivot;
    if (s.status[x] == kDone) return Verdict::AlreadyDone;
    if (x == s.rings.point(n.first) || x == s.rings.point(n.last)) return Verdict::OnRingEnd;
    if (!(angle.key > n.startAngle.key + context.params.sameAngle)) return Verdict::NotAfterStart;
    return strictlyBetween(angle, n.startAngle, endOf(context), context.params.sameAngle)
               ? Verdict::Kept
               : Verdict::NotBeforeEnd;
}

/// The verdict on a listed neighbor after what-ifs: a point left out by its angle cannot be kept.
Verdict verdictOn(const AnyContext auto& context, Index x, const Angle& angle) {
    const Verdict verdict = explainNeighbor(context, x, angle);
    const bool dropped =
        verdict == Verdict::Kept && findWhatIfOverride(context, Stage::Sort, x) == false;
    return dropped ? Verdict::WhatIfDropped : verdict;
}

/// Removes the candidates that a what-if drops.
void dropUnwanted(LoggedContext& context) {
    std::erase_if(context.state.pivot.candidates, [&](const Candidate& c) {
        return findWhatIfOverride(context, Stage::Sort, c.point) == false;
    });
}

void explainNeighbors(AnyContext auto& context, std::span<const Index> list) {
    const NeighborRing& n = context.state.pivot;
    for (const Index x : list) {
        note(context, Stage::Sort, [&] {
            const Angle angle = angleOf(n.frame, context.points.position[x] - n.frame.origin);
            return sortEvidence(context, x, angle, verdictOn(context, x, angle));
        });
    }
}

/// The points of `list` that are not DONE and at neither end of the sector, moved to the front of
/// `free`; returns their number. No branch, since it would be unpredictable.
std::size_t freePoints(const State& s, std::span<const Index> list,
                       std::array<Index, kPieceOfList>& free) {
    const Index first = s.rings.point(s.pivot.first);
    const Index last = s.rings.point(s.pivot.last);
    std::size_t count = 0;
    for (const Index x : list) {
        free[count] = x;
        count += static_cast<std::size_t>(s.status[x] != kDone) &
                 static_cast<std::size_t>(x != first) & static_cast<std::size_t>(x != last);
    }
    return count;
}

/// Appends the points of `list` that lie between start and end as candidates.
void addCandidates(AnyContext auto& context, std::span<const Index> list) {
    NeighborRing& n = context.state.pivot;
    std::array<Index, kPieceOfList> free;
    const std::size_t count = freePoints(context.state, list, free);
    const Angle end = endOf(context);
    for (std::size_t i = 0; i < count; ++i) {
        Candidate c;
        c.point = free[i];
        c.offset = context.points.position[c.point] - n.frame.origin;
        c.lengthSq = glm::dot(c.offset, c.offset);
        c.angle = angleOf(n.frame, c.offset, c.lengthSq);
        if (strictlyBetween(c.angle, n.startAngle, end, context.params.sameAngle)) {
            n.listed.push_back(c);
        }
    }
}

}  // namespace

void phaseSort(AnyContext auto& context) {
    State& s = context.state;
    NeighborRing& n = s.pivot;
    std::span<const Index> list = context.points.neighbors[s.rings.point(n.pivot)];
    explainNeighbors(context, list);
    n.listed.clear();
    while (!list.empty()) {
        const std::size_t size = std::min(kPieceOfList, list.size());
        addCandidates(context, list.first(size));
        list = list.subspan(size);
    }
    sortByAngle(n.listed, n.candidates);
    if constexpr (kLogging<std::remove_reference_t<decltype(context)>>) dropUnwanted(context);
    keepNearestOfEachAngle(context);
    s.phase = Phase::Limits;
}

template void phaseSort(UnloggedContext&);
template void phaseSort(LoggedContext&);

}  // namespace se
