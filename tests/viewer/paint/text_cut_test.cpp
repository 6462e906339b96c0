#include "paint/text_cut.h"

#include <doctest/doctest.h>

#include <algorithm>

using se::view::linesAtBlanks;
using se::view::withoutLastSign;
using se::view::withoutMiddle;

TEST_CASE("Cutting a text: a character is removed with all of its bytes") {
    CHECK(withoutLastSign("12") == "1");
    CHECK(withoutLastSign("1\xE2\x80\x89") == "1");      // thin space
    CHECK(withoutLastSign("1\xC2\xB0") == "1");          // degree sign
    CHECK(withoutLastSign("1\xF0\x9F\x94\xB5") == "1");  // four bytes
    CHECK(withoutLastSign("\xE2\x88\x92"
                          "x") == "\xE2\x88\x92");
    CHECK(withoutLastSign("").empty());
}

namespace {

using Lines = std::vector<std::string>;

/// Every character has width one.
float signs(const std::string& text) { return static_cast<float>(text.size()); }

}  // namespace

TEST_CASE("Lines are broken at spaces, never at a decimal point or within a number") {
    CHECK(linesAtBlanks("turn 0.0038 of 12", 8.0F, signs) == Lines{"turn", "0.0038", "of 12"});
    CHECK(linesAtBlanks("at (0.25, -1.5) r", 11.0F, signs) == Lines{"at (0.25,", "-1.5) r"});
    CHECK(linesAtBlanks("short", 80.0F, signs) == Lines{"short"});
    CHECK(linesAtBlanks("", 80.0F, signs) == Lines{""});
}

TEST_CASE("Line ends of a text stay, and a word wider than a line is cut") {
    CHECK(linesAtBlanks("one two\nthree", 80.0F, signs) == Lines{"one two", "three"});
    CHECK(linesAtBlanks("one\n\ntwo", 80.0F, signs) == Lines{"one", "", "two"});
    CHECK(linesAtBlanks("in /home/points.ply: no", 8.0F, signs) ==
          Lines{"in", "/home/po", "ints.ply", ": no"});
    CHECK(linesAtBlanks("abc", 0.5F, signs) == Lines{"a", "b", "c"});
}

TEST_CASE("A long name loses its middle, and keeps both ends and whole characters") {
    const auto measure = [](const std::string& text) {
        return static_cast<float>(std::count_if(text.begin(), text.end(), [](char byte) {
            return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
        }));
    };
    const std::string name = "/data/scans/kitten/kitten-2024-final.ply";
    CHECK(withoutMiddle(name, 40.0F, measure) == name);
    CHECK(withoutMiddle(name, 13.0F, measure) ==
          "/data/\xE2\x80\xA6"
          "al.ply");
    CHECK(withoutMiddle("\xC3\xA4\xC3\xB6\xC3\xBC\xC3\xA4\xC3\xB6\xC3\xBC", 3.0F, measure) ==
          "\xC3\xA4\xE2\x80\xA6\xC3\xBC");
    for (float width = 1.0F; width < 40.0F; ++width)
        CHECK(measure(withoutMiddle(name, width, measure)) <= width);
}
