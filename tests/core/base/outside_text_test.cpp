#include "spiraling_edge/base/outside_text.h"

#include <doctest/doctest.h>

using namespace se;

namespace {

/// Names with each kind of sign that a terminal obeys, and as they are shown.
struct Outside {
    std::string text;
    std::string shown;
};
const Outside kOutside[] = {
    {"a b.ply", "a b.ply"},
    {"M\xc3\xbcller \xe2\x88\x9e \xf0\x9f\x8c\x80", "M\xc3\xbcller \xe2\x88\x9e \xf0\x9f\x8c\x80"},
    {"\x1b[31m\r\x7f\\", "\\x1b[31m\\x0d\\x7f\\"},
    {"a\nb\tc", "a\\nb\\tc"},
    {std::string("\0", 1), "\\x00"},
    {"\xc2\x9b"
     "1m",
     "\\xc2\\x9b1m"},
    {"\xe2\x80\xae"
     "gpj.exe\xe2\x81\xa9",
     "\\xe2\\x80\\xaegpj.exe\\xe2\\x81\\xa9"},
    {"\xe2\x80\xa8", "\\xe2\\x80\\xa8"},
    {"\xff\xc3", "\\xff\\xc3"},
    // Too long, a surrogate, and beyond the last character: no UTF-8.
    {"\xc0\x9b", "\\xc0\\x9b"},
    {"\xed\xa0\x80", "\\xed\\xa0\\x80"},
    {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
};

}  // namespace

TEST_CASE("texts from outside: what a terminal would obey is shown as escapes") {
    for (const Outside& each : kOutside) {
        CAPTURE(each.shown);
        CHECK(printable(each.text) == each.shown);
        CHECK(printable(each.shown) == each.shown);
    }
    CHECK(printableLines("a\tb\n\x1b\n") == "a\\tb\n\\x1b\n");
}

TEST_CASE("texts from outside: a JSON document keeps its values and is safe to show") {
    CHECK(printableJson("{\n  \"a\": \"\x7f\xc2\x9b\xe2\x80\xae\"\n}\n") ==
          "{\n  \"a\": \"\\u007f\\u009b\\u202e\"\n}\n");
}

TEST_CASE("texts from outside: a message quotes at most 80 characters") {
    const std::string umlaut = "\xc3\xbc";
    std::string eighty;
    for (int i = 0; i < 80; ++i) eighty += umlaut;
    CHECK(inQuotes(eighty) == "\"" + eighty + "\"");
    CHECK(inQuotes(eighty + "x") == "\"" + eighty + "...\"");
    CHECK(inQuotes("a\nb") == "\"a\\nb\"");
    CHECK(inQuotes(std::string(1000000, '\x1b')).size() <= 80 + 5);
}
