/// Each list gets the points that list its point, by counting, and is sorted without repeated
/// entries, in parallel. O(list entries log longest list).
#include <algorithm>
#include <numeric>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

/// The first entries of each list, followed by the points that have it among theirs.
NeighborLists withListers(const NeighborLists& lists, std::size_t most) {
    const auto firstOf = [&](Index p) { return lists[p].first(std::min(most, lists[p].size())); };
    NeighborLists both;
    both.offset.assign(lists.size() + 1, 0);
    for (Index p = 0; p < lists.size(); ++p) {
        both.offset[p + std::size_t{1}] += static_cast<std::uint32_t>(firstOf(p).size());
        for (const Index q : firstOf(p)) ++both.offset[q + std::size_t{1}];
    }
    std::partial_sum(both.offset.begin(), both.offset.end(), both.offset.begin());
    both.ids.resize(both.offset.back());
    std::vector<std::uint32_t> next(both.offset.begin(), both.offset.end() - 1);
    for (Index p = 0; p < lists.size(); ++p) {
        for (const Index q : firstOf(p)) {
            both.ids[next[p]++] = q;
            both.ids[next[q]++] = p;
        }
    }
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
    NeighborLists both = withListers(lists, most);
    std::vector<std::uint32_t> length(n);
    constexpr std::size_t kPerThread = 4096;
    const bool all = forEachWithProgress(n, threads, kPerThread, progress, [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        std::vector<Index> row(both[p].begin(), both[p].end());
        sortNearestFirst(position, p, row);
        std::copy(row.begin(), row.end(), both.ids.begin() + both.offset[p]);
        length[p] = static_cast<std::uint32_t>(row.size());
    });
    if (!all) return Error{"making neighbor lists symmetric was cancelled"};
    shorten(length, both);
    return both;
}

}  // namespace se
