#include "spiraling_edge/base/journaled_list.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "spiraling_edge/base/random.h"

using namespace se;

namespace {

std::size_t below(std::size_t limit, SplitMix& random) { return random.bits() % limit; }

/// Makes a random change of a list.
void change(JournaledList<int>& list, SplitMix& random) {
    const std::size_t kind = below(10, random);
    const int value = static_cast<int>(below(1000, random));
    if (list.empty() || kind == 0) return list.push_back(value);
    if (kind == 1) return list.pop_back();
    if (kind == 2) return list.resize(below(20, random), value);
    if (kind == 3) {
        std::vector<int> other = list;
        other.insert(other.begin(), value);
        return list.assign(other);
    }
    list.set(below(list.size(), random), value);
}

}  // namespace

TEST_CASE("A journaled list goes to all of its earlier contents, back and forward") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SplitMix random(seed);
        JournaledList<int> list(std::vector<int>{1, 2, 3});
        list.beginJournal();
        std::vector<std::pair<std::size_t, std::vector<int>>> seen{{list.changes(), list}};
        for (int i = 0; i < 200; ++i) {
            change(list, random);
            seen.emplace_back(list.changes(), list);
        }
        for (int i = 0; i < 300; ++i) {
            const auto& [place, contents] = seen[below(seen.size(), random)];
            list.moveTo(place);
            CHECK(list.changes() == place);
            REQUIRE(static_cast<const std::vector<int>&>(list) == contents);
        }
    }
}

TEST_CASE("A change that is made again after going back keeps the later ones") {
    JournaledList<int> list(std::vector<int>{1, 2});
    list.beginJournal();
    list.set(0, 5);
    const std::size_t between = list.changes();
    list.push_back(7);
    list.set(1, 9);
    const std::size_t end = list.changes();
    list.moveTo(0);
    list.set(0, 5);
    CHECK(list.changes() == between);
    list.moveTo(end);
    CHECK(static_cast<const std::vector<int>&>(list) == std::vector<int>{5, 9, 7});
    list.moveTo(0);
    CHECK(static_cast<const std::vector<int>&>(list) == std::vector<int>{1, 2});
}

TEST_CASE("A copy of a journaled list has its elements and no journal") {
    JournaledList<int> list(std::vector<int>{1, 2});
    list.beginJournal();
    list.set(0, 3);
    const JournaledList<int> copy = list;
    CHECK_FALSE(copy.hasJournal());
    CHECK(copy[0] == 3);
    CHECK(list.hasJournal());
}
