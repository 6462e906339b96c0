#include "spiraling_edge/geometry/second_layer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

constexpr double kDegree = 0.017453292519943296;

/// Two triangles with corners of their own, 0 1 2 and 3 4 5, and normals upwards.
struct Pair {
    PointSet points;
    explicit Pair(std::vector<Vec3> corners) {
        points.position = std::move(corners);
        points.normal.assign(6, Vec3(0, 0, 1));
    }
    bool isLayer() const {
        const Triangle a{0, 1, 2};
        const Triangle b{3, 4, 5};
        const LayerShape shapeA = layerShape(points, a);
        const LayerShape shapeB = layerShape(points, b);
        const bool found = isSecondLayer(points, a, shapeA, b, shapeB);
        CHECK(found == isSecondLayer(points, b, shapeB, a, shapeA));
        return found;
    }
};

/// An equilateral triangle of edge 1, and the same one moved and turned about the x axis.
Pair moved(const Vec3& by, double degrees = 0.0) {
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    const Vec3 corners[3] = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}};
    std::vector<Vec3> all(corners, corners + 3);
    for (const Vec3& x : corners) all.push_back(Vec3(x.x, c * x.y, s * x.y) + by);
    return Pair(std::move(all));
}

}  // namespace

TEST_CASE("second layer: the gap is at most half of the mean edge length") {
    CHECK(moved({0, 0, 0.499}).isLayer());
    CHECK(moved({0, 0, -0.499}).isLayer());
    CHECK_FALSE(moved({0, 0, 0.501}).isLayer());
    // In one plane, and even one on the other.
    CHECK(moved({0.5, 0, 0}).isLayer());
    CHECK(moved({0, 0, 0}).isLayer());
}

TEST_CASE("second layer: of a slanted pair the least gap counts") {
    // From 0.3 at the hinge to 0.8 at the tip.
    CHECK(moved({0, 0, 0.3}, 30.0).isLayer());
    CHECK_FALSE(moved({0, 0, 0.7}, 30.0).isLayer());
}

TEST_CASE("second layer: the least gap counts at whichever corner it is") {
    for (const double height : {0.3, 0.7}) {
        CAPTURE(height);
        Pair pair = moved({0, 0, height}, 30.0);
        for (int turn = 0; turn < 3; ++turn) {
            CHECK(pair.isLayer() == (height < 0.5));
            const auto corner = pair.points.position.begin();
            std::rotate(corner, corner + 1, corner + 3);
            std::rotate(corner + 3, corner + 4, corner + 6);
        }
    }
}

TEST_CASE("second layer: normals enclose at most 45 degrees") {
    CHECK(moved({0, 0, 0.1}, 44.0).isLayer());
    CHECK_FALSE(moved({0, 0, 0.1}, 46.0).isLayer());
}

TEST_CASE("second layer: two percent of the smaller triangle lie over or under the other") {
    // Moved along x by t, two equilateral triangles share one of edge 1 - t.
    const double two = 1.0 - std::sqrt(0.02);
    CHECK(moved({two - 0.001, 0, 0.1}).isLayer());
    CHECK_FALSE(moved({two + 0.001, 0, 0.1}).isLayer());
    // A small one over a large one: all of it counts, 0.01 % of the other.
    Pair small = moved({0, 0, 0});
    for (int i = 3; i < 6; ++i) {
        Vec3& x = small.points.position[static_cast<std::size_t>(i)];
        x = 0.01 * x + Vec3(0.4, 0.2, 0.1);
    }
    CHECK(small.isLayer());
}

TEST_CASE("second layer: over the other at a common edge or corner, not beside it") {
    // Third corner on either side of a common edge, in both windings.
    for (const double across : {-0.6, -1e-3, 1e-3, 0.6}) {
        for (const bool turned : {false, true}) {
            Pair pair({{0, 0, 0}, {1, 0, 0}, {0.5, 0.6, 0}, {0.5, across, 0.01}, {}, {}});
            const Triangle a{0, 1, 2};
            const Triangle b = turned ? Triangle{0, 1, 3} : Triangle{1, 0, 3};
            CAPTURE(across);
            // At 0.001 it is upright.
            CHECK(isSecondLayer(pair.points, a, b) == (across > 1e-2));
        }
    }
    // A corner in common: turned away from the other, and over it.
    for (const bool over : {false, true}) {
        const double y = over ? 0.5 : -0.5;
        Pair pair({{0, 0, 0}, {1, 0, 0}, {0.5, 0.6, 0}, {0.2, y, 0.01}, {0.8, y, 0.01}, {}});
        CHECK(isSecondLayer(pair.points, {0, 1, 2}, {0, 3, 4}) == over);
        CHECK(isSecondLayer(pair.points, {0, 1, 2}, {0, 4, 3}) == over);
    }
}

TEST_CASE("second layer: a normal is turned to the side of its corners' normals") {
    Pair pair = moved({0, 0, 0.1});
    std::swap(pair.points.position[1], pair.points.position[2]);  // inside out
    CHECK(pair.isLayer());
    // The other side of a thin wall faces the other way.
    for (std::size_t i = 3; i < 6; ++i) pair.points.normal[i] = Vec3(0, 0, -1);
    CHECK_FALSE(pair.isLayer());
}

TEST_CASE("second layer: none without area") {
    Pair pair = moved({0, 0, 0.1});
    pair.points.position[5] = pair.points.position[4];
    CHECK_FALSE(pair.isLayer());
}

TEST_CASE("conflict: two triangles that cross, or of which one is a second layer of the other") {
    const auto inConflict = [](const Pair& pair) {
        const PointSet& points = pair.points;
        const Triangle a{0, 1, 2};
        const Triangle b{3, 4, 5};
        const ShapedTriangle shaped(points, a);
        const bool found = conflict(points, a, b);
        CHECK(found == conflict(points, shaped, b));
        CHECK(found == conflict(points, shaped, ShapedTriangle(points, b)));
        return found;
    };
    CHECK(inConflict(moved({0, 0, 0.499})));
    CHECK_FALSE(inConflict(moved({0, 0, 0.501})));
    CHECK(inConflict(moved({0, 0.1, -0.2}, 80.0)));
    CHECK_FALSE(inConflict(moved({0, 0.1, 0.2}, 80.0)));
}

TEST_CASE("second layer: no pair of a sphere, of a torus or of two joined") {
    for (const char* name : {"sphere", "torus", "genus-2"}) {
        const PointSet points = sceneNamed(name);
        const std::vector<Triangle> mesh = runAll(points, *paramsByName("robust")).state.mesh();
        std::vector<LayerShape> shapes;
        for (const Triangle& t : mesh) shapes.push_back(layerShape(points, t));
        std::size_t layers = 0;
        for (std::size_t i = 0; i < mesh.size(); ++i) {
            for (std::size_t j = i + 1; j < mesh.size(); ++j)
                layers += isSecondLayer(points, mesh[i], shapes[i], mesh[j], shapes[j]) ? 1U : 0U;
        }
        CHECK_MESSAGE(layers == 0, name);
    }
}
