/// Estimation of missing normals, and orientation of normals to a common side.
#include "spiraling_edge/prepare/normals.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

std::vector<Vec3> estimated(std::span<const Vec3> position, const NeighborLists& neighbors) {
    return std::move(estimateNormals(position, neighbors).value());
}
OrientationReport oriented(std::span<const Vec3> position, const NeighborLists& neighbors,
                           std::vector<Vec3>& normal) {
    return orientNormals(position, neighbors, normal).value();
}

/// The k nearest of each point, regardless of normals.
NeighborLists nearest(const std::vector<Vec3>& position, std::size_t k = 12) {
    const std::vector<bool> usable(position.size(), true);
    return findNeighbors(position, {}, usable, reach(k, false)).value();
}

/// Scale of closedFamilies() at which no point has its neighbors on another tube.
constexpr double kDense = 3.0;

/// Turns about half of the normals.
std::vector<Vec3> shuffledSides(std::vector<Vec3> normal, std::uint64_t seed) {
    Random random(seed);
    for (Vec3& n : normal) {
        if (random.below(2) == 1) n = -n;
    }
    return normal;
}

std::size_t against(const std::vector<Vec3>& normal, const std::vector<Vec3>& truth) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < normal.size(); ++p) {
        count += glm::dot(normal[p], truth[p]) <= 0.0 ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_CASE("normals: a plane has one normal, however it lies") {
    Random random(1);
    for (int turn = 0; turn < 50; ++turn) {
        const Vec3 n = random.direction();
        const Vec3 u = glm::normalize(glm::cross(n, random.direction()));
        const Vec3 v = glm::cross(n, u);
        std::vector<Vec3> position;
        for (int i = 0; i < 40; ++i) {
            position.push_back(1e3 * n + random.between(-1, 1) * u + random.between(-1, 1) * v);
        }
        for (const Vec3& found : estimated(position, nearest(position))) {
            CHECK(std::abs(glm::dot(found, n)) > 1 - 1e-9);
            CHECK(glm::dot(found, found) == doctest::Approx(1.0));
        }
    }
}

TEST_CASE("normals: those of even samples lie within a few degrees of the gradient") {
    for (const Family& family : closedFamilies(kDense)) {
        const PointFile file = family.sample(1);
        const auto found = estimated(file.position, nearest(file.position));
        double sum = 0.0;
        for (std::size_t p = 0; p < found.size(); ++p) {
            sum += std::acos(std::min(1.0, std::abs(glm::dot(found[p], file.normal[p]))));
        }
        CHECK_MESSAGE(sum / static_cast<double>(found.size()) * 180 / kPi < 6.0, family.name);
    }
}

TEST_CASE("normals: points without neighbors, or all in line, have none") {
    std::vector<Vec3> line;
    for (int i = 0; i < 10; ++i) line.push_back({1.0 * i, 2.0 * i, -0.5 * i});
    for (const Vec3& n : estimated(line, nearest(line))) CHECK(n == Vec3(0.0));
    NeighborLists none;
    none.append({});
    none.append(std::vector<Index>{0});
    for (const Vec3& n : estimated(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, none)) {
        CHECK(n == Vec3(0.0));
    }
    CHECK(estimated({}, NeighborLists{}).empty());
}

TEST_CASE("normals: they are the same for any number of threads") {
    const PointFile file = closedFamilies(20.0)[0].sample(1);
    const NeighborLists lists = nearest(file.position);
    const std::vector<Vec3> one = estimateNormals(file.position, lists, 1).value();
    for (const unsigned threads : {0U, 2U, 3U}) {
        CHECK(estimateNormals(file.position, lists, threads).value() == one);
    }
}

TEST_CASE("normals: cancelled work is an error, on any number of threads") {
    const PointFile file = closedFamilies(20.0)[0].sample(1);
    const NeighborLists lists = nearest(file.position);
    for (const unsigned threads : {1U, 3U}) {
        const auto normals = estimateNormals(file.position, lists, threads,
                                             [](double share) { return share < 0.5; });
        REQUIRE_FALSE(normals.ok());
        CHECK(normals.error().message == "the work on normals was cancelled");
    }
}

TEST_CASE("orientation: normals of closed surfaces point outward, in each component") {
    for (const Family& family : closedFamilies(1.0)) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const PointFile file = family.sample(seed);
            std::vector<Vec3> normal = shuffledSides(file.normal, seed);
            const std::size_t wrong = against(normal, file.normal);
            const auto report = oriented(file.position, nearest(file.position), normal);
            CHECK_MESSAGE(against(normal, file.normal) == 0, family.name, ", seed ", seed);
            CHECK(report.turned >= wrong);  // The first one may have been turned and turned back.
            CHECK(report.turned <= wrong + static_cast<std::size_t>(family.components));
            CHECK(report.doubtful == 0);
        }
    }
}

TEST_CASE("orientation: derived normals of closed surfaces point outward as well") {
    for (const Family& family : closedFamilies(kDense)) {
        const PointFile file = family.sample(2);
        const NeighborLists lists = nearest(file.position);
        std::vector<Vec3> normal = estimated(file.position, lists);
        oriented(file.position, lists, normal);
        CHECK_MESSAGE(against(normal, file.normal) == 0, family.name);
    }
}

TEST_CASE("orientation: it holds around the edges of a cube, where the plain cosine is zero") {
    PointFile cube;
    constexpr int kSide = 9;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double sign = face % 2 == 0 ? 1.0 : -1.0;
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                Vec3 x(0.0);
                x[axis] = sign;
                x[(axis + 1) % 3] = (i + 0.5) / kSide * 2 - 1;
                x[(axis + 2) % 3] = (j + 0.5) / kSide * 2 - 1;
                Vec3 n(0.0);
                n[axis] = sign;
                cube.position.push_back(x);
                cube.normal.push_back(n);
            }
        }
    }
    std::vector<Vec3> normal = shuffledSides(cube.normal, 5);
    oriented(cube.position, nearest(cube.position), normal);
    CHECK(against(normal, cube.normal) == 0);
}

TEST_CASE("orientation: normals on the two sides of a thin sheet point apart") {
    // Each point has a twin below it that is nearer than its neighbors.
    std::vector<Vec3> position;
    std::vector<Vec3> truth;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            for (const double z : {0.2, -0.2}) {
                position.push_back({i + 0.01 * j, j, z});
                truth.push_back({0, 0, z > 0 ? 1.0 : -1.0});
            }
        }
    }
    std::vector<Vec3> normal = shuffledSides(truth, 3);
    oriented(position, nearest(position, 8), normal);
    CHECK(against(normal, truth) == 0);
}

TEST_CASE("orientation: components are counted, and zero normals stay zero") {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    for (const double x : {0.0, 100.0}) {
        const PointFile ball = closedFamilies(0.3)[0].sample(1);
        for (std::size_t p = 0; p < ball.position.size(); ++p) {
            position.push_back(ball.position[p] + Vec3(x, 0, 0));
            normal.push_back(ball.normal[p]);
        }
    }
    const std::vector<Vec3> truth = normal;
    for (Vec3& n : normal) n = -n;
    normal[7] = Vec3(0.0);
    const auto report = oriented(position, nearest(position), normal);
    CHECK(report.components == 2);
    CHECK(normal[7] == Vec3(0.0));
    normal[7] = truth[7];
    CHECK(against(normal, truth) == 0);
}

TEST_CASE("normals: the plane is that of all points together, not one through the point") {
    // Eight points around, far below: about 0 they scatter most along z, about their mean least.
    std::vector<Vec3> position{Vec3(0)};
    std::vector<Index> list;
    for (int i = 0; i < 8; ++i) {
        position.push_back(3.0 * polar(45.0 * i) - Vec3(0, 0, 3));
        list.push_back(static_cast<Index>(i + 1));
    }
    NeighborLists lists;
    lists.append(list);
    for (int i = 0; i < 8; ++i) lists.append({});
    CHECK(std::abs(estimated(position, lists)[0].z) == doctest::Approx(1.0));
}
