/// Strays (docs/robust.md, "Before the run"): points far from all others are found at any distance,
/// alone or in pairs, and no point of a surface is one.
#include "spiraling_edge/prepare/strays.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/spec/run_spec.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// Even points of the unit sphere, along a spiral.
std::vector<Vec3> evenSphere(std::size_t count = 600) {
    const double turn = kPi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3> position;
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<double>(i);
        const double z = 1.0 - (2.0 * k + 1.0) / static_cast<double>(count);
        const double r = std::sqrt(1.0 - z * z);
        position.emplace_back(r * std::cos(k * turn), r * std::sin(k * turn), z);
    }
    return position;
}

/// The strays among points, by their 12 nearest, ascending.
std::vector<Index> straysOf(const std::vector<Vec3>& position, unsigned threads = 0) {
    // Far ones are sentinels as well (sentinels.h); here the search for strays has to find them.
    std::vector<bool> present;
    for (auto p = position.begin(); p != position.end(); ++p)
        present.push_back(isFinite(*p) && std::find(position.begin(), p, *p) == p);
    const NeighborLists nearest = findNeighbors(position, {}, present, reach(12, false)).value();
    const std::vector<bool> stray = strayPoints(position, present, nearest, threads);
    std::vector<Index> found;
    for (Index p = 0; p < stray.size(); ++p) {
        if (stray[p]) found.push_back(p);
    }
    return found;
}

/// The strays of an even sphere with other points put before it.
std::vector<Index> straysBeside(std::vector<Vec3> others) {
    const std::vector<Vec3> sphere = evenSphere();
    others.insert(others.end(), sphere.begin(), sphere.end());
    return straysOf(others);
}

std::vector<Vec3> gridOf(int columns, int rows, double along, double across) {
    std::vector<Vec3> position;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) position.emplace_back(x * along, y * across, 0.0);
    }
    return position;
}

/// An even sphere with normals, and other points put before it, with normals up.
PointFile sphereFileWith(const std::vector<Vec3>& others) {
    PointFile file;
    file.position = evenSphere();
    file.normal = file.position;
    file.position.insert(file.position.begin(), others.begin(), others.end());
    file.normal.insert(file.normal.begin(), others.size(), Vec3(0, 0, 1));
    return file;
}

constexpr const char* kSettingAside[] = {"corrected", "robust"};

}  // namespace

TEST_CASE("strays: a point far over a sphere is one, at any distance") {
    for (const double radius : {1.45, 2.0, 3.0, 5.0, 1e3, 1e7, 1e100, kLargest})
        CHECK_MESSAGE(straysBeside({{0, 0, radius}}) == std::vector<Index>{0}, radius);
    CHECK(straysBeside({{0, 0, 0}}) == std::vector<Index>{0});
    CHECK(straysBeside({}).empty());
}

TEST_CASE("strays: several of them do not hide each other") {
    CHECK(straysBeside({{0, 0, 3}, {0, 0, 3.1}}) == std::vector<Index>{0, 1});
    CHECK(straysBeside({{0, 0, 3}, {0.1, 0, 3}, {0, 0.1, 3}}) == std::vector<Index>{0, 1, 2});
    CHECK(straysBeside({{0, 0, 3}, {0, 0, -3}, {5, 0, 0}}) == std::vector<Index>{0, 1, 2});
    const Vec3 sentinel(1e7, 1e7, 1e7);
    CHECK(straysBeside({sentinel, sentinel, 2.0 * sentinel}) == std::vector<Index>{0, 2});
    CHECK(straysBeside({Vec3(kLargest), Vec3(-kLargest)}) == std::vector<Index>{0, 1});
    Random random(3);
    std::vector<Vec3> ten;
    for (int i = 0; i < 10; ++i) ten.push_back(random.between(5.0, 12.0) * random.direction());
    CHECK(straysBeside(ten).size() == 10);
}

TEST_CASE("strays: four that lie together are a piece of their own") {
    CHECK(straysBeside({{0, 0, 3}, {0.1, 0, 3}, {0, 0.1, 3}, {0, 0, 3.1}}).empty());
}

TEST_CASE("strays: a point that a point of the surface lists is none") {
    CHECK(straysBeside({{0, 0, 1.1}}).empty());
    // At the end of a row that grows sparser, each lists the next.
    std::vector<Vec3> row;
    for (int i = 0; i < 40; ++i) row.emplace_back(std::pow(1.3, i), 0.0, 0.0);
    CHECK(straysOf(row).empty());
}

TEST_CASE("strays: no point of a surface is one, however uneven") {
    for (const Family& family : closedFamilies()) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            CHECK_MESSAGE(straysOf(family.sample(seed).position).empty(), family.name);
    }
    CHECK(straysOf(gridOf(10, 10, 1.0, 1.0)).empty());
    CHECK(straysOf(gridOf(300, 12, 0.1, 1.0)).empty());  // Lines of a scanner.
    CHECK(straysOf(gridOf(300, 1, 1.0, 1.0)).empty());
    std::vector<Vec3> denser;  // Each spacing is 5 % less than the one before.
    for (const Vec3& at : gridOf(60, 20, 1.0, 1.0))
        denser.emplace_back(std::pow(0.95, at.x), at.y, 0);
    CHECK(straysOf(denser).empty());
}

TEST_CASE("strays: points at random on a sphere have none") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        std::vector<Vec3> position(1000);
        for (Vec3& at : position) at = random.direction();
        CHECK_MESSAGE(straysOf(position).empty(), seed);
    }
}

TEST_CASE("strays: few points, or all at one place, are none") {
    const std::vector<Vec3> some{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1e9, 0, 0}};
    for (std::size_t count = 0; count <= some.size(); ++count)
        CHECK(straysOf({some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count)}).empty());
    CHECK(straysOf(std::vector<Vec3>(30, Vec3(1.0))).empty());
    CHECK(straysOf({Vec3(kLargest), Vec3(-kLargest)}).empty());
}

TEST_CASE("strays: points that are left out are none, and hide none") {
    std::vector<Vec3> position = evenSphere();
    position.emplace_back(0, 0, 3);
    position.emplace_back(0, 0, 4);
    position.emplace_back(std::nan(""), 0, 0);
    position.emplace_back(0, 0, 3);
    CHECK(straysOf(position) == std::vector<Index>{600, 601});
    std::vector<bool> present(position.size(), true);
    for (const Index p : {601U, 602U, 603U}) present[p] = false;
    const NeighborLists nearest = findNeighbors(position, {}, present, reach(12, false)).value();
    const std::vector<bool> stray = strayPoints(position, present, nearest);
    CHECK(stray[600]);
    CHECK_FALSE(stray[601]);
    CHECK_FALSE(stray[602]);
}

TEST_CASE("strays: the same ones at any scale and place, and for any number of threads" *
          doctest::test_suite("long")) {
    Random random(7);
    std::vector<Vec3> position = evenSphere(20000);
    for (int i = 0; i < 40; ++i) position.push_back(random.between(1.2, 4.0) * random.direction());
    const std::vector<Index> strays = straysOf(position, 1);
    CHECK(strays.size() > 10);
    for (const unsigned threads : {2U, 5U}) CHECK(straysOf(position, threads) == strays);
    for (const double scale : {0x1p-60, 0x1p80}) {
        std::vector<Vec3> scaled = position;
        for (Vec3& at : scaled) at *= scale;
        CHECK(straysOf(scaled) == strays);
    }
}

// ---- before a run -------------------------------------------------------------------------------

TEST_CASE("strays: corrected and robust set them aside, and mesh the rest as if they were not") {
    const std::vector<std::vector<Vec3>> cases{{{0, 0, 1.45}}, {{0, 0, 2}},
                                               {{0, 0, 3}},    {{0, 0, 5}},
                                               {{900, 0, 0}},  {{0, 0, 3}, {0, 0, 3.1}}};
    for (const char* rules : kSettingAside) {
        for (const std::vector<Vec3>& strays : cases) {
            INFO(rules, ", ", strays.size(), " at ", strays.front().x, ", ", strays.front().z);
            const Prepared prepared = preparedBy(rules, sphereFileWith(strays));
            const PointSet& points = prepared.points;
            REQUIRE(prepared.report.count(Aside::Stray) == strays.size());
            for (Index p = 0; p < points.size(); ++p) {
                CHECK(points.isAside(p) == (p < strays.size()));
                CHECK((points.asideOf(p) == Aside::Stray) == (p < strays.size()));
                CHECK(points.neighbors[p].empty() == (p < strays.size()));
            }
            const State state = reconstruct(points, *paramsByName(rules)).state;
            const std::vector<Triangle>& mesh = state.mesh();
            CHECK(mesh.size() == 2 * 600 - 4);
            CHECK(describeFaults(points, mesh) == "");
        }
    }
}

TEST_CASE("strays: paper and printed keep them, and so do the others if they are told to") {
    const PointFile file = sphereFileWith({{0, 0, 3}});
    for (const char* rules : {"paper", "printed"}) {
        const Prepared prepared = preparedBy(rules, file);
        CHECK(prepared.report.count(Aside::Stray) == 0);
        CHECK_FALSE(prepared.points.isAside(0));
        CHECK_FALSE(prepared.points.neighbors[0].empty());
    }
    for (const char* rules : kSettingAside) {
        const RunSpec spec = withSet({}, rules);
        CHECK(paramsOf(spec).value().setStraysAside);
        CHECK_FALSE(paramsOf(withRule(spec, "strays", 0.0)).value().setStraysAside);
    }
}

TEST_CASE("strays: nothing is derived from them") {
    PointFile with = sphereFileWith({{0, 0, 2}, {0, 0, -4}});
    PointFile without = sphereFileWith({});
    for (const NormalSource normals : {NormalSource::Derived, NormalSource::Oriented}) {
        RunSpec spec;
        spec.normals = normals;
        const Prepared a = preparedBy(withSet(spec, "robust"), with);
        const Prepared b = preparedBy(withSet(spec, "robust"), without);
        REQUIRE(a.report.count(Aside::Stray) == 2);
        CHECK(std::equal(a.points.normal.begin() + 2, a.points.normal.end(),
                         b.points.normal.begin()));
        CHECK(a.report.noise == b.report.noise);
        CHECK(a.report.derived.normalComponents == 1);
        CHECK(a.report.count(Aside::NoNormal) == 0);
        CHECK(preparedBy(spec, with).report.count(Aside::Stray) == 0);
    }
}

TEST_CASE("strays: they are taken out of lists from the file") {
    PointFile file = sphereFileWith({{0, 0, 3}});
    for (Index p = 0; p < file.position.size(); ++p) {
        std::vector<Index> list = {(p + 1) % 601, (p + 2) % 601};
        if (p > 2) list.push_back(0);
        file.neighbors.append(list);
    }
    const Prepared prepared = preparedBy("robust", file);
    REQUIRE(prepared.report.count(Aside::Stray) == 1);
    CHECK_FALSE(prepared.report.neighborsComputed);
    CHECK(prepared.points.neighbors[0].empty());
    for (const Index q : prepared.points.neighbors.ids) CHECK(q != 0);
    CHECK(preparedBy("paper", file).points.neighbors[5].size() == 3);
}

TEST_CASE("strays: of the shared sets few points are strays" * doctest::test_suite("long")) {
    const std::map<std::string, std::size_t> known{{"femur", 1},
                                                   {"mannequin_devil", 21},
                                                   {"seven_parts", 1},
                                                   {"street_lidar", 25},
                                                   {"table1_lobster", 1}};
    const std::filesystem::path folder = sharedFile("points");
    if (folder.empty()) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        const auto file = readPoints(entry.path());
        REQUIRE_MESSAGE(file.ok(), name);
        const auto row = known.find(name);
        CHECK_MESSAGE(
            straysOf(file.value().position).size() == (row == known.end() ? 0 : row->second), name);
    }
    const auto ten = sharedPoints("hazards/stray_points.ply");
    REQUIRE(ten);
    CHECK(straysOf(ten->position).size() == 10);
}
