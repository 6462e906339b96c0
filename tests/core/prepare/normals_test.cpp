/// Estimation of missing normals.
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
        for (const Vec3& found : estimated(position, nearestLists(position))) {
            CHECK(std::abs(glm::dot(found, n)) > 1 - 1e-9);
            CHECK(glm::dot(found, found) == doctest::Approx(1.0));
        }
    }
}

TEST_CASE("normals: those of even samples lie within a few degrees of the gradient") {
    for (const Family& family : closedFamilies(kTubesApart)) {
        const PointFile file = family.sample(1);
        const auto found = estimated(file.position, nearestLists(file.position));
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
    for (const Vec3& n : estimated(line, nearestLists(line))) CHECK(n == Vec3(0.0));
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
    const NeighborLists lists = nearestLists(file.position);
    const std::vector<Vec3> one = estimateNormals(file.position, lists, 1).value();
    for (const unsigned threads : {0U, 2U, 3U}) {
        CHECK(estimateNormals(file.position, lists, threads).value() == one);
    }
}

TEST_CASE("normals: cancelled work is an error, on any number of threads") {
    const PointFile file = closedFamilies(20.0)[0].sample(1);
    const NeighborLists lists = nearestLists(file.position);
    for (const unsigned threads : {1U, 3U}) {
        const auto normals = estimateNormals(file.position, lists, threads,
                                             [](double share) { return share < 0.5; });
        REQUIRE_FALSE(normals.ok());
        CHECK(normals.error().message == "the work on normals was cancelled");
    }
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
