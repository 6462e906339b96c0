#include "spiraling_edge/geometry/triangle_shape.h"

#include <doctest/doctest.h>

#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

TEST_CASE("shape faults do not depend on which corner comes first") {
    // The edge 0 1 runs along the normals of its ends: the triangle faces them neither way, and
    // rounding decides. Flips of edges went on forever where it decided otherwise each time.
    Random random(3);
    int faulty = 0;
    for (int i = 0; i < 1000; ++i) {
        PointSet points;
        const Vec3 normal = random.direction();
        points.position = {random.inCube(), {}, random.inCube()};
        points.position[1] = points.position[0] + 0.3 * normal;
        points.normal = {normal, normal, random.direction()};
        const int first = shapeFaults(points, {0, 1, 2});
        CHECK(shapeFaults(points, {1, 2, 0}) == first);
        CHECK(shapeFaults(points, {2, 0, 1}) == first);
        faulty += first == 0 ? 0 : 1;
    }
    CHECK(faulty > 500);
    CHECK(faulty < 1000);
}

TEST_CASE("a triangle begins with its least corner, in the same direction") {
    for (const Triangle& t : {Triangle{4, 7, 9}, Triangle{9, 4, 7}, Triangle{7, 9, 4}}) {
        const Triangle s = fromLeastCorner(t);
        CHECK(s.a == 4);
        CHECK(s.b == 7);
        CHECK(s.c == 9);
    }
}

TEST_CASE("shape faults: four for a flipped triangle, one for a single normal against it") {
    PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(shapeFaults(points, {0, 1, 2}) == 0);
    CHECK(shapeFaults(points, {0, 2, 1}) == 4);
    points.normal[1] = {0, 0, -1};
    CHECK(shapeFaults(points, {0, 1, 2}) == 1);
    CHECK(shapeFaults(points, {0, 2, 1}) == 4);
    points.normal[2] = {0, 0, -1};
    CHECK(shapeFaults(points, {0, 1, 2}) == 4);
    CHECK(shapeFaults(points, {0, 2, 1}) == 1);
}
