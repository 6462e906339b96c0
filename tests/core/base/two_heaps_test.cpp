#include "spiraling_edge/base/two_heaps.h"

#include <doctest/doctest.h>

#include <vector>

using namespace se;

TEST_CASE("two heaps: the best split, its distance and the spread within") {
    std::vector<double> numbers{5.1, 0.1, 4.9, -0.1, 0.0, 5.0};
    const TwoHeaps heaps = twoHeapsOf(numbers);
    CHECK(heaps.lower == 3);
    CHECK(heaps.cut == 4.9);
    CHECK(heaps.apart == doctest::Approx(5.0));
    CHECK(heaps.within == doctest::Approx(0.0816497));
    CHECK(heaps.share == doctest::Approx(1.0 - 0.04 / 6.0 / (0.04 / 6.0 + 6.25)));
    std::vector<double> range;
    for (int i = 0; i < 1000; ++i) range.push_back(i);
    CHECK(twoHeapsOf(range).share == doctest::Approx(0.75));
    std::vector<double> same(5, 2.0);
    CHECK(twoHeapsOf(same).share == 0.0);
    CHECK(twoHeapsOf({}).share == 0.0);
}
