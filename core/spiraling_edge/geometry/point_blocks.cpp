#include "spiraling_edge/geometry/point_blocks.h"

#include <algorithm>
#include <limits>

#include "spiraling_edge/base/parallel.h"

namespace se {

namespace {

/// Least number of points per thread.
constexpr std::size_t kPointsPerThread = 4096;

std::size_t blocksOf(std::size_t points) {
    return (points + PointBlocks::kBlock - 1) / PointBlocks::kBlock;
}

}  // namespace

PointBlocks::PointBlocks(std::span<const Vec3> position, const std::vector<bool>& usable,
                         unsigned threads) {
    std::vector<Item> items;
    items.reserve(position.size());
    for (Index p = 0; p < position.size(); ++p) {
        if (usable[p]) items.push_back({{position[p].x, position[p].y, position[p].z}, p});
    }
    node_.resize(items.empty() ? 0 : nodesOf(blocksOf(items.size())));
    if (!items.empty()) divide(items, 0, 0, threadCount(threads));
    fillBlocks(items, threads);
}

void PointBlocks::fillBlocks(std::span<const Item> items, unsigned threads) {
    PerPoint far;
    far.fill(std::numeric_limits<double>::infinity());
    block_.assign(blocksOf(items.size()), {far, far, far});
    id_.resize(items.size());
    forEachItem(items.size(), threads, kPointsPerThread, [&](std::size_t slot) {
        Block& block = block_[slot / kBlock];
        const Item& item = items[slot];
        block.x[slot % kBlock] = item.at[0];
        block.y[slot % kBlock] = item.at[1];
        block.z[slot % kBlock] = item.at[2];
        id_[slot] = static_cast<Index>(item.id);
    });
}

/// Makes the node of this number and those below it, from items in slots from block `first` on. The
/// halves know their numbers beforehand, so that each is made by half of the threads.
void PointBlocks::divide(std::span<Item> items, std::size_t number, std::uint32_t first,
                         unsigned threads) {
    const auto place = [](const Item& item) { return Vec3(item.at[0], item.at[1], item.at[2]); };
    Box box(place(items[0]));
    for (const Item& item : items) box.add(place(item));
    const std::size_t blocks = blocksOf(items.size());
    node_[number] = {box, first, static_cast<std::uint32_t>(blocks)};
    if (blocks == 1) return;
    // Halves, since the difference of the largest numbers would overflow.
    const Vec3 side = box.high * 0.5 - box.low * 0.5;
    const std::size_t axis =
        side.x >= side.y ? (side.x >= side.z ? 0 : 2) : (side.y >= side.z ? 1 : 2);
    const std::size_t middle = blocks / 2 * kBlock;
    select(items, middle, axis);
    const bool apart = threads > 1 && items.size() >= 2 * kPointsPerThread;
    const unsigned others = apart ? threads / 2 : 1;
    const auto right = [&, others] {
        divide(items.subspan(middle), number + nodesOf(blocks / 2) + 1,
               first + static_cast<std::uint32_t>(blocks / 2), others);
    };
    Workers worker;
    if (apart) worker.start(right);
    divide(items.first(middle), number + 1, first, apart ? threads - others : 1);
    if (!apart) right();
    worker.join();
}

/// Puts the items that are first along the axis before `middle`, as std::nth_element does. That one
/// has an unpredictable branch at each item; here most items are moved without a branch, to either
/// side of a value near the middle one.
void PointBlocks::select(std::span<Item> items, std::size_t middle, std::size_t axis) {
    constexpr std::size_t kSample = 11;
    constexpr std::size_t kFew = 32;
    // Bad luck with samples, or many equal coordinates, must not cost more rounds than these.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds && items.size() > kFew; ++round) {
        std::array<double, kSample> sample;
        for (std::size_t i = 0; i < kSample; ++i)
            sample[i] = items[items.size() * (2 * i + 1) / (2 * kSample)].at[axis];
        std::sort(sample.begin(), sample.end());
        const double pivot = sample[std::min(kSample * middle / items.size(), kSample - 1)];
        std::size_t below = 0;
        for (Item& item : items) {
            const Item moved = item;
            item = items[below];
            items[below] = moved;
            below += moved.at[axis] < pivot ? 1 : 0;
        }
        if (middle < below) {
            items = items.first(below);
        } else {
            items = items.subspan(below);
            middle -= below;
        }
        if (middle == 0 || below == 0) break;
    }
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle),
                     items.end(),
                     [axis](const Item& a, const Item& b) { return a.at[axis] < b.at[axis]; });
}

}  // namespace se
