#include "spiraling_edge/run/status_list.h"

#include <doctest/doctest.h>

#include <vector>

using namespace se;

namespace {

constexpr std::size_t kSize = 3 * BlockList<PointStatus>::kBlock + 17;

StatusList fresh() {
    StatusList list;
    list.assign(std::vector<PointStatus>(kSize, kUnused));
    return list;
}

}  // namespace

TEST_CASE("A copy of the statuses keeps its values when the original changes") {
    StatusList list = fresh();
    const StatusList before = list;
    list.set(5, 2);
    list.set(kSize - 1, kDone);
    CHECK(before[5] == kUnused);
    CHECK(list[5] == 2);
    CHECK(list[kSize - 1] == kDone);
    CHECK_FALSE(list == before);
    list.set(5, kUnused);
    list.set(kSize - 1, kUnused);
    CHECK(list == before);
}

TEST_CASE("A changed status leaves the others of its block as they are") {
    StatusList list = fresh();
    list.set(1, 3);
    const std::size_t second = BlockList<PointStatus>::kBlock;
    list.set(second, 2);
    CHECK(list[1] == 3);
    CHECK(list[second] == 2);
    CHECK(list[second + 1] == kUnused);
}

TEST_CASE("Only blocks that changed are no longer shared") {
    StatusList list = fresh();
    const StatusList before = list;
    std::vector<PointStatus> all(kSize, kUnused);
    all[BlockList<PointStatus>::kBlock] = 1;
    list.assign(all);
    REQUIRE(list.blocks().blockCount() == 4);
    CHECK(list.blocks().shares(0, before.blocks()));
    CHECK_FALSE(list.blocks().shares(1, before.blocks()));
    CHECK(list.blocks().shares(2, before.blocks()));
    CHECK(list.blocks().shares(3, before.blocks()));
}

TEST_CASE("Statuses are counted as they change") {
    StatusList list = fresh();
    CHECK(list.counts() == StatusCounts{kSize, 0, 0});
    list.set(1, 1);
    list.set(2, 3);
    list.set(3, kDone);
    list.set(1, 2);
    CHECK(list.counts() == StatusCounts{kSize - 3, 2, 1});
    std::vector<PointStatus> all(kSize, kDone);
    all.back() = kUnused;
    list.assign(all);
    CHECK(list.counts() == StatusCounts{1, 0, kSize - 1});
}
