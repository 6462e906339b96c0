#include "spiraling_edge/prepare/single_search.h"

#include <algorithm>
#include <array>

namespace se {

std::span<const Neighbor> SingleSearch::list(std::size_t slot) {
    slot_ = slot;
    place_ = blocks_.position(slot);
    const std::size_t points = blocks_.size();
    std::size_t length = points;
    if (rule_.all) {
        search({points, points, true});
    } else {
        length = rule_.length;
        // A search that left out no more than these found only points that the second would.
        if (!search({length, rule_.examined - length, true}))
            search({std::min(rule_.examined, points), 0, false});
    }
    list_.clear();
    for (const Found& found : found_) {
        if (list_.size() == length) break;
        if (!opposes(found.slot)) list_.push_back(found.neighbor);
    }
    return list_;
}

/// Fills found_, nearest first. False if it gave up.
bool SingleSearch::search(const Limits& limits) {
    limits_ = limits;
    dropped_ = 0;
    bound_ = rule_.squaredReach;
    found_.clear();
    struct Open {
        const PointBlocks::Node* node;
        double gap;
    };
    const Box here(place_);
    const auto open = [&](const PointBlocks::Node& node) {
        return Open{&node, squaredGap(node.box, here)};
    };
    std::array<Open, PointBlocks::kMaxOpen> waiting;
    std::size_t count = 0;
    waiting[count++] = open(blocks_.root());
    while (count > 0) {
        const Open next = waiting[--count];
        if (next.gap > bound_) continue;
        if (next.node->isBlock()) {
            if (!scan(*next.node)) return false;
            continue;
        }
        Open farther = open(blocks_.leftOf(*next.node));
        Open nearer = open(blocks_.rightOf(*next.node));
        if (farther.gap < nearer.gap) std::swap(farther, nearer);
        assert(count + 2 <= waiting.size());
        waiting[count++] = farther;
        waiting[count++] = nearer;
    }
    std::sort(found_.begin(), found_.end());
    return true;
}

/// Tests the points of a block. False if the search gives up.
bool SingleSearch::scan(const PointBlocks::Node& node) {
    const auto distance = blocks_.squaredDistances(node.first, place_);
    for (std::size_t i = 0; i < PointBlocks::kBlock; ++i) {
        if (distance[i] > bound_) continue;
        const std::size_t slot = node.firstSlot() + i;
        // Only points at the same place are at distance 0, or so near that its square is.
        if (distance[i] == 0.0 && blocks_.position(slot) == place_) continue;
        const Found candidate{{distance[i], blocks_.id(slot)}, slot};
        if (full() && !(candidate < found_.front())) continue;
        if (limits_.dropOpposing && opposes(slot)) {
            if (++dropped_ > limits_.dropped) return false;
            continue;
        }
        insert(candidate);
    }
    return true;
}

void SingleSearch::insert(const Found& candidate) {
    if (full()) {
        std::pop_heap(found_.begin(), found_.end());
        found_.back() = candidate;
        std::push_heap(found_.begin(), found_.end());
    } else {
        found_.push_back(candidate);
        if (full()) std::make_heap(found_.begin(), found_.end());
    }
    if (full()) bound_ = found_.front().neighbor.distanceSquared;
}

}  // namespace se
