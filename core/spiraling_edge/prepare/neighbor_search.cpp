/// Neighbor lists of all points. How they are found only affects the time: distances are compared
/// exactly, ties by index, so that lists depend neither on the order of the tree (point_blocks.h),
/// nor on guesses (group_search.h), on threads or on a translation without rounding. Groups of
/// points are searched in parallel. O(n log n) for n points and short lists.
#include "spiraling_edge/prepare/neighbor_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/group_search.h"

namespace se {
namespace {

/// Choice: where many normals around a point oppose its own, as around a flipped normal, only this
/// many of the nearest points are examined. Without a bound such a point searches the whole set in
/// vain, and some percent of flipped normals make the search quadratic.
std::size_t maxExamined(std::size_t k) { return 8 * k + 64; }
/// Number of groups that are searched as one range, of 32 to 64 points each.
constexpr std::size_t kPerRange = 16;
/// Least number of ranges per thread.
constexpr std::size_t kRangesPerThread = 4;

/// The rule of lists among this many other points.
ListRule ruleOf(const NeighborOptions& options, std::size_t others) {
    ListRule rule;
    if (const auto* reach = std::get_if<WithinRadius>(&options.reach)) {
        rule.all = true;
        rule.squaredReach = std::min(rule.squaredReach, reach->radius * reach->radius);
    } else {
        rule.length = std::min(std::get<KNearest>(options.reach).k, others);
        rule.examined = maxExamined(rule.length);
    }
    return rule;
}

/// Finds the lists of a range of groups.
class RangeSearch {
  public:
    RangeSearch(const PointBlocks& blocks, std::span<const PointBlocks::Node* const> groups)
        : blocks_(blocks), groups_(groups) {}

    /// `normal` and `rule` as for GroupSearch. Guesses go from group to group, so that they do not
    /// depend on the threads.
    void run(std::span<const Vec3> normal, const ListRule& rule) {
        GroupSearch search(blocks_, normal, rule);
        for (const PointBlocks::Node* group : groups_) search.find(*group, found_, length_);
    }

    std::size_t entries() const { return found_.size(); }
    /// Writes the length of each list one position after its point, for partial sums.
    void writeLengths(std::vector<std::uint32_t>& offset) const {
        for (std::size_t i = 0; i < length_.size(); ++i)
            offset[idOf(i) + std::size_t{1}] = length_[i];
    }
    /// Copies the lists to the positions in `lists.offset`.
    void writeLists(NeighborLists& lists) const {
        auto from = found_.begin();
        for (std::size_t i = 0; i < length_.size(); ++i) {
            const auto to = from + length_[i];
            std::copy(from, to, lists.ids.begin() + lists.offset[idOf(i)]);
            from = to;
        }
    }

  private:
    Index idOf(std::size_t list) const { return blocks_.id(groups_[0]->firstSlot() + list); }

    const PointBlocks& blocks_;
    std::span<const PointBlocks::Node* const> groups_;
    std::vector<Index> found_;           // all lists, in the order of slots
    std::vector<std::uint32_t> length_;  // of each
};

/// Splits the points into ranges, and these over threads. Every list is found independently, so
/// that the number of threads affects only the time.
class NeighborSearch {
  public:
    NeighborSearch(std::span<const Vec3> position, std::span<const Vec3> normal,
                   const std::vector<bool>& usable, const NeighborOptions& options)
        : total_(position.size()),
          threads_(options.threads),
          blocks_(position, usable, options.threads) {
        if (blocks_.size() < 2) return;  // no neighbors
        if (!normal.empty()) {
            normal_.reserve(blocks_.size());
            for (std::size_t i = 0; i < blocks_.size(); ++i)
                normal_.push_back(normal[blocks_.id(i)]);
        }
        rule_ = ruleOf(options, blocks_.size() - 1);
        addGroups(blocks_.root());
    }

    Result<NeighborLists> run(const Progress& progress) {
        const std::span<const PointBlocks::Node* const> groups = groups_;
        for (std::size_t from = 0; from < groups.size(); from += kPerRange)
            ranges_.emplace_back(blocks_,
                                 groups.subspan(from, std::min(kPerRange, groups.size() - from)));
        if (!forEachWithProgress(ranges_.size(), threads_, kRangesPerThread, progress,
                                 [this](std::size_t i) { ranges_[i].run(normal_, rule_); })) {
            return Error{"the search for neighbors was cancelled"};
        }
        std::size_t entries = 0;
        for (const RangeSearch& range : ranges_) entries += range.entries();
        if (entries >= kNone) {
            return Error{
                "the neighbor lists would hold more than 4294967294 entries in all; "
                "choose a smaller k or radius"};
        }
        if (progress) progress(1.0);
        return withCoarseCorners(inOrderOfIndex(entries));
    }

  private:
    void addGroups(const PointBlocks::Node& node) {
        if (node.blocks <= GroupSearch::kMaxBlocks) return groups_.push_back(&node);
        addGroups(blocks_.leftOf(node));
        addGroups(blocks_.rightOf(node));
    }
    NeighborLists inOrderOfIndex(std::size_t entries) const {
        NeighborLists lists;
        lists.offset.assign(total_ + 1, 0);
        forEachItem(ranges_.size(), threads_, kRangesPerThread,
                    [&](std::size_t i) { ranges_[i].writeLengths(lists.offset); });
        std::partial_sum(lists.offset.begin(), lists.offset.end(), lists.offset.begin());
        lists.ids.resize(entries);
        forEachItem(ranges_.size(), threads_, kRangesPerThread,
                    [&](std::size_t i) { ranges_[i].writeLists(lists); });
        return lists;
    }

    /// Choice: where fewer than three neighbors agree, as at the corners of a tetrahedron, those
    /// that oppose are listed if their own lists are as short: they are no other sheet, which would
    /// have more.
    NeighborLists withCoarseCorners(NeighborLists lists) const {
        if (normal_.empty()) return lists;
        const std::size_t enough = rule_.all ? kGoRound : std::min(kGoRound, rule_.length);
        const auto isShort = [&](Index p) { return lists[p].size() < enough; };
        SingleSearch search(blocks_, {}, rule_);
        std::unordered_map<Index, std::vector<Index>> longer;
        for (std::size_t slot = 0; slot < blocks_.size(); ++slot) {
            const Index p = blocks_.id(slot);
            if (!isShort(p)) continue;
            const auto own = lists[p];
            const auto agrees = [&](Index q) {
                return std::find(own.begin(), own.end(), q) != own.end();
            };
            std::vector<Index>& list = longer[p];
            for (const Neighbor& each : search.list(slot)) {
                if (isShort(each.id) || agrees(each.id)) list.push_back(each.id);
            }
            // What agrees may be farther than all of these.
            for (const Index q : own) {
                if (std::find(list.begin(), list.end(), q) == list.end()) list.push_back(q);
            }
        }
        if (longer.empty()) return lists;
        NeighborLists all;
        for (Index p = 0; p < total_; ++p) {
            const auto found = longer.find(p);
            all.append(found == longer.end() ? lists[p] : std::span<const Index>(found->second));
        }
        return all;
    }

    std::size_t total_;
    unsigned threads_;
    PointBlocks blocks_;
    std::vector<Vec3> normal_;  // by slot; empty: opposing ones are not left out
    ListRule rule_;
    std::vector<const PointBlocks::Node*> groups_;
    std::vector<RangeSearch> ranges_;
};

[[maybe_unused]] bool areFinite(std::span<const Vec3> position, const std::vector<bool>& usable) {
    for (std::size_t p = 0; p < position.size(); ++p) {
        if (usable[p] && !isFinite(position[p])) return false;
    }
    return true;
}

/// Mean distance to the nearest point; 1 if no point has one: then no radius finds any.
double meanSpacing(std::span<const Vec3> position, const NeighborLists& nearest) {
    double sum = 0.0;
    std::size_t count = 0;
    for (Index p = 0; p < nearest.size(); ++p) {
        if (nearest[p].empty()) continue;
        sum += std::sqrt(distanceSquared(position[p], position[nearest[p].front()]));
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

/// Searches the nearest point of each first, for the spacing.
Result<NeighborLists> withinSpacings(double spacings, std::span<const Vec3> position,
                                     std::span<const Vec3> normal, const std::vector<bool>& usable,
                                     NeighborOptions options, const Progress& progress) {
    constexpr double kNearestShare = 0.3;
    options.reach = KNearest{1};
    const Result<NeighborLists> nearest =
        NeighborSearch(position, normal, usable, options).run(partOf(progress, 0.0, kNearestShare));
    if (!nearest) return nearest.error();
    options.reach = WithinRadius{spacings * meanSpacing(position, nearest.value())};
    return NeighborSearch(position, normal, usable, options)
        .run(partOf(progress, kNearestShare, 1.0));
}

}  // namespace

void sortNearestFirst(std::span<const Vec3> position, Index p, std::vector<Index>& list) {
    std::vector<Neighbor> neighbors;
    neighbors.reserve(list.size());
    assert(list.empty() || isFinite(position[p]));
    for (const Index q : list) {
        assert(isFinite(position[q]));
        neighbors.push_back({distanceSquared(position[p], position[q]), q});
    }
    std::sort(neighbors.begin(), neighbors.end());
    // Repeated entries have the same distance and are now adjacent.
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    list.clear();
    for (const Neighbor& neighbor : neighbors) list.push_back(neighbor.id);
}

Status checkReach(const NeighborOptions& options) {
    if (const auto* reach = std::get_if<WithinRadius>(&options.reach)) {
        if (reach->radius > 0.0) return success();
        return Error{"the radius of neighbor lists must be positive, but is " +
                     std::to_string(reach->radius)};
    }
    if (const auto* reach = std::get_if<WithinSpacings>(&options.reach)) {
        if (reach->spacings > 0.0) return success();
        return Error{"the reach of neighbor lists must be positive, but is " +
                     std::to_string(reach->spacings) + " spacings"};
    }
    if (std::get<KNearest>(options.reach).k > 0) return success();
    return Error{"the number of neighbors per point must be positive, but is 0"};
}

Result<NeighborLists> findNeighbors(std::span<const Vec3> position, std::span<const Vec3> normal,
                                    const std::vector<bool>& usable, const NeighborOptions& options,
                                    const Progress& progress) {
    if (Status status = checkReach(options); !status) return status.error();
    const std::size_t n = position.size();
    if (n >= kNone)
        return Error{"there are " + std::to_string(n) + " points; at most 4294967294 are possible"};
    if (usable.size() != n || (options.dropOpposingNormals && normal.size() != n)) {
        return Error{"there are " + std::to_string(n) + " positions, but " +
                     std::to_string(normal.size()) + " normals and " +
                     std::to_string(usable.size()) + " marks of usable points"};
    }
    assert(areFinite(position, usable));
    if (!options.dropOpposingNormals) normal = {};
    if (const auto* reach = std::get_if<WithinSpacings>(&options.reach))
        return withinSpacings(reach->spacings, position, normal, usable, options, progress);
    return NeighborSearch(position, normal, usable, options).run(progress);
}

}  // namespace se
