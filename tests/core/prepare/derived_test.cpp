/// The pieces that prepare() derives: normals, their sides, wall types.
#include <doctest/doctest.h>

#include <cmath>

#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

Prepared prepareOrFail(const PointFile& file) {
    auto result = prepare(file, PrepareOptions{});
    REQUIRE(result.ok());
    return std::move(result.value());
}

}  // namespace

TEST_CASE("prepare: points without normals get derived ones, with a report") {
    for (const Family& family : closedFamilies(6.0)) {
        PointFile file = family.sample(1);
        const std::vector<Vec3> truth = file.normal;
        file.normal.clear();
        const Prepared prepared = prepareOrFail(file);
        CHECK(prepared.report.derived.normals);
        CHECK(prepared.report.derived.orientation);
        CHECK(prepared.report.neighborsComputed);
        CHECK(prepared.report.derived.normalComponents ==
              static_cast<std::size_t>(family.components));
        CHECK(prepared.report.count(Aside::NoNormal) == 0);
        for (std::size_t p = 0; p < truth.size(); ++p) {
            CHECK(glm::dot(prepared.points.normal[p], truth[p]) > 0.7);
        }
        // They are as good as given ones for the algorithm.
        const Run run = runAll(prepared.points, *paramsByName("robust"));
        CHECK(run.mesh.closedManifold());
        CHECK(run.mesh.eulerCharacteristic == family.euler);
    }
}

TEST_CASE("prepare: given normals are turned, or replaced, only on request") {
    PointFile file = closedFamilies(1.0)[1].sample(1);
    const std::vector<Vec3> truth = file.normal;
    for (std::size_t p = 0; p < file.normal.size(); p += 3) file.normal[p] = -file.normal[p];
    const std::size_t wrong = (file.normal.size() + 2) / 3;
    PrepareOptions options;
    const Prepared given = prepare(file, options).value();
    CHECK(given.points.normal[0] == file.normal[0]);
    CHECK_FALSE(given.report.derived.orientation);
    options.normals = NormalSource::Oriented;
    const Prepared oriented = prepare(file, options).value();
    CHECK(oriented.points.normal == truth);
    CHECK(oriented.report.derived.turnedNormals >= wrong);
    CHECK_FALSE(oriented.report.derived.normals);
    options.normals = NormalSource::Derived;
    const Prepared derived = prepare(file, options).value();
    CHECK(derived.report.derived.normals);
    CHECK(derived.points.normal != truth);
    for (std::size_t p = 0; p < truth.size(); ++p) {
        CHECK(glm::dot(derived.points.normal[p], truth[p]) > 0.7);
    }
}

TEST_CASE("prepare: nothing can be derived from points in line, they are set aside and counted") {
    PointFile line;
    for (int i = 0; i < 20; ++i) line.position.push_back({1.0 * i, 0, 0});
    const Prepared prepared = prepareOrFail(line);
    CHECK(prepared.report.count(Aside::NoNormal) == 20);
    CHECK(prepared.points.neighbors.ids.empty());
    for (const std::size_t count : {1U, 2U}) {
        PointFile few;
        few.position.assign(line.position.begin(),
                            line.position.begin() + static_cast<std::ptrdiff_t>(count));
        CHECK(prepareOrFail(few).report.count(Aside::NoNormal) == count);
    }
}

TEST_CASE("prepare: wall types from a box replace those of the file") {
    PointFile sheet = sampleSheet(wavySheet(), 12, 100, 1);
    const std::vector<std::uint8_t> truth = sheet.type;
    sheet.type.clear();
    CHECK(prepareOrFail(sheet).points.type == std::vector<std::uint8_t>(truth.size(), kInterior));
    PrepareOptions options;
    options.walls = WallBox{Vec3(-1, -1, -9), Vec3(1, 1, 9)};
    const Prepared prepared = prepare(sheet, options).value();
    CHECK(prepared.points.type == truth);
    CHECK(prepared.report.derived.types);
    // The box around the points finds the same walls; the faces above and below, which are only
    // touched, are none.
    options.walls = boxAround(sheet.position);
    CHECK(prepare(sheet, options).value().points.type == truth);
}

TEST_CASE("walls: the tolerance is in units of the largest side, outside is interior") {
    const WallBox box{Vec3(0.0), Vec3(10, 10, 1), 0.01};
    const std::vector<Vec3> position{{0.09, 5, 0.5},  {0.11, 5, 0.5}, {-0.09, 5, 0.5},
                                     {-0.11, 5, 0.5}, {0, 10, 0.5},   {0, 0, 0.5}};
    const auto type = wallTypes(position, box);
    CHECK(type[0] == kNegativeX);
    CHECK(type[1] == kInterior);
    CHECK(type[2] == kNegativeX);
    CHECK(type[3] == kInterior);
    // +y and -y hold one point each: touched, no walls.
    CHECK(type[4] == kNegativeX);
    CHECK(wallTypes(std::vector<Vec3>{{std::nan(""), 0, 0}, {0, 0, 0}}, box)[0] == kInterior);
    CHECK(wallTypes({}, box).empty());
    const WallBox flat = boxAround(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    for (const std::uint8_t t : wallTypes(std::vector<Vec3>(5, Vec3(0.5, 0.5, 0)), flat)) {
        CHECK(t == kInterior);
    }
}

TEST_CASE("walls: a point beyond one wall is on none, on whichever side and axis") {
    const WallBox box{Vec3(0.0), Vec3(10.0), 0.01};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double beyond : {-0.2, 10.2}) {
            // On the walls of the other two axes, three points each, so that these count as walls.
            std::vector<Vec3> position;
            for (const double t : {3.0, 5.0, 7.0}) {
                for (int other = 0; other < 3; ++other) {
                    Vec3 x(t);
                    x[other] = 0.0;
                    position.push_back(x);
                }
            }
            Vec3 outside(0.0);
            outside[axis] = beyond;
            position.push_back(outside);
            const auto type = wallTypes(position, box);
            CHECK(type[0] == kNegativeX);
            CHECK(type.back() == kInterior);
        }
    }
}

TEST_CASE("prepare: a reach in spacings is a radius in units of the mean distance to the nearest") {
    PointFile file = closedFamilies(2.0)[1].sample(3);
    PrepareOptions options;
    options.neighbors.reach = KNearest{1};
    const PointSet nearest = prepare(file, options).value().points;
    double sum = 0.0;
    for (Index p = 0; p < nearest.size(); ++p)
        sum += glm::length(nearest.position[nearest.neighbors[p].front()] - nearest.position[p]);
    const double spacing = sum / static_cast<double>(nearest.size());
    for (const double spacings : {1.2, 1.6, 2.5}) {
        options.neighbors.reach = WithinRadius{spacings * spacing};
        const PointSet radius = prepare(file, options).value().points;
        options.neighbors.reach = WithinSpacings{spacings};
        const PointSet reach = prepare(file, options).value().points;
        CHECK(reach.neighbors.offset == radius.neighbors.offset);
        CHECK(reach.neighbors.ids == radius.neighbors.ids);
    }
    // It follows the size of the points.
    for (Vec3& x : file.position) x *= 1024.0;
    options.neighbors.reach = WithinSpacings{1.6};
    const PointSet large = prepare(file, options).value().points;
    for (Vec3& x : file.position) x /= 1024.0;
    CHECK(large.neighbors.ids == prepare(file, options).value().points.neighbors.ids);
    options.neighbors.reach = WithinSpacings{0.0};
    CHECK_FALSE(prepare(file, options).ok());
    // One point has no spacing, and no neighbors.
    options.neighbors.reach = WithinSpacings{1.6};
    PointFile one;
    one.position = {Vec3(0.0)};
    one.normal = {Vec3(0.0, 0.0, 1.0)};
    CHECK(prepare(one, options).value().points.neighbors[0].empty());
}
