/// All hits of a line are found by one run; stops in both directions are then binary searches in
/// the sorted hits, corrected for `skip` and `every`.
#include "spiraling_edge/run/breakpoint.h"

#include <algorithm>
#include <utility>

namespace se {
namespace {

std::uint64_t stepOf(const Breakpoint& breakpoint) {
    return std::max<std::uint64_t>(1, breakpoint.every);
}

/// The first hit number >= `from` that is picked.
std::uint64_t pickedFrom(const Breakpoint& breakpoint, std::uint64_t from) {
    const std::uint64_t step = stepOf(breakpoint);
    const std::uint64_t skip = breakpoint.skip;
    const std::uint64_t counted = from > skip ? from - skip : 1;
    return skip + (counted + step - 1) / step * step;
}

/// The last hit number <= `to` that is picked; 0 if there is none.
std::uint64_t pickedUpTo(const Breakpoint& breakpoint, std::uint64_t to) {
    const std::uint64_t step = stepOf(breakpoint);
    const std::uint64_t skip = breakpoint.skip;
    if (to < skip + step) return 0;
    return skip + (to - skip) / step * step;
}

/// Hits before `here`.
std::uint64_t countBefore(const HitList& list, RunPosition here) {
    const auto end =
        std::lower_bound(list.hits.begin(), list.hits.end(), here,
                         [](const Hit& hit, const RunPosition& at) { return hit.place < at; });
    return static_cast<std::uint64_t>(end - list.hits.begin());
}

/// The best stop of all breakpoints by the order of `isBetter`; `numberOf` gives the number of the
/// hit of each.
template <typename NumberOf, typename IsBetter>
std::optional<Stop> bestStop(std::span<const ArmedBreakpoint> armed, const NumberOf& numberOf,
                             const IsBetter& isBetter) {
    std::optional<Stop> best;
    for (std::size_t i = 0; i < armed.size(); ++i) {
        const Breakpoint& breakpoint = *armed[i].breakpoint;
        if (!breakpoint.on || breakpoint.logOnly) continue;
        const std::vector<Hit>& hits = armed[i].hits->hits;
        const std::uint64_t number = numberOf(breakpoint, *armed[i].hits);
        if (number == 0 || number > hits.size()) continue;
        const Hit& hit = hits[number - 1];
        if (!best || isBetter(hit.place, best->hit.place)) best = Stop{hit, i, number};
    }
    return best;
}

}  // namespace

bool selectsHit(const Breakpoint& breakpoint, std::uint64_t hit) {
    return hit > breakpoint.skip && (hit - breakpoint.skip) % stepOf(breakpoint) == 0;
}

std::uint64_t HitList::upTo(RunPosition here) const {
    const auto end =
        std::upper_bound(hits.begin(), hits.end(), here,
                         [](const RunPosition& at, const Hit& hit) { return at < hit.place; });
    return static_cast<std::uint64_t>(end - hits.begin());
}

PivotVisitor hitVisitor(const PointSet& points, const Params& params,
                        std::vector<DecisionQuery> queries,
                        std::function<void(std::size_t query, const Hit&, const Decision&)> found) {
    const bool failures = std::any_of(queries.begin(), queries.end(),
                                      [](const DecisionQuery& q) { return q.needsFailures(); });
    const auto onDecision = [queries = std::move(queries), found = std::move(found)](
                                const Decision& decision, RunPosition place) {
        for (std::size_t i = 0; i < queries.size(); ++i) {
            if (queries[i].matches(decision)) found(i, {place, decision.event.address}, decision);
        }
    };
    return decisionVisitor(points, params, failures, onDecision);
}

std::optional<Stop> nextStop(std::span<const ArmedBreakpoint> armed, RunPosition here) {
    const auto next = [here](const Breakpoint& breakpoint, const HitList& list) {
        return pickedFrom(breakpoint, list.upTo(here) + 1);
    };
    return bestStop(armed, next, std::less<>());
}

std::optional<Stop> previousStop(std::span<const ArmedBreakpoint> armed, RunPosition here) {
    const auto previous = [here](const Breakpoint& breakpoint, const HitList& list) {
        return pickedUpTo(breakpoint, countBefore(list, here));
    };
    return bestStop(armed, previous, std::greater<>());
}

}  // namespace se
