/// Beyond the paper, after the last pivot, at triangles with a fault: remesh (docs/robust.md).
#include <doctest/doctest.h>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

TEST_CASE("faulty: a flipped triangle, and one far off its normals in conflict with another") {
    const PointSet points =
        flatPoints({{0, 0, 0}, {2, 0, 0}, {1, 1, 1.2}, {1, 0.4, -1}, {1.2, 0.4, 2}, {0.8, 0.4, 2}});
    RepairState alone = beginRepair(6, {{0, 1, 2}});
    CHECK_FALSE(isFaulty(points, alone, 0));
    RepairState cut = beginRepair(6, {{0, 1, 2}, {3, 4, 5}});
    CHECK(isFaulty(points, cut, 0));
    RepairState flipped = beginRepair(6, {{1, 0, 2}});
    CHECK(isFaulty(points, flipped, 0));
}

TEST_CASE("remesh: a flipped triangle that no single flip mends") {
    // An L, as a fan from a corner that does not see all of it.
    const PointSet points =
        flatPoints({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
    const Triangles fan{{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 0}};
    REQUIRE(flippedIn(points, fan) == 1);
    RepairState flips = beginRepair(6, fan);
    while (flipNext(points, RobustThresholds{}, flips)) {
    }
    CHECK(flippedIn(points, flips.triangles) > 0);

    RepairState m = beginRepair(6, fan);
    const auto step = remeshNext(points, m);
    REQUIRE(step);
    CHECK(step->faulty == Triangle{1, 3, 4});
    CHECK(m.triangles.size() == fan.size());
    CHECK(flippedIn(points, m.triangles) == 0);
    CHECK(manifoldFault(m) == "");
    CHECK_FALSE(remeshNext(points, m));
}

TEST_CASE("remesh: replaces more than four triangles where four do not suffice") {
    // A U, as a fan from the end of one arm.
    const PointSet points = flatPoints(
        {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
    const Triangles fan{{2, 3, 4}, {2, 4, 5}, {2, 5, 6}, {2, 6, 7}, {2, 7, 0}, {2, 0, 1}};
    REQUIRE(flippedIn(points, fan) == 2);
    RepairState m = beginRepair(8, fan);
    REQUIRE(remeshNext(points, m));
    CHECK(m.triangles.size() == fan.size());
    CHECK(flippedIn(points, m.triangles) == 0);
    CHECK(manifoldFault(m) == "");
}

TEST_CASE("remesh: in the last round a point outside of its triangles gets others around it") {
    std::vector<Vec3> position = gridPoints();
    position[gridPoint(3, 3)] = {5.2, 3.9, 0};
    const PointSet points = flatPoints(position);
    const auto flippedAfter = [&](std::uint32_t round) {
        RepairState m = beginRepair(points.size(), gridWithout({}));
        REQUIRE(flippedIn(points, m.triangles) > 0);
        m.round = round;
        while (remeshNext(points, m)) {
        }
        CHECK(m.triangles.size() == gridWithout({}).size());
        CHECK(manifoldFault(m) == "");
        return flippedIn(points, m.triangles);
    };
    CHECK(flippedAfter(0) > 0);
    CHECK(flippedAfter(kSettlingRound) == 0);
}

TEST_CASE("remesh: leaves a mesh without faults alone") {
    const PointSet points = flatPoints(gridPoints());
    RepairState m = beginRepair(points.size(), gridWithout({gridPoint(3, 3)}));
    CHECK_FALSE(remeshNext(points, m));
    CHECK(m.triangles == gridWithout({gridPoint(3, 3)}));
}
