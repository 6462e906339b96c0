#include "spiraling_edge/points/usable_points.h"

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "support/clouds.h"
#include "support/oracles.h"

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

// ---- missing values -----------------------------------------------------------------------------

namespace {

using Places = std::vector<Vec3>;

/// Heights of a hilly raster of side x side places, 10 apart, from `low` over 80.
Places raster(int side, double low) {
    Places places;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i)
            places.emplace_back(4e5 + 10.0 * i, 5e6 + 10.0 * j,
                                low + 40.0 + 40.0 * std::sin(i / 7.0) * std::cos(j / 9.0));
    }
    return places;
}

/// One in twenty by chance.
std::vector<Index> some(std::size_t count) {
    Random random(3);
    std::vector<Index> points;
    for (Index p = 0; p < count; ++p) {
        if (random.below(20) == 0) points.push_back(p);
    }
    return points;
}

std::vector<Index> sentinelsOf(const Places& places) {
    const PlacedPoints placed = placedPoints(places);
    std::vector<Index> points;
    for (Index p = 0; p < places.size(); ++p) {
        if (placed.aside[p] == Aside::Sentinel) points.push_back(p);
    }
    return points;
}

/// True if exactly the points with this height are found.
bool isFound(Places places, const std::vector<Index>& points, double value, int axis = 2) {
    for (const Index p : points) places[p][axis] = value;
    return sentinelsOf(places) == points;
}

}  // namespace

TEST_CASE("missing values: a height that stands for none is found, whatever its number") {
    const Places heights = raster(50, 500.0);
    for (const double value : {-9999.0, -999.0, -32768.0, 0.0, -1.0, 255.0, 1e30, -88.88})
        CHECK_MESSAGE(isFound(heights, some(heights.size()), value), value);
    // A lake without values.
    std::vector<Index> lake;
    for (Index j = 20; j < 32; ++j) {
        for (Index i = 10; i < 26; ++i) lake.push_back(50 * j + i);
    }
    for (const double value : {-9999.0, -999.0, 0.0, -1.0})
        CHECK_MESSAGE(isFound(heights, lake, value), value);
    // Two kinds in one file.
    Places two = heights;
    for (const Index p : some(two.size())) two[p].z = p % 2 == 0 ? -9999.0 : 0.0;
    CHECK(sentinelsOf(two) == some(two.size()));
}

TEST_CASE("missing values: a depth that was not measured is found on closed shapes, on each axis") {
    for (int axis = 0; axis < 3; ++axis) {
        Places sphere = fibonacciSphere(900).position;
        for (Vec3& x : sphere) x += 4.0;
        for (const double value : {0.0, -1.0, -999.0, -32768.0, 10000.0})
            CHECK_MESSAGE(isFound(sphere, some(sphere.size()), value, axis), value);
        // Three points are enough.
        for (const double value : {0.0, -1.0, -999.0})
            CHECK_MESSAGE(isFound(sphere, {1, 301, 601}, value, axis), value);
    }
}

TEST_CASE("missing values: planes of a scene are none, at any height and in any order") {
    // A floor below a shape, after it and mixed with it.
    for (const double height : {0.0, -1.0, -100.0, 10000.0}) {
        Places scene = fibonacciSphere(900).position;
        for (Vec3& x : scene) x = 10.0 * x + Vec3(0.0, 0.0, 40.0);
        for (int i = 0; i < 900; ++i) scene.emplace_back(i % 30 - 15.0, i / 30 - 15.0, height);
        CHECK_MESSAGE(sentinelsOf(scene).empty(), height);
        Random random(5);
        for (std::size_t p = scene.size(); p > 1; --p)
            std::swap(scene[p - 1], scene[random.below(p)]);
        CHECK_MESSAGE(sentinelsOf(scene).empty(), height);
    }
    // The ground about a house with a pitched roof, from above.
    Places house = raster(40, 0.0);
    for (std::size_t p = 0; p < house.size(); ++p) {
        const int i = static_cast<int>(p % 40);
        const bool roof = i >= 4 && i < 36 && p / 40 >= 4 && p / 40 < 36;
        house[p].z = roof ? 3.0 + 0.1 * std::abs(i - 20) : 0.0;
    }
    CHECK(sentinelsOf(house).empty());
    // The feet of a table, and plates over each other.
    Places table;
    for (int i = 0; i < 900; ++i) table.emplace_back(i % 30, i / 30, 20.0 + 0.01 * (i % 7));
    for (int i = 0; i < 16; ++i)
        table.emplace_back(29.0 * (i % 2) + 0.3 * (i / 8), 29.0 * (i / 2 % 2) + 0.3 * (i / 4 % 2),
                           0.0);
    CHECK(sentinelsOf(table).empty());
    Places plates;
    for (const double height : {0.0, 10.0, 1000.0}) {
        for (int i = 0; i < 400; ++i) plates.emplace_back(i % 20, i / 20, height);
    }
    CHECK(sentinelsOf(plates).empty());
}

TEST_CASE("missing values: ground at exactly 0, seen between what stands on it, is none") {
    Random random(7);
    // Trees, slats of a table, and a wall behind shelves: nearer to the ground than they are wide.
    for (const auto& [low, high, width] :
         {std::tuple(10.0, 18.0, 50.0), {0.88, 0.92, 5.0}, {1.2, 1.5, 4.0}}) {
        for (const double share : {0.03, 0.1, 0.2}) {
            for (int axis = 0; axis < 3; ++axis) {
                Places scene;
                for (int i = 0; i < 3000; ++i) {
                    Vec3 x(random.between(0.0, width), random.between(0.0, width), 0.0);
                    if (random.between(0.0, 1.0) > share) x.z = random.between(low, high);
                    std::swap(x.z, x[axis]);
                    scene.push_back(x);
                }
                CHECK_MESSAGE(sentinelsOf(scene).empty(), share, " ", low, " ", axis);
            }
        }
    }
}

TEST_CASE("missing values: levels, floors, and values of most points are none") {
    const auto countMissing = [](const std::vector<Vec3>& position) {
        const PlacedPoints placed = placedPoints(position);
        return std::count(placed.aside.begin(), placed.aside.end(), Aside::Sentinel);
    };
    Random random(3);
    const auto place = [&](double z) {
        return Vec3(random.between(0.0, 10.0), random.between(0.0, 10.0), z);
    };
    std::vector<Vec3> levels;
    std::vector<Vec3> canopy;
    std::vector<Vec3> mostly;
    for (int i = 0; i < 500; ++i) {
        levels.push_back(place(10.0 * static_cast<double>(random.below(5))));
        canopy.push_back(place(i < 100 ? -2.0 : random.between(0.0, 1.5)));
        mostly.push_back(place(i % 5 < 3 ? -9999.0 : random.between(0.0, 1.0)));
    }
    CHECK(countMissing(levels) == 0);
    CHECK(countMissing(canopy) == 0);  // The floor is a block of the file.
    CHECK(countMissing(mostly) == 0);
    // As wide a gap among the others does not hide a value that is never measured.
    std::vector<Vec3> apart;
    for (int i = 0; i < 90; ++i)
        apart.push_back(place(i % 9 == 0 ? -9999.0 : (i % 2 == 0 ? 4000.0 : 0.0) + 0.01 * i));
    CHECK(countMissing(apart) == 10);
}

TEST_CASE("missing values: at the user's word far values are places like all others") {
    Places heights = raster(30, 500.0);
    for (const Index p : some(heights.size())) heights[p].z = -9999.0;
    heights.push_back(heights[some(900).front()]);
    const PlacedPoints kept = placedPoints(heights, FarValues::Real);
    CHECK(std::count(kept.aside.begin(), kept.aside.end(), Aside::No) == 900);
    CHECK(kept.original.back() == some(900).front());
    CHECK(placedPoints(heights).original.back() == kNone);
}
