#include "spiraling_edge/points/usable_points.h"

#include <doctest/doctest.h>

#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

/// Six points with everything that a file can hold; the triangles leave 0 and 3 out.
PointFile sixPoints() {
    PointFile file;
    for (int i = 0; i < 6; ++i) {
        file.position.emplace_back(i, 0.1 * i, i * i);
        file.normal.emplace_back(0.0, 0.0, i % 2 == 0 ? 1.0 : -1.0);
        file.type.push_back(static_cast<std::uint8_t>(i));
    }
    file.attributes.push_back({"red", ScalarType::UInt8, {10, 11, 12, 13, 14, 15}});
    for (const std::vector<Index>& list :
         {std::vector<Index>{1, 2}, {0, 2, 3}, {3, 0}, {}, {5, 3, 1}, {4, 9}}) {
        file.neighbors.append(list);
    }
    return file;
}

const std::vector<Triangle> kTriangles = {{4, 5, 1}, {1, 5, 2}};

}  // namespace

TEST_CASE("used points: those in no triangle go, with their normals, types and attributes") {
    const PointFile all = sixPoints();
    const PointFile used = withUsedPoints(all, kTriangles);
    CHECK(countUsedPoints(all.position.size(), kTriangles) == 4);
    CHECK(used.position ==
          std::vector<Vec3>{all.position[1], all.position[2], all.position[4], all.position[5]});
    CHECK(used.normal ==
          std::vector<Vec3>{all.normal[1], all.normal[2], all.normal[4], all.normal[5]});
    CHECK(used.type == std::vector<std::uint8_t>{1, 2, 4, 5});
    REQUIRE(used.attributes.size() == 1);
    CHECK(used.attributes[0].values == std::vector<double>{11, 12, 14, 15});
    CHECK(used.faces == std::vector<Triangle>{{2, 3, 0}, {0, 3, 1}});
}

TEST_CASE("used points: lists lose the entries of points that went, and keep their order") {
    const PointFile used = withUsedPoints(sixPoints(), kTriangles);
    REQUIRE(used.neighbors.size() == 4);
    const auto list = [&](Index p) {
        const auto entries = used.neighbors[p];
        return std::vector<Index>(entries.begin(), entries.end());
    };
    CHECK(list(0) == std::vector<Index>{1});
    CHECK(list(1).empty());
    CHECK(list(2) == std::vector<Index>{3, 0});
    CHECK(list(3) == std::vector<Index>{2});
}

TEST_CASE("used points: a mesh that uses all points is as it was, without triangles none is left") {
    PointFile all = sixPoints();
    all.neighbors = {};
    const std::vector<Triangle> every = {{0, 1, 2}, {3, 4, 5}};
    const PointFile used = withUsedPoints(all, every);
    CHECK(used.faces == every);
    CHECK(used.position == all.position);
    CHECK(used.attributes[0].values == all.attributes[0].values);
    CHECK_FALSE(used.hasNeighbors());
    CHECK(withUsedPoints(all, {}).position.empty());
    CHECK(countUsedPoints(6, {}) == 0);
}

TEST_CASE("derived normals and types are stored with the points, given ones stay") {
    PointFile file = closedFamilies(6.0)[0].sample(1);
    file.normalType = ScalarType::Float;
    file.positionType = ScalarType::Double;
    PointFile stored = file;
    const Prepared given = prepare(file, {}).value();
    storeDerived(given.points, given.report, stored);
    CHECK(stored.normal == file.normal);
    CHECK(stored.normalType == ScalarType::Float);
    CHECK(stored.type == file.type);
    PrepareOptions options;
    options.normals = NormalSource::Derived;
    options.walls = boxAround(file.position);
    const Prepared derived = prepare(file, options).value();
    storeDerived(derived.points, derived.report, stored);
    CHECK(stored.normal == derived.points.normal);
    CHECK(stored.normalType == ScalarType::Double);
    CHECK(stored.type == derived.points.type);
}
