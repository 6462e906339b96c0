#include "spiraling_edge/stepper/robust/near_points.h"

#include <doctest/doctest.h>

#include <limits>

#include <algorithm>
#include <random>

using namespace se;

namespace {

/// Points in a cube, each with a list of its nearest: complete for most, of only every second one
/// for some, and with one more that is farther for others.
PointSet crowdWithLists(std::size_t count) {
    std::mt19937 random(3);
    const auto place = [&random] { return static_cast<double>(random() % 100000) / 1e5; };
    PointSet points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = place();
        const double y = place();
        points.position.emplace_back(x, y, place());
    }
    for (Index p = 0; p < count; ++p) {
        std::vector<Index> others;
        for (Index q = 0; q < count; ++q) {
            if (q != p) others.push_back(q);
        }
        const auto distance = [&](Index q) {
            return glm::distance(points.position[p], points.position[q]);
        };
        std::sort(others.begin(), others.end(),
                  [&](Index a, Index b) { return distance(a) < distance(b); });
        std::vector<Index> list;
        for (std::size_t i = 0; i < 12; ++i) {
            if (p % 4 != 1 || i % 2 == 0) list.push_back(others[i]);
        }
        if (p % 4 == 2) list.push_back(others[90]);
        points.neighbors.append(list);
    }
    return points;
}

std::vector<Index> sorted(std::vector<Index> list) {
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace

TEST_CASE("near points: the ball of a point holds what is no farther than the last of its list") {
    const PointSet points = crowdWithLists(300);
    const NearPoints near(points);
    for (int turn = 0; turn < 2; ++turn) {
        for (Index p = 0; p < points.size(); ++p) {
            const NearBall ball(points, p);
            std::vector<Index> expected;
            for (Index q = 0; q < points.size(); ++q) {
                const Vec3 d = points.position[q] - ball.center;
                if (glm::dot(d, d) <= ball.radius * ball.radius) expected.push_back(q);
            }
            std::vector<Index> found;
            near.visitBall(p, [&](Index q) { found.push_back(q); });
            REQUIRE(sorted(found) == expected);
        }
    }
}

TEST_CASE("near points: a point with an empty list has itself in its ball") {
    PointSet points;
    points.position = {{0, 0, 0}, {1, 0, 0}};
    points.neighbors.append(std::vector<Index>{});
    points.neighbors.append(std::vector<Index>{});
    const NearPoints near(points);
    std::vector<Index> found;
    near.visitBall(1, [&](Index q) { found.push_back(q); });
    CHECK(found == std::vector<Index>{1});
}

TEST_CASE(
    "near points: a point that is not finite is in no ball, and one out of reach hides none") {
    PointSet points;
    const double bad = std::numeric_limits<double>::quiet_NaN();
    points.position = {{0, 0, 0}, {1e200, 0, 0}, {bad, 0, 0}};
    points.neighbors.append(std::vector<Index>{1});
    points.neighbors.append(std::vector<Index>{0});
    points.neighbors.append(std::vector<Index>{});
    const NearPoints near(points);
    std::vector<Index> found;
    near.visitBall(0, [&](Index q) { found.push_back(q); });
    CHECK(sorted(found) == std::vector<Index>{0, 1});
}
