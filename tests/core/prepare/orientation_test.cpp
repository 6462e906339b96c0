/// Orientation of normals to a common side.
#include "spiraling_edge/prepare/orientation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "spiraling_edge/prepare/normals.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

OrientationReport oriented(std::span<const Vec3> position, const NeighborLists& neighbors,
                           std::vector<Vec3>& normal) {
    return orientNormals(position, neighbors, normal).value();
}

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

TEST_CASE("orientation: normals of closed surfaces point outward, in each component") {
    for (const Family& family : closedFamilies(1.0)) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const PointFile file = family.sample(seed);
            std::vector<Vec3> normal = shuffledSides(file.normal, seed);
            const std::size_t wrong = against(normal, file.normal);
            const auto report = oriented(file.position, nearestLists(file.position), normal);
            CHECK_MESSAGE(against(normal, file.normal) == 0, family.name, ", seed ", seed);
            CHECK(report.turned >= wrong);  // The first one may have been turned and turned back.
            CHECK(report.turned <= wrong + static_cast<std::size_t>(family.components));
            CHECK(report.doubtful == 0);
        }
    }
}

TEST_CASE("orientation: derived normals of closed surfaces point outward as well") {
    for (const Family& family : closedFamilies(kTubesApart)) {
        const PointFile file = family.sample(2);
        const NeighborLists lists = nearestLists(file.position);
        std::vector<Vec3> normal = estimateNormals(file.position, lists).value();
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
    oriented(cube.position, nearestLists(cube.position), normal);
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
    oriented(position, nearestLists(position, 8), normal);
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
    const auto report = oriented(position, nearestLists(position), normal);
    CHECK(report.components == 2);
    CHECK(normal[7] == Vec3(0.0));
    normal[7] = truth[7];
    CHECK(against(normal, truth) == 0);
}
