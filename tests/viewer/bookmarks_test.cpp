#include "bookmarks.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

namespace {

Address at(const char* text) { return addressFromString(text).value(); }

}  // namespace

TEST_CASE("Bookmarks keep the order of the run, whatever the order they are set in") {
    Bookmarks marks;
    for (const char* text : {"40.sphere.2", "7.sort.1", "40.sort.3", "40.sphere.1"}) {
        CHECK(toggleBookmark(marks, at(text)));
    }
    REQUIRE(marks.size() == 4);
    CHECK(toString(marks[0].address) == "7.sort.1");
    CHECK(toString(marks[1].address) == "40.sort.3");
    CHECK(toString(marks[2].address) == "40.sphere.1");
    CHECK(toString(marks[3].address) == "40.sphere.2");
    CHECK(bookmarkAt(marks, at("40.sort.3")) == 1U);
    CHECK(bookmarkAt(marks, at("40.sort.4")) == std::nullopt);
}

TEST_CASE("A second toggle takes a bookmark away; an inserted one replaces that of its address") {
    Bookmarks marks;
    insertBookmark(marks, {at("5.sort.1"), "first"});
    insertBookmark(marks, {at("5.sort.1"), "second"});
    REQUIRE(marks.size() == 1);
    CHECK(marks[0].note == "second");
    CHECK_FALSE(toggleBookmark(marks, at("5.sort.1")));
    CHECK(marks.empty());
}
