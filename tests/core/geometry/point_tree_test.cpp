#include "spiraling_edge/geometry/point_tree.h"

#include <doctest/doctest.h>

#include <limits>

#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

std::vector<Index> foundWithin(const PointTree& tree, const Vec3& place, double distance) {
    std::vector<Index> found;
    tree.within(place, distance, [&](Index p) { found.push_back(p); });
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

TEST_CASE("point tree: finds the points within a distance, each once, however they are spaced") {
    Random random(1);
    for (const std::size_t count : {0U, 1U, 8U, 9U, 500U}) {
        std::vector<Vec3> position;
        for (std::size_t i = 0; i < count; ++i) {
            // Dense at the origin, and some points twice.
            const Vec3 x = random.inCube();
            position.push_back(i % 7 == 3 ? position.back() : x * glm::dot(x, x));
        }
        const PointTree tree(position);
        for (int i = 0; i < 200; ++i) {
            const Vec3 place = random.inCube();
            const double distance = 0.7 * glm::length(random.inCube());
            std::vector<Index> expected;
            for (Index p = 0; p < count; ++p) {
                const Vec3 d = position[p] - place;
                if (glm::dot(d, d) <= distance * distance) expected.push_back(p);
            }
            CHECK(foundWithin(tree, place, distance) == expected);
        }
    }
}

TEST_CASE("point tree: a point at the very distance is found, also among equal coordinates") {
    std::vector<Vec3> position(40, Vec3(1, 0, 0));
    position.push_back({0, 0, 2});
    const PointTree tree(position);
    CHECK(foundWithin(tree, Vec3(0.0), 1.0).size() == 40);
    CHECK(foundWithin(tree, Vec3(0.0), 2.0).size() == 41);
    CHECK(foundWithin(tree, Vec3(0.0), 0.5).empty());
}

TEST_CASE("point tree: a point that is not finite is not found, and hides no other") {
    Random random(2);
    std::vector<Vec3> position;
    for (int i = 0; i < 500; ++i) position.push_back(random.inCube());
    const double bad = std::numeric_limits<double>::quiet_NaN();
    position[100] = {bad, 0, 0};
    position[250] = {0, std::numeric_limits<double>::infinity(), 0};
    CHECK(foundWithin(PointTree(position), Vec3(0.0), 4.0).size() == 498);
}
