#include "spiraling_edge/geometry/renumbering.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>

using namespace se;

namespace {

/// Each of `count` points lists the one that many numbers later.
NeighborLists listsApart(Index count, Index apart) {
    NeighborLists lists;
    for (Index p = 0; p < count; ++p) lists.append(std::array{(p + apart) % count});
    return lists;
}

}  // namespace

TEST_CASE("renumbering: many points are scattered if most have no neighbor close in memory") {
    CHECK(areScattered(listsApart(100'000, 50'000)));
    CHECK_FALSE(areScattered(listsApart(100'000, 1)));
    CHECK_FALSE(areScattered(listsApart(100'000, 1000)));
    CHECK_FALSE(areScattered(listsApart(99'999, 50'000)));
    NeighborLists none;
    for (int p = 0; p < 100'000; ++p) none.append({});
    CHECK_FALSE(areScattered(none));
    CHECK_FALSE(areScattered({}));
}

TEST_CASE("renumbering: numbers, values and lists go to their places and back") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> position{{3, 0, 0}, {nan, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Numbering numbering = numberingAlongZCurve(position);
    CHECK(numbering.original == std::vector<Index>{2, 3, 0, 1});
    CHECK(numbering.place == std::vector<Index>{2, 3, 0, 1});
    CHECK(numbering.originalOf(0) == 2);
    CHECK(Numbering{}.originalOf(3) == 3);
    CHECK(Numbering{}.placeOf(3) == 3);
    CHECK(inverse(std::vector<Index>{1, 2, 0}) == std::vector<Index>{2, 0, 1});
    CHECK(permuted(std::vector<int>{5, 6, 7}, std::vector<Index>{1, 2, 0}) ==
          std::vector<int>{6, 7, 5});
    NeighborLists lists;
    lists.append(std::array<Index, 2>{3, 2});
    lists.append({});
    lists.append(std::array<Index, 1>{3});
    lists.append(std::array<Index, 2>{2, 0});
    const NeighborLists made = renumbered(lists, numbering);
    CHECK(made.offset == std::vector<std::uint32_t>{0, 1, 3, 5, 5});
    CHECK(made.ids == std::vector<Index>{1, 0, 2, 1, 0});
    CHECK(renumbered({}, {}).ids.empty());
}

TEST_CASE("renumbering: points that are not scattered stay as they are, the others come back") {
    const std::vector<Vec3> position(100'000, Vec3(1.0));
    const NeighborLists even = listsApart(100'000, 1);
    const OrderedPoints same(position, even);
    CHECK(&same.lists() == &even);
    CHECK(same.position().data() == position.data());
    std::vector<Vec3> line;
    for (int i = 0; i < 100'000; ++i) line.push_back({i % 2, i, 0});
    const OrderedPoints moved(line, listsApart(100'000, 50'000));
    CHECK(moved.position()[7] == line[moved.numbering().original[7]]);
    CHECK(moved.renumbered(line)[7] == moved.position()[7]);
    CHECK(moved.restored(moved.renumbered(line)) == line);
    CHECK(moved.lists()[moved.numbering().place[3]][0] == moved.numbering().place[50'003]);
}
