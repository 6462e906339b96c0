/// The inverse of all lists by a counting sort, then each list merged with its inverse, in parallel
/// by blocks of points. O(list entries log longest list).
#include <algorithm>
#include <numeric>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

/// The rows of points from .. to, one list after the other.
struct ListBlock {
    std::vector<Index> ids;
    std::vector<std::uint32_t> length;
};

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
                                     unsigned threads, const Progress& progress) {
    const std::size_t n = position.size();
    if (2 * lists.ids.size() >= kNone) {
        return Error{
            "symmetric neighbor lists could hold more than 4294967294 entries in all; "
            "choose a smaller k or radius"};
    }
    NeighborLists listedBy = listersOf(lists);
    constexpr std::size_t kPerBlock = 4096;
    std::vector<ListBlock> blocks((n + kPerBlock - 1) / kPerBlock);
    const bool all = forEachWithProgress(blocks.size(), threads, 2, progress, [&](std::size_t i) {
        std::vector<Neighbor> row;
        const auto end = static_cast<Index>(std::min((i + 1) * kPerBlock, n));
        for (auto p = static_cast<Index>(i * kPerBlock); p < end; ++p) {
            row.clear();
            for (const auto list : {lists[p], listedBy[p]}) {
                for (const Index q : list)
                    row.push_back({distanceSquared(position[p], position[q]), q});
            }
            std::sort(row.begin(), row.end());
            row.erase(std::unique(row.begin(), row.end()), row.end());
            for (const Neighbor& neighbor : row) blocks[i].ids.push_back(neighbor.id);
            blocks[i].length.push_back(static_cast<std::uint32_t>(row.size()));
        }
    });
    if (!all) return Error{"making neighbor lists symmetric was cancelled"};
    listedBy = {};  // Each of these takes as much memory as all lists.
    NeighborLists both;
    both.offset.reserve(n + 1);
    std::size_t entries = 0;
    for (const ListBlock& each : blocks) entries += each.ids.size();
    both.ids.reserve(entries);
    for (ListBlock& each : blocks) {
        both.ids.insert(both.ids.end(), each.ids.begin(), each.ids.end());
        for (const std::uint32_t length : each.length)
            both.offset.push_back(both.offset.back() + length);
        each = {};
    }
    return both;
}

}  // namespace se
