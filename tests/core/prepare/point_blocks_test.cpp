#include "spiraling_edge/geometry/point_blocks.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "neighbor_oracle.h"
#include "spiraling_edge/prepare/neighbor_search.h"

using namespace se;
using namespace se::test;

namespace {

/// Checks that a node is the whole of its halves, and its box that of its points.
void checkNode(const PointBlocks& blocks, const PointBlocks::Node& node) {
    const std::size_t from = node.firstSlot();
    const std::size_t to = std::min(from + node.blocks * PointBlocks::kBlock, blocks.size());
    REQUIRE(from < to);
    Box box(blocks.position(from));
    for (std::size_t slot = from; slot < to; ++slot) box.add(blocks.position(slot));
    CHECK(box.low == node.box.low);
    CHECK(box.high == node.box.high);
    if (node.isBlock()) return;
    const PointBlocks::Node& left = blocks.leftOf(node);
    const PointBlocks::Node& right = blocks.rightOf(node);
    CHECK(left.first == node.first);
    CHECK(right.first == left.first + left.blocks);
    CHECK(left.blocks + right.blocks == node.blocks);
    CHECK(right.blocks - left.blocks <= 1);
    checkNode(blocks, left);
    checkNode(blocks, right);
}

}  // namespace

TEST_CASE("PointBlocks: every usable point has one slot, and boxes are tight") {
    for (const std::size_t count : {1U, 7U, 8U, 9U, 64U, 65U, 1000U}) {
        for (const double equal : {0.0, 1.0}) {  // all x are different, or all equal
            OraclePoints points = makeRandom(count);
            points.usable[0] = true;
            for (Vec3& p : points.position) p.x = equal == 1.0 ? 3.0 : p.x;
            const PointBlocks blocks(points.position, points.usable);
            std::set<Index> ids;
            for (std::size_t slot = 0; slot < blocks.size(); ++slot) {
                ids.insert(blocks.id(slot));
                CHECK(points.usable[blocks.id(slot)]);
                CHECK(blocks.position(slot) == points.position[blocks.id(slot)]);
            }
            CHECK(ids.size() == blocks.size());
            CHECK(blocks.size() == static_cast<std::size_t>(std::count(points.usable.begin(),
                                                                       points.usable.end(), true)));
            checkNode(blocks, blocks.root());
        }
    }
}

TEST_CASE("PointBlocks: order and boxes are the same for any number of threads") {
    const OraclePoints points = makeRandom(50000);
    const PointBlocks one(points.position, points.usable, 1);
    for (const unsigned threads : {0U, 2U, 3U, 7U}) {
        const PointBlocks blocks(points.position, points.usable, threads);
        REQUIRE(blocks.size() == one.size());
        bool same = true;
        for (std::size_t slot = 0; slot < one.size(); ++slot)
            same = same && blocks.id(slot) == one.id(slot);
        CHECK(same);
        checkNode(blocks, blocks.root());
    }
}

TEST_CASE("PointBlocks: the halves of a node are apart along its longest side") {
    const OraclePoints points = makeRandom(5000);
    const PointBlocks blocks(points.position, points.usable);
    const PointBlocks::Node& root = blocks.root();
    const Vec3 gap = blocks.rightOf(root).box.low - blocks.leftOf(root).box.high;
    CHECK(std::max({gap.x, gap.y, gap.z}) >= 0.0);
}

TEST_CASE("PointBlocks: no box is farther than a point in it, by rounding either") {
    Numbers numbers;
    std::size_t farther = 0;
    for (int i = 0; i < 20000; ++i) {
        const double scale = std::pow(10.0, numbers.next() * 640.0 - 325.0);
        const auto place = [&] { return (numbers.nextVector() - Vec3(0.5)) * scale; };
        const Vec3 p = place();
        const Vec3 q = place();
        Box here(p);
        here.add(place());
        Box there(q);
        there.add(place());
        farther += squaredGap(here, there) > distanceSquared(p, q) ? 1U : 0U;
    }
    CHECK(farther == 0);
}

TEST_CASE("PointBlocks: a search of boxes ends when the visitor has enough") {
    const OraclePoints points = makeRandom(1000);
    const PointBlocks blocks(points.position, points.usable);
    std::size_t visits = 0;
    CHECK_FALSE(blocks.forBlocksNear(blocks.root().box, 0.0,
                                     [&](const PointBlocks::Node&) { return ++visits < 5; }));
    CHECK(visits == 5);
}
