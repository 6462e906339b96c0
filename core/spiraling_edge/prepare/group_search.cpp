/// Lists of a group of points. Most of the time goes into three loops without branches that depend
/// on the points: which boxes are near, which points are, and which of two is nearer. Whatever the
/// guess, lists are those of SingleSearch.
#include "spiraling_edge/prepare/group_search.h"

#include <algorithm>
#include <limits>

namespace se {
namespace {

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

}  // namespace

/// Squared distance within which the next list is expected to end; 0: unknown. Always finite:
/// slots without a point are not within it.
double GroupSearch::bound() const {
    return rule_.all ? rule_.squaredReach : std::min(kGuessFactor * last_, rule_.squaredReach);
}

/// Collects the blocks near a box. False, with none collected, if they are too many.
bool GroupSearch::collect(const Box& box) {
    const double squaredReach = std::min(kReachFactor * bound(), rule_.squaredReach);
    near_.clear();
    std::size_t count = 0;
    const bool few = blocks_.forBlocksNear(box, squaredReach, [&](const PointBlocks::Node& node) {
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

/// Fills hit_ with the blocks whose boxes are within the bound; returns their number. The distance
/// of a box is that of its place nearest to p, computed as for a point: so it is never above that
/// of a point in it.
std::size_t GroupSearch::hitBlocks(const Vec3& p, double bound) {
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
std::size_t GroupSearch::gather(const Vec3& p, double bound) {
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
bool GroupSearch::accept(std::size_t slot, std::size_t count) {
    std::size_t apart = 0;
    std::size_t accepts = 0;
    for (std::size_t i = 0; i < count; ++i) {
        accepted_[accepts] = {distance_[i], blocks_.id(slot_[i])};
        const bool isApart = distance_[i] > 0.0;
        apart += isApart ? 1 : 0;
        const bool opposes = !normal_.empty() && normalsOppose(normal_[slot], normal_[slot_[i]]);
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
std::span<const Neighbor> GroupSearch::sortAccepted(double bound) {
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
bool GroupSearch::listWithin(std::size_t slot, double bound, std::vector<Index>& ids) {
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

void GroupSearch::list(std::size_t slot, std::vector<Index>& ids) {
    for (double tried = bound(); tried > 0.0 && tried <= reach_; tried *= 2.0) {
        if (listWithin(slot, tried, ids)) return;
    }
    const std::span<const Neighbor> list = single_.list(slot);
    for (const Neighbor& neighbor : list) ids.push_back(neighbor.id);
    if (!list.empty() && list.size() == rule_.length) last_ = list.back().distanceSquared;
}

void GroupSearch::find(const PointBlocks::Node& group, std::vector<Index>& ids,
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

}  // namespace se
