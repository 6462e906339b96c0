#include "spiraling_edge/geometry/edge_planes.h"

#include <doctest/doctest.h>

#include <random>

using namespace se;

namespace {

/// Six points near each other in a flat box, normals upward, so that many pairs are layers or meet.
PointSet crowd(std::mt19937& random) {
    const auto place = [&random] { return static_cast<double>(random() % 1000) / 1000.0; };
    PointSet points;
    for (int i = 0; i < 6; ++i) {
        const double x = place();
        const double y = place();
        points.position.emplace_back(x, y, 0.5 * place());
        points.normal.emplace_back(0.0, 0.0, 1.0);
    }
    return points;
}

unsigned commonSides(const EdgePlanes& planes, const Triangle& t) {
    return planes.sidesOf(t.a) & planes.sidesOf(t.b) & planes.sidesOf(t.c);
}

/// True if the planes of `a` tell the two apart.
bool toldApart(const PointSet& points, const Triangle& a, const Triangle& b) {
    const ShapedTriangle shapedA(points, a);
    const ShapedTriangle shapedB(points, b);
    return EdgePlanes::tellApart(commonSides(EdgePlanes(points, shapedA), b), shapedA.shape,
                                 shapedB.shape);
}

}  // namespace

TEST_CASE("edge planes: triangles that they tell apart have no conflict") {
    std::mt19937 random(5);
    const Triangle first{0, 1, 2};
    // With no corner in common, one, and two.
    for (const Triangle& second : {Triangle{3, 4, 5}, Triangle{0, 4, 5}, Triangle{1, 0, 5}}) {
        int apart = 0;
        int conflicts = 0;
        for (int i = 0; i < 40000; ++i) {
            const PointSet points = crowd(random);
            const bool inConflict = conflict(points, first, second);
            const bool told = toldApart(points, first, second);
            apart += told ? 1 : 0;
            conflicts += inConflict ? 1 : 0;
            if (told) REQUIRE_FALSE(inConflict);
        }
        CHECK(apart > 1000);
        CHECK(conflicts > 1000);
    }
}

TEST_CASE("edge planes: a triangle on the same corners is not told apart") {
    std::mt19937 random(6);
    PointSet points = crowd(random);
    CHECK_FALSE(toldApart(points, {0, 1, 2}, {1, 2, 0}));
    CHECK_FALSE(toldApart(points, {0, 1, 2}, {0, 2, 1}));
    // Nor without normals, by which the two would face the same way.
    points.normal.assign(6, Vec3(0.0));
    CHECK_FALSE(toldApart(points, {0, 1, 2}, {0, 2, 1}));
}

TEST_CASE("edge planes: a triangle without area tells nothing apart") {
    std::mt19937 random(7);
    PointSet points = crowd(random);
    points.position[2] = 0.5 * (points.position[0] + points.position[1]);
    points.position[3] += Vec3(100, 0, 0);
    points.position[4] += Vec3(100, 0, 0);
    points.position[5] += Vec3(100, 0, 0);
    CHECK_FALSE(toldApart(points, {0, 1, 2}, {3, 4, 5}));
}
