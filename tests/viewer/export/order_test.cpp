#include "export/order.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("Steps of a lesson are single numbers and ranges, ascending and once each") {
    CHECK(stepsFromText("2,4-6", 9).value() == std::vector<std::size_t>{2, 4, 5, 6});
    CHECK(stepsFromText("5,1-3,2", 9).value() == std::vector<std::size_t>{1, 2, 3, 5});
    for (const char* wrong : {"", "0", "3-2", "10", "1-", "-2", "a", "1,,2", "1,"})
        CHECK_FALSE(stepsFromText(wrong, 9));
    CHECK(stepsFromText("10", 9).error().message ==
          "10: expected steps from 1 to 9, such as 2,4-6");
}

TEST_CASE("The range around a decision is its whole pivot") {
    const FrameRange range = rangeAround("9.sphere.2").value();
    CHECK(range.from == "9");
    CHECK(range.to == "9");
    CHECK_FALSE(rangeAround("50%"));
}

TEST_CASE("The program is linked to by an address of the web, of a file, or beside the page") {
    for (const char* good : {"", "https://a.org/se/", "http://localhost:8000/0.2/?x=1",
                             "file:///srv/se.html", "../se.html", "se.html", "/se/"})
        CHECK(checkViewerAddress(good).ok());
    for (const char* wrong : {"javascript:alert(1)", "data:text/html,x", "ftp://a.org/", "a b",
                              "a\"b", "a'b", "<a>", "a.html#x", "a\nb"})
        CHECK_FALSE(checkViewerAddress(wrong).ok());
}

TEST_CASE("Units of frames are found by their names alone") {
    CHECK(unitFromName("sub-step") == PlayUnit::SubStep);
    CHECK(unitFromName("pivot") == PlayUnit::Pivot);
    CHECK(unitFromName("event") == PlayUnit::Event);
    CHECK_FALSE(unitFromName("frame"));
}
