/// Beyond the paper, after the last pivot: the start, reinsert, and whole runs (docs/robust.md).
#include "spiraling_edge/stepper/repair.h"

#include <doctest/doctest.h>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/faults.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

// ---- the start ----------------------------------------------------------------------------------

TEST_CASE("repair: begins with the triangles as they are, and every side's twin") {
    const RepairState m = beginRepair(5, kSquare);
    CHECK(m.triangles == kSquare);
    CHECK(manifoldFault(m) == "");
    CHECK(m.twin[2] == 3);
    CHECK(m.twin[3] == 2);
    CHECK(m.sideOf[4] == kNone);
    CHECK(m.queue == std::vector<HalfEdge>{2});
    CHECK(std::count(m.pinched.begin(), m.pinched.end(), true) == 0);
}

TEST_CASE("repair: an edge of three triangles has no twins, and its ends are left alone") {
    const RepairState m = beginRepair(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    CHECK(adjacencyFault(m) == "");
    CHECK(m.twin[0] == kNone);
    CHECK(m.twin[3] == kNone);
    CHECK(m.pinched[0]);
    CHECK(m.pinched[1]);
}

TEST_CASE("repair: a point of two fans is left alone") {
    const RepairState m = beginRepair(5, {{0, 1, 2}, {0, 3, 4}});
    CHECK(m.pinched[0]);
    CHECK_FALSE(m.pinched[1]);
}

// ---- reinsert -----------------------------------------------------------------------------------

TEST_CASE("reinsert: a stranded point splits the triangle that it lies over") {
    const PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, 1.5, 0.2}});
    RepairState m = beginRepair(4, {{0, 1, 2}});
    CHECK(reinsertAll(points, m) == Points{3});
    CHECK(asSet(m.triangles) == asSet({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    CHECK(m.reinserted == 1);
}

TEST_CASE("reinsert: a stranded point on an edge splits the edge") {
    auto position = square();
    position.push_back({2.05, 1.95, 0});
    const PointSet points = flatPoints(position);
    RepairState m = beginRepair(5, kSquare);
    CHECK(reinsertAll(points, m) == Points{4});
    CHECK(asSet(m.triangles) == asSet({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
}

TEST_CASE("reinsert: a stranded point beside the border joins it") {
    const PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, -3, 0}});
    RepairState m = beginRepair(4, {{0, 1, 2}});
    CHECK(reinsertAll(points, m) == Points{3});
    CHECK(asSet(m.triangles) == asSet({{0, 1, 2}, {1, 0, 3}}));
}

TEST_CASE("reinsert: of all ways, the one with the best least angle") {
    // Near the middle of 0 1 2 but nearer to its lower edge: splitting the edge is better.
    const PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -3, 0}, {2, 0.2, 0}});
    RepairState m = beginRepair(5, {{0, 1, 2}, {1, 0, 3}});
    reinsertAll(points, m);
    CHECK(m.triangles.size() == 4);
}

TEST_CASE("reinsert: of two sides at the border, the one with the better angles") {
    // Both sides of the corner 2 are seen from 4, one of them at a flat angle.
    for (const Vec3& x : {Vec3(8, 5, 0), Vec3(5, 8, 0)}) {
        auto position = square();
        position.push_back(x);
        const PointSet points = flatPoints(position);
        RepairState m = beginRepair(5, kSquare);
        CHECK(reinsertAll(points, m) == Points{4});
        REQUIRE(m.triangles.size() == 3);
        const Triangle expected = x.x > x.y ? Triangle{2, 1, 4} : Triangle{3, 2, 4};
        CHECK(asSet(m.triangles).contains(*asSet({expected}).begin()));
    }
}

TEST_CASE("reinsert: no place at a point of two fans") {
    const std::vector<Vec3> position{{0, 0, 0},  {4, 0, 0},   {2, 4, 0},
                                     {-4, 0, 0}, {-2, -4, 0}, {2, 1.5, 0.2}};
    const PointSet points = flatPoints(position);
    RepairState m = beginRepair(6, {{0, 1, 2}, {0, 3, 4}});
    REQUIRE(m.pinched[0]);
    CHECK_FALSE(reinsertNext(points, m));
}

TEST_CASE("reinsert: no point that would make a fault, none without a list, none that is used") {
    const auto in = [](const Vec3& x, const Vec3& normal) {
        PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, x});
        points.normal[3] = normal;
        RepairState m = beginRepair(4, {{0, 1, 2}});
        return reinsertAll(points, m).size();
    };
    const Vec3 up(0, 0, 1);
    CHECK(in({2, 1.5, 0.2}, up) == 1);
    CHECK(in({2, 1.5, 0.2}, {0, 0, -1}) == 0);
    CHECK(in({2, 0, 0}, up) == 1);      // On the border, which it divides.
    CHECK(in({2, 1.5, 900}, up) == 0);  // A needle.
    PointSet bare = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, 1.5, 0.2}});
    bare.neighbors = {};
    for (int p = 0; p < 4; ++p) bare.neighbors.append({});
    RepairState m = beginRepair(4, {{0, 1, 2}});
    CHECK(reinsertAll(bare, m).empty());
    RepairState used = beginRepair(4, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    CHECK(reinsertAll(flatPoints(bare.position), used).empty());
}

TEST_CASE("reinsert: after the first round a triangle may be against the normal of one corner") {
    PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, 1.5, 0.2}});
    points.normal[3] = glm::normalize(Vec3(1, 0, -0.2));
    for (std::uint32_t round = 0; round < kRepairRounds; ++round) {
        RepairState m = beginRepair(4, {{0, 1, 2}});
        m.round = round;
        CHECK(reinsertAll(points, m).empty() == (round == 0));
    }
}

TEST_CASE("reinsert: no triangle that meets another one nearby") {
    // A second sheet, upright, cuts the first just beside the place.
    PointSet points = flatPoints(
        {{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, 1.5, 1}, {2.2, -9, 0.3}, {2.2, 9, 0.3}, {2.2, 0, 9}});
    RepairState free = beginRepair(7, {{0, 1, 2}});
    const auto step = reinsertNext(points, free);
    REQUIRE(step);
    CHECK(step->point == 3);
    RepairState cut = beginRepair(7, {{0, 1, 2}, {4, 5, 6}});
    CHECK_FALSE(reinsertNext(points, cut));
}

namespace {

/// A grid, and one more point over it: the last, with a normal of its own.
PointSet gridWith(const Vec3& x, const Vec3& normal) {
    std::vector<Vec3> position = gridPoints();
    position.push_back(x);
    PointSet points = flatPoints(position);
    points.normal.back() = glm::normalize(normal);
    return points;
}

/// The old triangles that a new mesh does not have.
std::size_t goneFrom(const Triangles& before, const Triangles& after) {
    const auto left = asSet(after);
    std::size_t gone = 0;
    for (const auto& t : asSet(before)) gone += left.contains(t) ? 0U : 1U;
    return gone;
}

}  // namespace

TEST_CASE("reinsert: where one triangle has no room, the point takes the place of several") {
    // As high as a square is wide, with a normal that leans: the sides of a small place would be
    // too steep for it.
    const Triangles before = gridWithout({});
    const PointSet points = gridWith({2.6, 2.3, 1.0}, {0.6, 0.2, 1.0});
    RepairState m = beginRepair(points.size(), before);
    CHECK(reinsertAll(points, m) == Points{49});
    // A point more in a surface makes two triangles more, however many gave their place.
    CHECK(m.triangles.size() == before.size() + 2);
    CHECK(goneFrom(before, m.triangles) > 2);
    for (const Triangle& t : m.triangles) CHECK(shapeFaults(points, t) == 0);
    CHECK(reportMesh(points, m.triangles).boundaryLoops == 1);
    CHECK(reportMesh(points, m.triangles).eulerCharacteristic == 1);
}

TEST_CASE("reinsert: a point beyond three local spacings of the mesh stays out") {
    // The sixth neighbor is 1.4 away within the grid, 2 at its border.
    const auto reaches = [](const Vec3& x) {
        const PointSet points = gridWith(x, {0, 0, 1});
        bool everyRound = true;
        bool anyRound = false;
        for (std::uint32_t round = 0; round < kRepairRounds; ++round) {
            RepairState m = beginRepair(points.size(), gridWithout({}));
            m.round = round;
            const bool in = !reinsertAll(points, m).empty();
            everyRound = everyRound && in;
            anyRound = anyRound || in;
        }
        CHECK(everyRound == anyRound);
        return anyRound;
    };
    CHECK(reaches({3.4, 3.2, 0.1}));
    CHECK(reaches({3.5, -2.0, 0.0}));
    CHECK(reaches({3.5, -5.5, 0.0}));
    CHECK_FALSE(reaches({3.5, -6.5, 0.0}));
    CHECK_FALSE(reaches({3.5, -60.0, 0.0}));
}

TEST_CASE("reinsert: a place does not grow to a point of two fans") {
    const Triangles before = gridWithout({});
    const PointSet points = gridWith({2.6, 2.3, 1.0}, {0.6, 0.2, 1.0});
    RepairState free = beginRepair(points.size(), before);
    REQUIRE(reinsertNext(points, free));
    Points around;
    forEachSideOf(free, 49, [&](HalfEdge h) { around.push_back(cornerOf(free, following(h))); });
    CHECK(around.size() > 4);
    for (const Index v : around) {
        CAPTURE(v);
        // A triangle that shares only this point with the grid.
        PointSet more = points;
        more.position.insert(more.position.end(), {{50, 50, 0}, {51, 50, 0}});
        more.normal.resize(52, Vec3(0, 0, 1));
        more.type.resize(52, kInterior);
        more.neighbors.append({});
        more.neighbors.append({});
        Triangles triangles = before;
        triangles.push_back({v, 50, 51});
        RepairState m = beginRepair(52, triangles);
        REQUIRE(m.pinched[v]);
        reinsertNext(more, m);
        const auto left = asSet(m.triangles);
        for (const Triangle& t : triangles) {
            if (t.a == v || t.b == v || t.c == v) CHECK(left.contains(*asSet({t}).begin()));
        }
    }
}

TEST_CASE("reinsert: a place does not grow around a point of three triangles") {
    // A tent without a floor: the place of two of its sides has all points of the third one.
    PointSet points = flatPoints({{0, 0, 2}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, -0.5, 1}});
    for (Index p = 0; p < 4; ++p)
        points.normal[p] = glm::normalize(points.position[p] - Vec3(0, 0, 0.5));
    RepairState m = beginRepair(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
    REQUIRE(reinsertNext(points, m));
    CHECK(manifoldFault(m) == "");
    CHECK(m.triangles.size() == 5);
}

TEST_CASE("reinsert: with the rule, points that a run stranded are used, without, they are not") {
    std::size_t with = 0;
    std::size_t without = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        PointFile file = closedFamilies(0.8)[0].sample(seed);
        Random random(seed);
        for (Vec3& x : file.position) x += 0.03 * random.inCube();
        const PointSet points = prepared(file, reach(16));
        Params params = paper();
        params.robust.guard = params.robust.noPillow = true;
        without += runAll(points, params).mesh.unusedPoints;
        params.robust.reinsert = true;
        with += runAll(points, params).mesh.unusedPoints;
    }
    MESSAGE("unused: ", with, " with, ", without, " without");
    CHECK(without > 0);
    CHECK(with < without);
}

namespace {

/// A grid with a point over it, number 49, and upright triangles beside that point: whatever
/// triangles the point makes with the grid, each of these cuts one.
struct Pierced {
    PointSet points;
    Triangles triangles;
};
Pierced pierced(std::initializer_list<Vec3> places, double height = 0.1) {
    std::vector<Vec3> position = gridPoints();
    Triangles triangles = gridWithout({});
    position.emplace_back(2.6, 2.3, 0.3);
    for (const Vec3& place : places) {
        const auto first = static_cast<Index>(position.size());
        triangles.push_back({first, first + 1, first + 2});
        for (const Vec3& corner :
             {Vec3(-0.01, 0, -height), Vec3(0.01, 0, -height), Vec3(0, 0, height)})
            position.push_back(place + corner);
    }
    PointSet points = flatPoints(position);
    const NeighborLists all = points.neighbors;
    points.neighbors = {};
    for (Index p = 0; p < points.size(); ++p) {
        Points list(all[p].begin(), all[p].end());
        if (p == 49) std::erase_if(list, [](Index q) { return q > 49; });
        points.neighbors.append(list);
    }
    return {points, triangles};
}

}  // namespace

TEST_CASE("reinsert: in the last rounds at the price of one fault, not of two") {
    const auto in = [](std::initializer_list<Vec3> places, std::uint32_t round) {
        const auto [points, triangles] = pierced(places, 0.27);
        RepairState m = beginRepair(points.size(), triangles);
        m.round = round;
        const bool found = !reinsertAll(points, m).empty();
        CHECK(manifoldFault(m) == "");
        CHECK(findFaults(points, m.triangles).size() == (found ? places.size() : 0));
        return found;
    };
    const Vec3 right(2.65, 2.3, 0.28);
    const Vec3 left(2.55, 2.3, 0.28);
    CHECK_FALSE(in({right}, kSettlingRound - 1));
    CHECK(in({right}, kSettlingRound));
    CHECK(in({right}, kRepairRounds - 1));
    CHECK_FALSE(in({right, left}, kSettlingRound));
}

TEST_CASE("reinsert: in the last rounds a place may have as many faults as it had before") {
    // Each of the two is so high that it cuts a triangle of the grid, too.
    const auto [points, triangles] = pierced({{2.65, 2.3, 0.2}, {2.55, 2.3, 0.2}}, 0.25);
    RepairState m = beginRepair(points.size(), triangles);
    const std::size_t before = findFaults(points, triangles).size();
    REQUIRE(before == 2);
    m.round = kSettlingRound;
    CHECK(reinsertAll(points, m) == Points{49});
    CHECK(findFaults(points, m.triangles).size() <= before + 1);
}

TEST_CASE("reinsert: in the last rounds no triangle is flipped") {
    PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}, {2, 1.5, 0.2}});
    points.normal[3] = Vec3(0, 0, -3);
    RepairState m = beginRepair(4, {{0, 1, 2}});
    m.round = kSettlingRound;
    // Inside, all three triangles would be flipped; beside a side one is folded, and not flipped.
    reinsertAll(points, m);
    for (const Fault& fault : findFaults(points, m.triangles))
        CHECK(fault.kind != FaultKind::Flipped);
}

// ---- all together -------------------------------------------------------------------------------

namespace {

/// The first fault of the neighbor relation after any repair step in a run; empty if there is none.
/// Counts the steps.
std::string faultWhileRepairing(const PointSet& points, std::size_t& steps) {
    Stepper stepper(points, *paramsByName("robust"));
    std::string fault;
    while (fault.empty() && stepper.stepPivot()) {
        if (stepper.state().repair.empty()) continue;
        fault = manifoldFault(stepper.state().repair);
        ++steps;
    }
    return fault;
}

}  // namespace

TEST_CASE("repair: the phases are repeated, also where the first round finds nothing") {
    const PointSet points = prepared(closedFamilies(0.3)[0].sample(1));
    CHECK(runAll(points, robust()).state.repair.round == kRepairRounds);
}

TEST_CASE("repair: neighbors agree after every step, on meshes of random points") {
    std::size_t steps = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        CHECK_MESSAGE(faultWhileRepairing(randomPoints(seed), steps) == "", "seed ", seed);
    }
    CHECK(steps > 100);
}

TEST_CASE("repair: neighbors agree after every step, on rough closed clouds") {
    std::size_t steps = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        PointFile file = closedFamilies(0.5)[seed % 4].sample(seed);
        Random random(seed);
        for (Vec3& x : file.position) x += 0.08 * random.inCube();
        CHECK_MESSAGE(faultWhileRepairing(prepared(file), steps) == "", "seed ", seed);
    }
    CHECK(steps > 100);
}

TEST_CASE("repair: neighbors agree after every step, on triangles that are no surface at all") {
    std::size_t steps = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const PointSet points = randomPoints(seed);
        Random random(seed);
        Triangles soup;
        // Fans of lists: some edges of two triangles, some of more.
        for (Index p = 0; p < points.size(); ++p) {
            const auto list = points.neighbors[p];
            for (std::size_t i = 0; i + 1 < list.size() && i < 3; ++i) {
                if (random.below(8) == 0) soup.push_back({p, list[i], list[i + 1]});
            }
        }
        if (soup.empty()) continue;
        RepairState m = beginRepair(points.size(), soup);
        std::string fault = adjacencyFault(m);
        const Params params = *paramsByName("robust");
        const auto repeat = [&](const auto& step) {
            m.next = 0;
            while (fault.empty() && step()) {
                fault = adjacencyFault(m);
                ++steps;
            }
        };
        for (; m.round < kRepairRounds && fault.empty(); ++m.round) {
            repeat([&] { return dropNextPatch(points, m).has_value(); });
            repeat([&] { return reinsertNext(points, m).has_value(); });
            repeat([&] { return closeNextHole(points, params, m).has_value(); });
            repeat([&] { return flipNext(points, RobustThresholds{}, m).has_value(); });
            repeat([&] { return remeshNext(points, m).has_value(); });
        }
        CHECK_MESSAGE(fault == "", "seed ", seed);
    }
    CHECK(steps > 100);
}
