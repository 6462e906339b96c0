// Words of a text, the nearest of a list, and nouns with their numbers.
#include <doctest/doctest.h>

#include <array>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"

namespace se {
namespace {

using Words = std::vector<std::string>;

TEST_CASE("words lie between blanks, tabs and line ends") {
    CHECK(io::wordsIn("").empty());
    CHECK(io::wordsIn(" \t\r\n").empty());
    CHECK(io::wordsIn("--rules robust") == Words{"--rules", "robust"});
    CHECK(io::wordsIn("  a\n\tb ") == Words{"a", "b"});
    CHECK(io::wordsIn("8, 9") == Words{"8,", "9"});
    CHECK(io::wordsIn("8, 9", ',') == Words{"8", "9"});
}

TEST_CASE("the nearest word has the fewest letters changed") {
    constexpr std::array<std::string_view, 3> kWords{"limits", "sphere", "hole"};
    CHECK(nearestWord(kWords, "sphre") == "sphere");
    CHECK(nearestWord(kWords, "holes") == "hole");
    CHECK(nearestWord(kWords, "") == "hole");
    CHECK(nearestWord(kWords, std::string(100'000, 'x')) == "limits");
}

TEST_CASE("a noun has its plural by its number") {
    CHECK(counted(0, "point") == "0 points");
    CHECK(counted(1, "point") == "1 point");
    CHECK(counted(2, "vertex", "vertices") == "2 vertices");
    CHECK(counted(1, "vertex", "vertices") == "1 vertex");
}

}  // namespace
}  // namespace se
