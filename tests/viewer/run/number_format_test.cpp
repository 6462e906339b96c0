#include "run/strings.h"
#include "spiraling_edge/run/event_text.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

TEST_CASE("Sentences have four significant digits at most") {
    CHECK(withShortNumbers("q lies 0.00381251 inside the sphere (d = 0.264146, r = 0.310093).") ==
          "q lies 0.003813 inside the sphere (d = 0.2641, r = 0.3101).");
    CHECK(withShortNumbers("turn -0.000768121") == "turn -0.0007681");
    CHECK(withShortNumbers("1.23457e-05 away") == "1.235e-05 away");
    CHECK(withShortNumbers("2.49999 away.") == "2.5 away.");
    // Not to a power of ten: that would be harder to read.
    CHECK(withShortNumbers("r = 12345.6, d = 1234.56") == "r = 12346, d = 1235");
}

TEST_CASE("Short numbers, whole ones, addresses and names stay as they are") {
    for (const char* same :
         {"", "Point 278631 at 96.1 deg of 218.9 deg: a candidate.", "section 6.1, 137.sphere.3",
          "at 1.5 and 0.25", "0.0", "version 1.23456.7", "scan_0.12345", "a.123456", "5.", ".5",
          "1e-05 away"}) {
        CAPTURE(same);
        CHECK(withShortNumbers(same) == same);
    }
}

TEST_CASE("A decision has short numbers in panels, and all digits in its sentence") {
    const Event event{{9, Stage::Seed, 1}, SeedEvidence{1, 2, 0.123456789}};
    CHECK(describe(event).find("0.123457") != std::string::npos);
    CHECK(shortSentence(event).find("0.1235 away") != std::string::npos);
}
