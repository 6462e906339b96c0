// Searches in lists and tables, lists in order, and their memory.
#include "spiraling_edge/base/lists.h"

#include <doctest/doctest.h>

#include <array>

namespace se {
namespace {

struct Row {
    std::string_view name;
    int value;
};
constexpr std::array kRows{Row{"one", 1}, Row{"two", 2}, Row{"two", 3}};

TEST_CASE("lists: the first row of a name is found, and none for a name that is unknown") {
    REQUIRE(findNamed(kRows, "two") != nullptr);
    CHECK(findNamed(kRows, "two")->value == 2);
    CHECK(findNamed(kRows, "three") == nullptr);
    CHECK(countWhere(kRows, [](const Row& row) { return row.value > 1; }) == 2);
}

TEST_CASE("lists: values are put in order, each once") {
    std::vector<int> values{3, 1, 3, 2, 1};
    sortUnique(values);
    CHECK(values == std::vector<int>{1, 2, 3});
    CHECK(isAmong(2, values));
    CHECK_FALSE(isAmong(4, values));
}

TEST_CASE("lists: a freed list holds no memory, which one that is only emptied does") {
    std::vector<int> values(1000);
    values = {};
    CHECK(values.capacity() == 1000);
    freeList(values);
    CHECK(values.empty());
    CHECK(values.capacity() == 0);
}

}  // namespace
}  // namespace se
