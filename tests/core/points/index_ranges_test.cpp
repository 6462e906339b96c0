#include "spiraling_edge/points/index_ranges.h"

#include <doctest/doctest.h>

using namespace se;

TEST_CASE("Ranges of indices are written compactly and read back") {
    const std::vector<Index> indices{0, 3, 4, 7, 8, 9, 40};
    const IndexRanges ranges = rangesOf(indices);
    CHECK(ranges == IndexRanges{{0, 0}, {3, 4}, {7, 9}, {40, 40}});
    CHECK(rangesText(ranges) == "0,3,4,7..9,40");
    CHECK(rangesFromText("0,3,4,7..9,40") == ranges);
    CHECK(rangesText({}).empty());
    CHECK(rangesFromText("") == IndexRanges{});
    // Two that touch are one.
    CHECK(rangesFromText("1..3,4..6") == IndexRanges{{1, 6}});
}

TEST_CASE("A text that is no ascending list of indices is no set of ranges") {
    for (const char* text : {"x", "1,", ",1", "1..", "..2", "5..3", "3,3", "4,2", "1..4,3", "-1",
                             "1 2", "4294967295", "1..4294967295", "99999999999"}) {
        CAPTURE(text);
        CHECK_FALSE(rangesFromText(text));
    }
}

TEST_CASE("Ranges mark the indices in them, and none beyond the end") {
    CHECK(marksOf({{1, 2}, {4, 9}}, 6) == std::vector<bool>{false, true, true, false, true, true});
    CHECK(marksOf({{7, 9}}, 2) == std::vector<bool>{false, false});
}
