#include "spiraling_edge/prepare/rank_sort.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "neighbor_oracle.h"

using namespace se;
using namespace se::test;

namespace {

/// Compares with std::sort: this many neighbors at distances up to the bound, in `steps` steps.
void checkSorted(std::size_t count, double bound, double steps) {
    Numbers numbers;
    std::vector<Neighbor> neighbors;
    for (std::size_t i = 0; i < count; ++i) {
        const auto id = static_cast<Index>((i * 29) % 67);
        neighbors.push_back({std::floor(numbers.next() * steps) / steps * bound, id});
    }
    std::vector<Neighbor> sorted(count);
    rankSort(neighbors, bound, sorted.data());
    std::sort(neighbors.begin(), neighbors.end());
    CHECK(sorted == neighbors);
}

}  // namespace

TEST_CASE("rankSort: sorts any number up to its limit, ties by index") {
    for (std::size_t count = 0; count <= kMaxRanked; ++count) {
        for (const double steps : {1.0, 3.0, 20.0, 1e6}) checkSorted(count, 2.5, steps);
    }
}

TEST_CASE("rankSort: distances too large or too small for a float") {
    for (const double bound : {1e-323, 1e-310, 1e-100, 1e100, 1.7e308}) checkSorted(40, bound, 1e6);
}

TEST_CASE("rankSort: distances that rounding makes equal keep their order") {
    std::vector<Neighbor> neighbors;
    for (Index i = 0; i < 30; ++i) neighbors.push_back({1.0 - 1e-12 * i, i});
    std::vector<Neighbor> sorted(neighbors.size());
    rankSort(neighbors, 1.0, sorted.data());
    for (Index i = 0; i < 30; ++i) CHECK(sorted[i].id == 29 - i);
}
