/// Each list gets the points that list its point without being listed by it, by counting, and is
/// sorted again, in parallel by blocks of points. O(list entries log longest list).
#include <algorithm>
#include <cassert>
#include <numeric>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"

namespace se {

namespace {

/// The question whether a list has an entry: answered by a scan, or in long lists by a search among
/// sorted copies.
class Entries {
  public:
    explicit Entries(const NeighborLists& lists) : lists_(lists) {
        constexpr std::size_t kScanned = 64;
        std::size_t longest = 0;
        for (Index p = 0; p < lists.size(); ++p) longest = std::max(longest, lists[p].size());
        if (longest <= kScanned) return;
        sorted_ = lists;
        for (Index p = 0; p < lists.size(); ++p) {
            std::sort(sorted_.ids.begin() + sorted_.offset[p],
                      sorted_.ids.begin() + sorted_.offset[p + std::size_t{1}]);
        }
    }
    /// Calls add(q, p) for each point p and each q in its list that does not list p.
    template <typename Add>
    void forEachOneWay(const Add& add) const {
        for (Index p = 0; p < lists_.size(); ++p) {
            for (const Index q : lists_[p])
                if (!has(q, p)) add(q, p);
        }
    }

  private:
    bool has(Index p, Index q) const {
        if (!sorted_.ids.empty()) {
            const auto list = sorted_[p];
            return std::binary_search(list.begin(), list.end(), q);
        }
        const auto list = lists_[p];
        return std::find(list.begin(), list.end(), q) != list.end();
    }

    const NeighborLists& lists_;
    NeighborLists sorted_;
};

/// The lists with the inverse of each entry, in any order.
NeighborLists withInverses(const NeighborLists& lists) {
    NeighborLists both;
    both.offset.assign(lists.size() + 1, 0);
    const Entries entries(lists);
    entries.forEachOneWay([&](Index q, Index) { ++both.offset[q + std::size_t{1}]; });
    for (Index p = 0; p < lists.size(); ++p) {
        both.offset[p + std::size_t{1}] +=
            both.offset[p] + static_cast<std::uint32_t>(lists[p].size());
    }
    both.ids.resize(both.offset.back());
    std::vector<std::uint32_t> next(both.offset.begin(), both.offset.end() - 1);
    for (Index p = 0; p < lists.size(); ++p) {
        std::copy(lists[p].begin(), lists[p].end(), both.ids.begin() + next[p]);
        next[p] += static_cast<std::uint32_t>(lists[p].size());
    }
    entries.forEachOneWay([&](Index q, Index p) { both.ids[next[q]++] = p; });
    return both;
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
                                     unsigned threads, const Progress& progress) {
    const std::size_t n = position.size();
    if (2 * lists.ids.size() >= kNone) {
        return Error{
            "symmetric neighbor lists could hold more than 4294967294 entries in all; "
            "choose a smaller k or radius"};
    }
    NeighborLists both = withInverses(lists);
    constexpr std::size_t kPerBlock = 4096;
    const std::size_t blocks = (n + kPerBlock - 1) / kPerBlock;
    const bool all = forEachWithProgress(blocks, threads, 2, progress, [&](std::size_t i) {
        std::vector<Neighbor> row;
        const auto end = static_cast<Index>(std::min((i + 1) * kPerBlock, n));
        for (auto p = static_cast<Index>(i * kPerBlock); p < end; ++p) {
            row.clear();
            for (const Index q : both[p])
                row.push_back({distanceSquared(position[p], position[q]), q});
            std::sort(row.begin(), row.end());
            assert(std::adjacent_find(row.begin(), row.end()) == row.end());
            std::transform(row.begin(), row.end(), both.ids.begin() + both.offset[p],
                           [](const Neighbor& neighbor) { return neighbor.id; });
        }
    });
    if (!all) return Error{"making neighbor lists symmetric was cancelled"};
    return both;
}

}  // namespace se
