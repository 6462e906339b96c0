#include "interface/text_cut.h"

#include <doctest/doctest.h>

using se::view::withoutLastSign;

TEST_CASE("Cutting a text: a sign goes with all of its bytes") {
    CHECK(withoutLastSign("12") == "1");
    CHECK(withoutLastSign("1\xE2\x80\x89") == "1");      // thin space
    CHECK(withoutLastSign("1\xC2\xB0") == "1");          // degree sign
    CHECK(withoutLastSign("1\xF0\x9F\x94\xB5") == "1");  // four bytes
    CHECK(withoutLastSign("\xE2\x88\x92"
                          "x") == "\xE2\x88\x92");
    CHECK(withoutLastSign("").empty());
}
