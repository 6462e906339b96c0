/// Beyond the paper, after the last pivot, at triangles with a fault: reseat and remesh
/// (docs/robust.md).
#include <doctest/doctest.h>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

// ---- reseat -------------------------------------------------------------------------------------

namespace {

/// A pentagon about a point that lies outside of it: some of its triangles are flipped. The
/// pentagon's border is held by a ring of triangles with five points more.
struct Misplaced {
    PointSet points;
    Triangles triangles;
};
Misplaced misplaced() {
    std::vector<Vec3> position;
    for (int i = 0; i < 5; ++i) position.push_back(polar(72.0 * i));
    for (int i = 0; i < 5; ++i) position.push_back(polar(72.0 * i + 36, 2.5));
    position.push_back(polar(36, 1.3));
    Misplaced m{flatPoints(position), {}};
    for (Index i = 0; i < 5; ++i) {
        const Index j = (i + 1) % 5;
        m.triangles.push_back({i, j, 10});
        m.triangles.push_back({j, i, 5 + i});
        m.triangles.push_back({j, 5 + i, 5 + j});
    }
    return m;
}

/// The next point that `reseat` alone takes out; kNone if there is none.
Index takeOutNext(const PointSet& points, RepairState& m) {
    RobustRules rules;
    rules.removeFolded = true;
    const auto step = repairNextFault(points, rules, m);
    return step ? std::get<RemoveFoldedEvidence>(*step).point : kNone;
}

}  // namespace

TEST_CASE("reseat: a point at a flipped triangle is taken out, and the hole closed") {
    const Misplaced input = misplaced();
    REQUIRE(flippedIn(input.points, input.triangles) > 0);
    RepairState m = beginRepair(11, input.triangles);
    REQUIRE(manifoldFault(m) == "");
    const Index point = takeOutNext(input.points, m);
    REQUIRE(point != kNone);
    CHECK(manifoldFault(m) == "");
    CHECK(m.sideOf[point] == kNone);
    CHECK(m.triangles.size() == input.triangles.size() - 2);
    CHECK(m.takenOut == 1);
    while (takeOutNext(input.points, m) != kNone) CHECK(manifoldFault(m) == "");
    CHECK(flippedIn(input.points, m.triangles) == 0);
    // And it is reinserted where it lies.
    m.next = 0;
    CHECK_FALSE(reinsertAll(input.points, m).empty());
    CHECK(flippedIn(input.points, m.triangles) == 0);
}

TEST_CASE("reseat: no point in the last rounds, after which it could not be put back") {
    const Misplaced input = misplaced();
    RepairState m = beginRepair(11, input.triangles);
    m.round = kSettlingRound;
    CHECK(takeOutNext(input.points, m) == kNone);
}

TEST_CASE("reseat: a point of two fans stays") {
    Misplaced input = misplaced();
    std::vector<Vec3> position = input.points.position;
    position.insert(position.end(), {{50, 50, 0}, {51, 50, 0}});
    input.points = flatPoints(position);
    input.triangles.insert(input.triangles.begin(), {10, 11, 12});
    RepairState m = beginRepair(13, input.triangles);
    REQUIRE(m.pinched[10]);
    for (Index x = takeOutNext(input.points, m); x != kNone; x = takeOutNext(input.points, m))
        CHECK(x != 10);
}

TEST_CASE("faulty: a flipped triangle, and one far off its normals in conflict with another") {
    const PointSet points =
        flatPoints({{0, 0, 0}, {2, 0, 0}, {1, 1, 1.2}, {1, 0.4, -1}, {1.2, 0.4, 2}, {0.8, 0.4, 2}});
    RepairState alone = beginRepair(6, {{0, 1, 2}});
    CHECK_FALSE(isFaulty(points, alone, 0));
    RepairState cut = beginRepair(6, {{0, 1, 2}, {3, 4, 5}});
    CHECK(isFaulty(points, cut, 0));
    RepairState flipped = beginRepair(6, {{1, 0, 2}});
    CHECK(isFaulty(points, flipped, 0));
}

TEST_CASE("reseat: leaves a mesh without flipped triangles alone") {
    const PointSet points = prepared(closedFamilies(0.5)[0].sample(1));
    RepairState m = beginRepair(points.size(), runAll(points, paper()).state.triangles);
    CHECK(takeOutNext(points, m) == kNone);
    CHECK(m.takenOut == 0);
}

TEST_CASE("reseat: a point at the border or with three triangles stays") {
    const PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -1, 0}});
    RepairState m = beginRepair(4, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    CHECK(takeOutNext(points, m) == kNone);
}

TEST_CASE("reseat: a point across a side of the flipped triangle may be the one to take out") {
    // A pentagon about point 5, and at one of its sides a triangle that is bent under it. All
    // corners of that one lie on the border.
    std::vector<Vec3> position;
    for (int i = 0; i < 5; ++i) position.push_back(polar(72.0 * i));
    position.emplace_back(0, 0, 0);
    position.push_back(polar(36, 0.4) - Vec3(0, 0, 0.7));
    const PointSet points = flatPoints(position);
    Triangles triangles{{1, 0, 6}};
    for (Index i = 0; i < 5; ++i) triangles.push_back({i, (i + 1) % 5, 5});
    REQUIRE(isFlipped(points, triangles[0]));
    RepairState m = beginRepair(7, triangles);
    CHECK(takeOutNext(points, m) == 5);
    CHECK(m.triangles.size() == 4);
    CHECK(manifoldFault(m) == "");
}

TEST_CASE("reseat: with the rule, fewer flipped triangles are left in a run than without") {
    std::size_t with = 0;
    std::size_t without = 0;
    std::size_t takenOut = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        PointFile file = closedFamilies(0.8)[seed % 4].sample(seed);
        Random random(seed);
        for (Vec3& x : file.position) x += 0.15 * random.inCube();
        const PointSet points = prepared(file);
        Params params = *paramsByName("robust");
        params.robust.noFold = params.robust.delay = params.robust.flip = false;
        const Run on = runAll(points, params);
        with += on.mesh.flippedTriangles;
        takenOut += on.state.repair.takenOut;
        params.robust.removeFolded = false;
        without += runAll(points, params).mesh.flippedTriangles;
    }
    MESSAGE("flipped: ", with, " with, ", without, " without, taken out ", takenOut);
    CHECK(takenOut > 0);
    CHECK(with < without);
}

// ---- remesh -------------------------------------------------------------------------------------

namespace {

/// The next faulty triangle that `remesh` alone replaces.
std::optional<Triangle> remeshNext(const PointSet& points, RepairState& m) {
    RobustRules rules;
    rules.remesh = true;
    const auto step = repairNextFault(points, rules, m);
    if (!step) return std::nullopt;
    return std::get<RemeshEvidence>(*step).faulty;
}

}  // namespace

TEST_CASE("remesh: a flipped triangle that no single flip mends") {
    // An L, as a fan from a corner that does not see all of it.
    const PointSet points =
        flatPoints({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
    const Triangles fan{{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 0}};
    REQUIRE(flippedIn(points, fan) == 1);
    RepairState flips = beginRepair(6, fan);
    while (flipNext(points, RobustThresholds{}, flips)) {
    }
    CHECK(flippedIn(points, flips.triangles) > 0);

    RepairState m = beginRepair(6, fan);
    const auto step = remeshNext(points, m);
    REQUIRE(step);
    CHECK(*step == Triangle{1, 3, 4});
    CHECK(m.triangles.size() == fan.size());
    CHECK(flippedIn(points, m.triangles) == 0);
    CHECK(manifoldFault(m) == "");
    CHECK_FALSE(remeshNext(points, m));
}

TEST_CASE("remesh: replaces more than four triangles where four do not suffice") {
    // A U, as a fan from the end of one arm.
    const PointSet points = flatPoints(
        {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
    const Triangles fan{{2, 3, 4}, {2, 4, 5}, {2, 5, 6}, {2, 6, 7}, {2, 7, 0}, {2, 0, 1}};
    REQUIRE(flippedIn(points, fan) == 2);
    RepairState m = beginRepair(8, fan);
    REQUIRE(remeshNext(points, m));
    CHECK(m.triangles.size() == fan.size());
    CHECK(flippedIn(points, m.triangles) == 0);
    CHECK(manifoldFault(m) == "");
}

TEST_CASE("remesh: leaves a mesh without faults alone") {
    const PointSet points = flatPoints(gridPoints());
    RepairState m = beginRepair(points.size(), gridWithout({gridPoint(3, 3)}));
    CHECK_FALSE(remeshNext(points, m));
    CHECK(m.triangles == gridWithout({gridPoint(3, 3)}));
}
