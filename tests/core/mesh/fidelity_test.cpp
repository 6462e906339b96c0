#include "spiraling_edge/mesh/fidelity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

/// A triangle in the plane z = 0, and further points in no triangle.
PointSet withPoints(std::vector<Vec3> others) {
    PointSet points;
    points.position = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
    points.position.insert(points.position.end(), others.begin(), others.end());
    return points;
}
double distanceTo(const Vec3& x) {
    return fidelityOf(withPoints({x}), Triangles{{0, 1, 2}}).greatestDistance;
}

// The distance once more, in the plainest way: of all triangles, by the foot in the plane or on a
// side. Shares nothing with fidelity.cpp.

double plainToSide(const Vec3& x, const Vec3& a, const Vec3& b) {
    double along = 0.0;
    double length = 0.0;
    for (int i = 0; i < 3; ++i) {
        along += (x[i] - a[i]) * (b[i] - a[i]);
        length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double share = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += std::pow(x[i] - a[i] - share * (b[i] - a[i]), 2);
    return std::sqrt(sum);
}

double plainDistance(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double sides =
        std::min({plainToSide(x, a, b), plainToSide(x, b, c), plainToSide(x, c, a)});
    const Vec3 n = glm::cross(b - a, c - a);
    const double size = std::sqrt(glm::dot(n, n));
    if (!(size > 0.0)) return sides;
    const double height = glm::dot(x - a, n) / size;
    const Vec3 foot = x - height / size * n;
    const auto isLeft = [&](const Vec3& from, const Vec3& to) {
        return glm::dot(glm::cross(to - from, foot - from), n) >= 0.0;
    };
    const bool inside = isLeft(a, b) && isLeft(b, c) && isLeft(c, a);
    return inside ? std::abs(height) : sides;
}

/// Greatest and mean distance of all points, those in triangles included.
Fidelity plainFidelity(const PointSet& points, const Triangles& triangles) {
    Fidelity plain;
    double sum = 0.0;
    for (const Vec3& x : points.position) {
        double nearest = std::numeric_limits<double>::max();
        for (const Triangle& t : triangles) {
            nearest = std::min(nearest, plainDistance(x, points.position[t.a], points.position[t.b],
                                                      points.position[t.c]));
        }
        plain.greatestDistance = std::max(plain.greatestDistance, nearest);
        sum += nearest;
    }
    plain.meanDistance = sum / static_cast<double>(points.size());
    return plain;
}

void checkWithinOnePercent(const PointSet& points, const Triangles& triangles) {
    const Fidelity ours = fidelityOf(points, triangles);
    const Fidelity plain = plainFidelity(points, triangles);
    // Points in triangles are on them up to rounding.
    const auto near = [](double a, double b) { return std::abs(a - b) <= 0.01 * b + 1e-12; };
    CHECK(near(ours.greatestDistance, plain.greatestDistance));
    CHECK(near(ours.meanDistance, plain.meanDistance));
}

}  // namespace

TEST_CASE("fidelity: distances agree with plain loops on random meshes, needles included") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        Random random(seed);
        PointSet points;
        Triangles triangles;
        for (Index i = 0; i < 60; ++i) {
            const Vec3 center = 3.0 * random.inCube();
            const double thin = seed % 2 == 0 ? 1e-6 : 1.0;
            points.position.push_back(center);
            points.position.push_back(center + random.inCube());
            points.position.push_back(points.position.back() + thin * random.inCube());
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        for (int i = 0; i < 100; ++i) points.position.push_back(4.0 * random.inCube());
        checkWithinOnePercent(points, triangles);
    }
}

TEST_CASE("fidelity: distances agree with plain loops on scenes with points left out") {
    for (const char* scene : {"noise", "stranded-point", "uneven-density", "near-duplicates"}) {
        CAPTURE(scene);
        const PointSet points = sceneNamed(scene);
        Triangles triangles = runAll(points, paper()).state.mesh();
        checkWithinOnePercent(points, triangles);
        // A third of the mesh alone leaves many points out.
        triangles.resize(triangles.size() / 3);
        const Fidelity ours = fidelityOf(points, triangles);
        CHECK(ours.greatestDistance > 0.0);
        checkWithinOnePercent(points, triangles);
    }
}

TEST_CASE("fidelity: a place where a missing value was written is no point to be near to") {
    PointSet points = withPoints({{1, 1, 2}, {900, 0, 0}});
    points.aside.assign(points.size(), Aside::No);
    points.aside.back() = Aside::Sentinel;
    const Triangles triangles{{0, 1, 2}};
    CHECK(std::isnan(distancesFromMesh(points, triangles).back()));
    const Fidelity fidelity = fidelityOf(points, triangles);
    CHECK(fidelity.greatestDistance == doctest::Approx(2.0));
    CHECK(fidelity.meanDistance == doctest::Approx(0.5));
}

TEST_CASE("fidelity: points in triangles have no distance") {
    const Fidelity fidelity = fidelityOf(withPoints({}), Triangles{{0, 1, 2}});
    CHECK(fidelity.greatestDistance == 0.0);
    CHECK(fidelity.meanDistance == 0.0);
    CHECK(fidelityOf(withPoints({}), {}).greatestDistance == 0.0);
}

TEST_CASE("fidelity: the distance is to the inside, a side or a corner of the triangle") {
    CHECK(distanceTo({1, 1, 2}) == doctest::Approx(2.0));
    CHECK(distanceTo({1, -2, 0}) == doctest::Approx(2.0));
    CHECK(distanceTo({-1, 1, 1}) == doctest::Approx(std::sqrt(2.0)));
    CHECK(distanceTo({3.2, 3.1, 0}) == doctest::Approx(2.0));  // from 3x + 4y = 12
    CHECK(distanceTo({-3, -4, 0}) == doctest::Approx(5.0));
    CHECK(distanceTo({7, -4, 0}) == doctest::Approx(5.0));
    CHECK(distanceTo({0, 5, 0}) == doctest::Approx(2.0));
}

TEST_CASE("fidelity: the mean is over all points with a finite position") {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const Fidelity fidelity =
        fidelityOf(withPoints({{1, 1, 2}, {1, 1, -3}, {kNan, 0, 0}}), Triangles{{0, 1, 2}});
    CHECK(fidelity.greatestDistance == doctest::Approx(3.0));
    CHECK(fidelity.meanDistance == doctest::Approx(1.0));  // 5 over 5 points
}

TEST_CASE("fidelity: the nearest of many triangles is the one that trying all finds") {
    Random random(7);
    PointSet points;
    Triangles triangles;
    for (Index i = 0; i < 300; ++i) {
        const Vec3 center = 10.0 * random.inCube();
        for (int k = 0; k < 3; ++k) points.position.push_back(center + random.inCube());
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    for (int i = 0; i < 100; ++i) {
        PointSet one = points;
        one.position.push_back(15.0 * random.inCube());
        double nearest = std::numeric_limits<double>::max();
        for (const Triangle& t : triangles) {
            PointSet alone;
            alone.position = {points.position[t.a], points.position[t.b], points.position[t.c],
                              one.position.back()};
            const Fidelity fidelity = fidelityOf(alone, Triangles{{0, 1, 2}});
            nearest = std::min(nearest, fidelity.greatestDistance);
        }
        CHECK(fidelityOf(one, triangles).greatestDistance == nearest);
    }
}

TEST_CASE("fidelity: the distance of each point, and none where there is nothing to measure") {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const PointSet points = withPoints({{1, 1, 2}, {kNan, 0, 0}});
    const std::vector<double> distances = distancesFromMesh(points, Triangles{{0, 1, 2}});
    REQUIRE(distances.size() == 5);
    CHECK(distances[0] == 0.0);
    CHECK(distances[3] == doctest::Approx(2.0));
    CHECK(std::isnan(distances[4]));
    for (const double each : distancesFromMesh(points, {})) CHECK(std::isnan(each));
}
