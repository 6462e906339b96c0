#include "session/session_file.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

namespace {

Address at(const char* text) { return addressFromString(text).value(); }

}  // namespace

TEST_CASE("Bookmarks keep the order of the run, in any order of setting them") {
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

TEST_CASE("A second toggle removes a bookmark, an inserted one replaces that of its address") {
    Bookmarks marks;
    insertBookmark(marks, {at("5.sort.1"), "first"});
    insertBookmark(marks, {at("5.sort.1"), "second"});
    REQUIRE(marks.size() == 1);
    CHECK(marks[0].note == "second");
    CHECK_FALSE(toggleBookmark(marks, at("5.sort.1")));
    CHECK(marks.empty());
}

TEST_CASE("The next bookmark is the nearest one strictly after or before a position") {
    Bookmarks marks;
    CHECK(nextBookmark(marks, {5, Stage::Sphere, 1}, 1) == nullptr);
    CHECK(nextBookmark(marks, {5, Stage::Sphere, 1}, -1) == nullptr);
    for (const std::uint32_t pivot : {9U, 3U, 5U}) {
        toggleBookmark(marks, {pivot, Stage::Sphere, 1});
    }
    const auto pivotOf = [&](const Address& from, int direction) {
        const Bookmark* next = nextBookmark(marks, from, direction);
        return next == nullptr ? 0U : next->address.pivot;
    };
    CHECK(pivotOf({5, Stage::Sphere, 1}, 1) == 9);
    CHECK(pivotOf({5, Stage::Sphere, 1}, -1) == 3);
    CHECK(pivotOf({5, Stage::Sort, 1}, 1) == 5);
    CHECK(pivotOf({5, Stage::Sphere, 2}, -1) == 5);
    CHECK(pivotOf({9, Stage::Sphere, 1}, 1) == 0);
    CHECK(pivotOf({3, Stage::Sphere, 1}, -1) == 0);
}
