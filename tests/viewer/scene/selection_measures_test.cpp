#include "run/selection.h"

#include <doctest/doctest.h>

#include <cmath>

#include "run/strings.h"
#include "spiraling_edge/geometry/triangle_shape.h"

using namespace se;
using namespace se::view;

namespace {

/// A square of side 2 in the plane z = 0, seen from above, and a point over its middle.
PointSet square() {
    PointSet points;
    points.position = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0.5}};
    points.normal.assign(5, Vec3(0, 0, 1));
    return points;
}

}  // namespace

TEST_CASE("Numbers: values that round to zero have no sign") {
    for (const double zero : {0.0, -0.0}) {
        CHECK(numberText(zero) == "0");
        CHECK(signedText(zero) == "0");
    }
    CHECK(degreesText(-0.04) == "0.0\xC2\xB0");
    CHECK(percentText(-0.0001) == "0.0 %");
    CHECK(numbersText({-0.0, 1.5, -2.0}) == "0, 1.5, -2");
}

TEST_CASE("Numbers: other values keep their sign and four digits") {
    CHECK(numberText(-0.123456) == "-0.1235");
    CHECK(signedText(0.5) == "+0.5");
    CHECK(signedText(-1e-7) == "-1e-07");
    CHECK(degreesText(-12.34) == "-12.3\xC2\xB0");
    CHECK(percentText(0.034) == "+3.4 %");
    CHECK(durationText(0.0009074) == "0.91 ms");
    CHECK(durationText(0.25) == "250 ms");
    CHECK(durationText(2.5) == "2.5 s");
}

TEST_CASE("Measures: a half square has angles of 90, 45 and 45 degrees, and area 2") {
    const PointSet points = square();
    const Triangle t{0, 1, 2};
    CHECK(cornerDegrees(points, t)[1] == doctest::Approx(90.0));
    CHECK(leastDegrees(points, t) == doctest::Approx(45.0));
    CHECK(triangleArea(points, t) == doctest::Approx(2.0));
    CHECK(circleRadius(points, t) == doctest::Approx(std::sqrt(2.0)));
    CHECK(std::isinf(circleRadius(points, {0, 1, 1})));
}

TEST_CASE("Measures: the least angle of several triangles is that of the worst") {
    const PointSet points = square();
    const std::vector<Triangle> two = {{0, 1, 2}, {0, 1, 4}};
    CHECK(leastDegrees(points, two) == doctest::Approx(leastDegrees(points, two[0])));
    CHECK(leastDegrees(points, std::vector<Triangle>{}) == 0.0);
}

TEST_CASE("Measures: a triangle the other way round is against all normals") {
    const PointSet points = square();
    CHECK(tiltDegrees(points, {0, 1, 2}) == doctest::Approx(0.0));
    CHECK_FALSE(isFlipped(points, {0, 1, 2}));
    CHECK(tiltDegrees(points, {0, 2, 1}) == doctest::Approx(180.0));
    CHECK(isFlipped(points, {0, 2, 1}));
}

TEST_CASE("Measures: a free angle is counted counterclockwise about the normal") {
    const PointSet points = square();
    CHECK(freeDegrees(points, 1, 0, 3) == doctest::Approx(90.0));
    CHECK(freeDegrees(points, 3, 0, 1) == doctest::Approx(270.0));
    CHECK(heightOver(points, 0, 4) == doctest::Approx(0.5));
}
