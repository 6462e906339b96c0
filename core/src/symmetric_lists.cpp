#include <algorithm>
#include <numeric>

#include "prepare_neighbors.h"

namespace se {

namespace {

/// For each point, who lists it.
NeighborLists turnedRound(const NeighborLists& lists) {
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

}  // namespace

Result<NeighborLists> symmetricLists(std::span<const Vec3> position, const NeighborLists& lists) {
    const auto n = static_cast<Index>(position.size());
    if (2 * lists.ids.size() >= kNone) {
        return Error{
            "symmetric neighbor lists could hold more than 4294967294 entries in all; "
            "choose a smaller k or radius"};
    }
    const NeighborLists listedBy = turnedRound(lists);
    NeighborLists both;
    both.offset.reserve(std::size_t{n} + 1);
    std::vector<Neighbor> row;
    std::vector<Index> ids;
    const auto add = [&](Index p, std::span<const Index> others) {
        for (const Index q : others) row.push_back({distanceSquared(position[p], position[q]), q});
    };
    for (Index p = 0; p < n; ++p) {
        row.clear();
        add(p, lists[p]);
        add(p, listedBy[p]);
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
        ids.clear();
        for (const Neighbor& neighbor : row) ids.push_back(neighbor.id);
        both.append(ids);
    }
    return both;
}

}  // namespace se
