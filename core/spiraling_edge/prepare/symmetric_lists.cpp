/// Each list gets the points that list its point and are not in it yet, by counting, and is sorted,
/// in parallel. O(list entries times longest list).
#include <algorithm>
#include <numeric>
#include <utility>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

/// The first entries of the list of p.
std::span<const Index> firstOf(const NeighborLists& lists, Index p, std::size_t most) {
    return lists[p].first(std::min(most, lists[p].size()));
}

/// The first entries of each list, followed by the points that have it among theirs and are not
/// among its own. `mutual`: of each entry of `lists`, whether its point has this one, too.
NeighborLists withListers(const NeighborLists& lists, std::size_t most,
                          const std::vector<std::uint8_t>& mutual) {
    NeighborLists both;
    both.offset.assign(lists.size() + 1, 0);
    const auto forEachLister = [&](const auto& add) {
        for (Index p = 0; p < lists.size(); ++p) {
            std::size_t entry = lists.offset[p];
            for (const Index q : firstOf(lists, p, most)) {
                if (mutual[entry++] == 0) add(q, p);
            }
        }
    };
    for (Index p = 0; p < lists.size(); ++p)
        both.offset[p + std::size_t{1}] =
            static_cast<std::uint32_t>(firstOf(lists, p, most).size());
    forEachLister([&](Index q, Index /*p*/) { ++both.offset[q + std::size_t{1}]; });
    std::partial_sum(both.offset.begin(), both.offset.end(), both.offset.begin());
    both.ids.resize(both.offset.back());
    std::vector<std::uint32_t> next(both.offset.begin(), both.offset.end() - 1);
    for (Index p = 0; p < lists.size(); ++p) {
        for (const Index q : firstOf(lists, p, most)) both.ids[next[p]++] = q;
    }
    forEachLister([&](Index q, Index p) { both.ids[next[q]++] = p; });
    return both;
}

/// Shortens each list to this length, in place.
void shorten(const std::vector<std::uint32_t>& length, NeighborLists& lists) {
    std::uint32_t end = 0;
    for (Index p = 0; p < length.size(); ++p) {
        const auto from = lists.ids.begin() + lists.offset[p];
        lists.offset[p] = end;
        std::copy(from, from + length[p], lists.ids.begin() + end);
        end += length[p];
    }
    lists.offset.back() = end;
    lists.ids.resize(end);
    lists.ids.shrink_to_fit();
}

}  // namespace

NeighborLists listersOf(const NeighborLists& lists) {
    const std::size_t n = lists.size();
    NeighborLists turned;
    turned.offset.assign(n + 1, 0);
    for (const Index q : lists.ids) ++turned.offset[q + std::size_t{1}];
    std::partial_sum(turned.offset.begin(), turned.offset.end(), turned.offset.begin());
    turned.ids.resize(lists.ids.size());
    std::vector<std::uint32_t> next = turned.offset;
    for (Index p = 0; p < n; ++p) {
        for (const Index q : lists[p]) turned.ids[next[q]++] = p;
    }
    return turned;
}

Result<NeighborLists> symmetricLists(std::span<const Vec3> position, const NeighborLists& lists,
                                     unsigned threads, const Progress& progress, std::size_t most) {
    const std::size_t n = position.size();
    if (2 * std::min(lists.ids.size(), most * n) >= kNone) {
        return Error{
            "symmetric neighbor lists could hold more than 4294967294 entries in all; "
            "choose a smaller k or radius"};
    }
    constexpr std::size_t kPerThread = 4096;
    constexpr double kMutualDone = 0.3;
    const Error cancelled{"making neighbor lists symmetric was cancelled"};
    std::vector<std::uint8_t> mutual(lists.ids.size(), 0);
    const auto findMutual = [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        std::size_t entry = lists.offset[p];
        for (const Index q : firstOf(lists, p, most)) {
            mutual[entry++] = isAmong(p, firstOf(lists, q, most)) ? 1 : 0;
        }
    };
    if (!forEachWithProgress(n, threads, kPerThread, partOf(progress, 0.0, kMutualDone),
                             findMutual))
        return cancelled;
    NeighborLists both = withListers(lists, most, std::exchange(mutual, {}));
    std::vector<std::uint32_t> length(n);
    const auto sortRow = [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        std::vector<Index> row(both[p].begin(), both[p].end());
        sortNearestFirst(position, p, row);
        std::copy(row.begin(), row.end(), both.ids.begin() + both.offset[p]);
        length[p] = static_cast<std::uint32_t>(row.size());
    };
    if (!forEachWithProgress(n, threads, kPerThread, partOf(progress, kMutualDone, 1.0), sortRow))
        return cancelled;
    shorten(length, both);
    return both;
}

}  // namespace se
