/// Neighbor lists of all points. How they are found only affects the time: distances are compared
/// exactly, ties by index, so that lists depend neither on the order of the tree (point_blocks.h),
/// nor on guesses, on threads or on a translation without rounding. Groups of points are searched
/// in parallel. O(n log n) for n points and short lists.
#include "spiraling_edge/prepare/neighbor_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/rank_sort.h"
#include "spiraling_edge/prepare/single_search.h"

namespace se {
namespace {

// ---- a group of points --------------------------------------------------------------------------

// Most of the time goes into three loops without branches that depend on the points: which boxes
// are near, which points are, and which of two is nearer. Whatever the guess, lists are those of
// SingleSearch.

constexpr std::size_t kBlock = PointBlocks::kBlock;
/// Points are expected within this times the squared distance of the last list's end.
constexpr double kGuessFactor = 1.25;
/// Blocks are collected within this times the squared distance of the guess: one of them that was
/// too small can be doubled.
constexpr double kReachFactor = 2.0;
/// Blocks are collected again if the reach is this times too large.
constexpr double kTooFarFactor = 8.0;
/// A group has not more blocks near it than these and one for each entry of a list. Where points
/// are dense beside sparse ones, more lie within the reach of the sparse.
constexpr std::size_t kMaxNearBlocks = 256;

double clamped(double x, double low, double high) {
    const double above = x < low ? low : x;
    return above > high ? high : above;
}

/// Collects the blocks near a group of points once, and of them, for each point, all points within
/// a guessed distance: most likely a few more than are listed. A guess that was too small is seen
/// from their number. Points whose neighbors are not found so are searched one by one.
class GroupSearch {
  public:
    /// Maximum number of blocks of a group. Few larger ones cost less for each point, and
    /// more smaller ones have fewer blocks near them.
    static constexpr std::size_t kMaxBlocks = 8;

    /// As of SingleSearch.
    GroupSearch(const PointBlocks& blocks, std::span<const Vec3> normal, const ListRule& rule)
        : blocks_(blocks), normal_(normal), rule_(rule), single_(blocks, normal, rule) {}

    /// Appends the lists of the group's points, in the order of slots, and the length of each.
    void find(const PointBlocks::Node& group, std::vector<Index>& ids,
              std::vector<std::uint32_t>& length) {
        bool crowded = bound() > 0.0 && !collect(group.box);
        if (crowded && !group.isBlock()) {
            find(blocks_.leftOf(group), ids, length);
            find(blocks_.rightOf(group), ids, length);
            return;
        }
        const std::size_t from = group.firstSlot();
        const std::size_t to = std::min(from + group.blocks * kBlock, blocks_.size());
        for (std::size_t slot = from; slot < to; ++slot) {
            const bool unfit = reach_ < bound() || reach_ > kTooFarFactor * kReachFactor * bound();
            if (unfit && !rule_.all && !crowded) crowded = !collect(group.box);
            const std::size_t before = ids.size();
            list(slot, ids);
            length.push_back(static_cast<std::uint32_t>(ids.size() - before));
        }
    }

  private:
    static constexpr std::size_t kBoxes = 4;
    /// Boxes of some blocks, for tests of all of them together.
    struct Boxes {
        std::array<std::array<double, kBoxes>, 3> low, high;
        std::array<std::uint32_t, kBoxes> block;
    };

    /// Squared distance within which the next list is expected to end; 0: unknown. Always finite:
    /// slots without a point are not within it.
    double bound() const {
        return rule_.all ? rule_.squaredReach : std::min(kGuessFactor * last_, rule_.squaredReach);
    }
    /// Collects the blocks near a box. False, with none collected, if they are too many.
    bool collect(const Box& box) {
        const double squaredReach = std::min(kReachFactor * bound(), rule_.squaredReach);
        near_.clear();
        std::size_t count = 0;
        const bool few =
            blocks_.forBlocksNear(box, squaredReach, [&](const PointBlocks::Node& node) {
                const std::size_t i = count++ % kBoxes;
                if (i == 0) {
                    near_.emplace_back();
                    // Boxes that are left over are infinitely far away.
                    near_.back().low[0].fill(std::numeric_limits<double>::infinity());
                    near_.back().high = near_.back().low;
                }
                Boxes& boxes = near_.back();
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const auto component = static_cast<Vec3::length_type>(axis);
                    boxes.low[axis][i] = node.box.low[component];
                    boxes.high[axis][i] = node.box.high[component];
                }
                boxes.block[i] = node.first;
                return rule_.all || count <= kMaxNearBlocks + rule_.length;
            });
        if (!few) near_.clear();
        reach_ = few ? squaredReach : 0.0;
        const std::size_t capacity = near_.size() * kBoxes;
        if (hit_.size() < capacity) {
            hit_.resize(capacity);
            distance_.resize(capacity * kBlock);
            slot_.resize(capacity * kBlock);
            accepted_.resize(capacity * kBlock);
        }
        return few;
    }
    /// Fills hit_ with the blocks whose boxes are within the bound; returns their number. The
    /// distance of a box is that of its place nearest to p, computed as for a point: so it is never
    /// above that of a point in it.
    std::size_t hitBlocks(const Vec3& p, double bound) {
        std::size_t hits = 0;
        for (const Boxes& boxes : near_) {
            std::array<double, kBoxes> gap;
            for (std::size_t i = 0; i < kBoxes; ++i) {
                const double x = clamped(p.x, boxes.low[0][i], boxes.high[0][i]) - p.x;
                const double y = clamped(p.y, boxes.low[1][i], boxes.high[1][i]) - p.y;
                const double z = clamped(p.z, boxes.low[2][i], boxes.high[2][i]) - p.z;
                gap[i] = x * x + y * y + z * z;
            }
            for (std::size_t i = 0; i < kBoxes; ++i) {
                hit_[hits] = boxes.block[i];
                hits += gap[i] <= bound ? 1 : 0;
            }
        }
        return hits;
    }
    /// Fills distance_ and slot_ with the points within the bound; returns their number.
    std::size_t gather(const Vec3& p, double bound) {
        const std::size_t hits = hitBlocks(p, bound);
        double* distances = distance_.data();
        std::uint32_t* slots = slot_.data();
        std::size_t count = 0;
        for (std::size_t hit = 0; hit < hits; ++hit) {
            const std::uint32_t block = hit_[hit];
            const PointBlocks::PerPoint distance = blocks_.squaredDistances(block, p);
            for (std::uint32_t i = 0; i < kBlock; ++i) {
                distances[count] = distance[i];
                slots[count] = block * std::uint32_t{kBlock} + i;
                count += distance[i] <= bound ? 1 : 0;
            }
        }
        return count;
    }
    /// Fills accepted_ with those of the gathered points that may be listed. False if that takes a
    /// closer look: a point apart from this one is so near that the square of the distance is 0.
    bool accept(std::size_t slot, std::size_t count) {
        std::size_t apart = 0;
        std::size_t accepts = 0;
        for (std::size_t i = 0; i < count; ++i) {
            accepted_[accepts] = {distance_[i], blocks_.id(slot_[i])};
            const bool isApart = distance_[i] > 0.0;
            apart += isApart ? 1 : 0;
            const bool opposes = !normal_.empty() && normalsOppose(normal_[slot], normal_[slot_[i]],
                                                                   rule_.opposingCosine);
            accepts += isApart && !opposes ? 1 : 0;
        }
        acceptedCount_ = accepts;
        if (apart + 1 == count) return true;  // but for the point itself
        const Vec3 place = blocks_.position(slot);
        for (std::size_t i = 0; i < count; ++i) {
            if (distance_[i] == 0.0 && blocks_.position(slot_[i]) != place) return false;
        }
        return true;
    }
    /// The accepted points in the order of lists, as many as are listed.
    std::span<const Neighbor> sortAccepted(double bound) {
        const std::size_t length = rule_.all ? acceptedCount_ : rule_.length;
        if (acceptedCount_ <= kMaxRanked) {
            rankSort({accepted_.data(), acceptedCount_}, bound, ranked_.data());
            return {ranked_.data(), length};
        }
        const auto at = [this](std::size_t i) {
            return accepted_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(0), at(length), at(acceptedCount_));
        std::sort(at(0), at(length));
        return {accepted_.data(), length};
    }
    /// Appends the list of a point if it is sure that it ends within the bound.
    bool listWithin(std::size_t slot, double bound, std::vector<Index>& ids) {
        const std::size_t count = gather(blocks_.position(slot), bound);
        // More points than are examined, besides the point itself.
        if (!rule_.all && !normal_.empty() && count > rule_.examined + 1) return false;
        if (!accept(slot, count)) return false;
        if (!rule_.all && acceptedCount_ < rule_.length) return false;
        const std::span<const Neighbor> list = sortAccepted(bound);
        for (const Neighbor& neighbor : list) ids.push_back(neighbor.id);
        if (!rule_.all) last_ = list.back().distanceSquared;
        return true;
    }
    void list(std::size_t slot, std::vector<Index>& ids) {
        for (double tried = bound(); tried > 0.0 && tried <= reach_; tried *= 2.0) {
            if (listWithin(slot, tried, ids)) return;
        }
        const std::span<const Neighbor> list = single_.list(slot);
        for (const Neighbor& neighbor : list) ids.push_back(neighbor.id);
        if (!list.empty() && list.size() == rule_.length) last_ = list.back().distanceSquared;
    }

    const PointBlocks& blocks_;
    std::span<const Vec3> normal_;
    const ListRule& rule_;
    SingleSearch single_;
    double last_ = 0.0;   // squared distance of the last point of the last full list; 0: none yet
    double reach_ = 0.0;  // squared distance within which blocks were collected
    std::vector<Boxes> near_;         // the blocks that were collected
    std::vector<std::uint32_t> hit_;  // those of them near one point
    // Points of these blocks within the bound, and those of them that may be listed.
    std::vector<double> distance_;
    std::vector<std::uint32_t> slot_;
    std::vector<Neighbor> accepted_;
    std::size_t acceptedCount_ = 0;
    std::array<Neighbor, kMaxRanked> ranked_;
};

// ---- all points ---------------------------------------------------------------------------------

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
    rule.opposingCosine = options.opposingCosine;
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
    /// As run(), and moves the lists to the positions in `lists.offset`.
    void runInto(std::span<const Vec3> normal, const ListRule& rule, NeighborLists& lists) {
        run(normal, rule);
        writeLists(lists);
        freeList(found_);
    }

    std::size_t entries() const {
        return std::accumulate(length_.begin(), length_.end(), std::size_t{0});
    }
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
    std::vector<Index> found_;           // all lists, in the order of slots, until they are moved
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
        // Lists of a known length are moved to their places at once: where most points are usable,
        // the search needs hardly more room than they do.
        const std::uint64_t most = std::uint64_t{total_} * rule_.length;
        const bool known = !rule_.all && most < kNone && 2 * blocks_.size() > total_;
        NeighborLists lists = known ? spacedLists() : NeighborLists{};
        const auto find = [&](std::size_t i) {
            if (known) return ranges_[i].runInto(normal_, rule_, lists);
            ranges_[i].run(normal_, rule_);
        };
        if (!forEachWithProgress(ranges_.size(), threads_, kRangesPerThread, progress, find))
            return Error{"the search for neighbors was cancelled"};
        std::size_t entries = 0;
        for (const RangeSearch& range : ranges_) entries += range.entries();
        if (entries >= kNone) {
            return Error{
                "the neighbor lists would hold more than 4294967294 entries in all; "
                "choose a smaller k or radius"};
        }
        if (progress) progress(1.0);
        if (known) {
            closeGaps(lists, entries);
        } else {
            lists = inOrderOfIndex(entries);
        }
        return withCoarseCorners(std::move(lists));
    }

  private:
    void addGroups(const PointBlocks::Node& node) {
        if (node.blocks <= GroupSearch::kMaxBlocks) return groups_.push_back(&node);
        addGroups(blocks_.leftOf(node));
        addGroups(blocks_.rightOf(node));
    }
    /// Lists of full length, with room for those that are to come.
    NeighborLists spacedLists() const {
        NeighborLists lists;
        lists.offset.resize(total_ + 1);
        for (std::size_t p = 0; p <= total_; ++p)
            lists.offset[p] = static_cast<std::uint32_t>(p * rule_.length);
        lists.ids.resize(total_ * rule_.length);
        return lists;
    }
    std::vector<std::uint32_t> offsets() const {
        std::vector<std::uint32_t> offset(total_ + 1, 0);
        forEachItem(ranges_.size(), threads_, kRangesPerThread,
                    [&](std::size_t i) { ranges_[i].writeLengths(offset); });
        std::partial_sum(offset.begin(), offset.end(), offset.begin());
        return offset;
    }
    /// Moves lists that are shorter than their room together.
    void closeGaps(NeighborLists& lists, std::size_t entries) const {
        if (entries == lists.ids.size()) return;
        std::vector<std::uint32_t> offset = offsets();
        for (std::size_t p = 0; p < total_; ++p) {
            if (offset[p] == lists.offset[p]) continue;
            const auto from = lists.ids.begin() + lists.offset[p];
            std::copy(from, from + (offset[p + 1] - offset[p]), lists.ids.begin() + offset[p]);
        }
        lists.offset = std::move(offset);
        lists.ids.resize(entries);
        lists.ids.shrink_to_fit();
    }
    NeighborLists inOrderOfIndex(std::size_t entries) const {
        NeighborLists lists;
        lists.offset = offsets();
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

Result<NeighborLists> nearestPoints(std::span<const Vec3> position, const std::vector<bool>& usable,
                                    std::size_t count, unsigned threads, const Progress& progress) {
    NeighborOptions options;
    options.reach = KNearest{count};
    options.dropOpposingNormals = false;
    options.threads = threads;
    return findNeighbors(position, {}, usable, options, progress);
}

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
