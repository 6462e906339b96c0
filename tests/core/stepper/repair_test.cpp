/// Beyond the paper, after the last pivot: reinsert, flip and reseat (docs/robust.md).
#include "spiraling_edge/stepper/repair.h"

#include <doctest/doctest.h>

#include <map>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/faults.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

namespace {

/// All points that are inserted, in order; the state is checked after each.
Points reinsertAll(const PointSet& points, RepairState& m) {
    Points in;
    while (const auto step = reinsertNext(points, m)) {
        in.push_back(step->point);
        CHECK(manifoldFault(m) == "");
    }
    return in;
}
std::size_t flipAll(const PointSet& points, RepairState& m) {
    std::size_t count = 0;
    while (flipNext(points, RobustThresholds{}, m)) {
        ++count;
        CHECK(manifoldFault(m) == "");
    }
    return count;
}

std::size_t flippedIn(const PointSet& points, const Triangles& triangles) {
    return countFaults(findFaults(points, triangles))[static_cast<std::size_t>(FaultKind::Flipped)];
}

std::vector<Vec3> square() { return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}; }
const Triangles kSquare{{0, 1, 2}, {0, 2, 3}};

}  // namespace

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

/// A lattice of 6 x 6 points in the plane, each square cut in two, and one more point over it: the
/// last, at a height and with a normal of its own.
PointSet latticeWith(const Vec3& x, const Vec3& normal) {
    std::vector<Vec3> position;
    for (int i = 0; i < 36; ++i) position.emplace_back(i % 6, i / 6, 0);
    position.push_back(x);
    PointSet points = flatPoints(position);
    points.normal.back() = glm::normalize(normal);
    return points;
}
Triangles latticeTriangles() {
    Triangles triangles;
    for (Index y = 0; y < 5; ++y) {
        for (Index x = 0; x < 5; ++x) {
            const Index a = 6 * y + x;
            triangles.push_back({a, a + 1, a + 7});
            triangles.push_back({a, a + 7, a + 6});
        }
    }
    return triangles;
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
    const Triangles before = latticeTriangles();
    const PointSet points = latticeWith({2.6, 2.3, 1.0}, {0.6, 0.2, 1.0});
    RepairState m = beginRepair(points.size(), before);
    CHECK(reinsertAll(points, m) == Points{36});
    // A point more in a surface makes two triangles more, however many gave their place.
    CHECK(m.triangles.size() == before.size() + 2);
    CHECK(goneFrom(before, m.triangles) > 2);
    for (const Triangle& t : m.triangles) CHECK(shapeFaults(points, t) == 0);
    CHECK(reportMesh(points, m.triangles).boundaryLoops == 1);
    CHECK(reportMesh(points, m.triangles).eulerCharacteristic == 1);
}

TEST_CASE("reinsert: a place does not grow to a point of two fans") {
    const Triangles before = latticeTriangles();
    const PointSet points = latticeWith({2.6, 2.3, 1.0}, {0.6, 0.2, 1.0});
    RepairState free = beginRepair(points.size(), before);
    REQUIRE(reinsertNext(points, free));
    Points around;
    forEachSideOf(free, 36, [&](HalfEdge h) { around.push_back(cornerOf(free, following(h))); });
    CHECK(around.size() > 4);
    for (const Index v : around) {
        CAPTURE(v);
        // A triangle that shares only this point with the lattice.
        PointSet more = points;
        more.position.insert(more.position.end(), {{50, 50, 0}, {51, 50, 0}});
        more.normal.resize(39, Vec3(0, 0, 1));
        more.type.resize(39, kInterior);
        more.neighbors.append({});
        more.neighbors.append({});
        Triangles triangles = before;
        triangles.push_back({v, 37, 38});
        RepairState m = beginRepair(39, triangles);
        REQUIRE(m.pinched[v]);
        reinsertNext(more, m);
        const auto left = asSet(m.triangles);
        for (const Triangle& t : triangles) {
            if (t.a == v || t.b == v || t.c == v) CHECK(left.contains(*asSet({t}).begin()));
        }
    }
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

// ---- flip ---------------------------------------------------------------------------------------

TEST_CASE("flip: the diagonal of a flat quad that makes the least angle larger") {
    // A rhombus with its long diagonal.
    const PointSet points = flatPoints({{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}});
    RepairState m = beginRepair(4, kSquare);
    const auto flip = flipNext(points, RobustThresholds{}, m);
    REQUIRE(flip);
    CHECK(asSet(m.triangles) == asSet({{0, 1, 3}, {1, 2, 3}}));
    CHECK(std::set<Index>{flip->u, flip->v} == std::set<Index>{0, 2});
    CHECK(std::set<Index>{flip->x, flip->y} == std::set<Index>{1, 3});
    CHECK(manifoldFault(m) == "");
    CHECK_FALSE(flipNext(points, RobustThresholds{}, m));
    CHECK(m.flipped == 1);
}

TEST_CASE("flip: not the better diagonal, and none of an exact square") {
    RepairState good = beginRepair(4, kSquare);
    CHECK(flipAll(flatPoints({{-1, 0, 0}, {0, -3, 0}, {1, 0, 0}, {0, 3, 0}}), good) == 0);
    RepairState even = beginRepair(4, kSquare);
    CHECK(flipAll(flatPoints(square()), even) == 0);
}

TEST_CASE("flip: not for angles where the surface bends") {
    // The long diagonal is a ridge of 60 degrees.
    PointSet points = flatPoints({{-3, 0, 0.6}, {0, -1, 0}, {3, 0, 0.6}, {0, 1, 0}});
    RepairState m = beginRepair(4, kSquare);
    CHECK(flipAll(points, m) == 0);
}

TEST_CASE("flip: not the edge of a quad that is not convex") {
    // A dart: its other diagonal lies outside.
    const PointSet points = flatPoints({{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}});
    RepairState m = beginRepair(4, kSquare);
    CHECK(flipAll(points, m) == 0);
}

TEST_CASE("flip: removes a flipped triangle") {
    // 3 lies on the same side of the edge 0 1 as 2.
    const PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 1, 0}});
    const Triangles folded{{0, 1, 2}, {1, 0, 3}};
    REQUIRE(flippedIn(points, folded) == 1);
    RepairState m = beginRepair(4, folded);
    CHECK(flipAll(points, m) == 1);
    CHECK(asSet(m.triangles) == asSet({{0, 3, 2}, {3, 1, 2}}));
    CHECK(findFaults(points, m.triangles).empty());
}

TEST_CASE("flip: never makes an edge that is there already") {
    // A thin tetrahedron: each edge's other diagonal is the opposite edge.
    PointSet points = flatPoints({{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}});
    RepairState m = beginRepair(4, {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {2, 1, 3}});
    REQUIRE(manifoldFault(m) == "");
    CHECK(flipAll(points, m) == 0);
}

TEST_CASE("flip: no edge at a point of two fans") {
    // The rhombus that would be flipped, with a triangle attached at one of its points.
    PointSet points =
        flatPoints({{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}, {1, 5, 0}, {-1, 5, 0}});
    RepairState m = beginRepair(6, {{0, 1, 2}, {0, 2, 3}, {3, 4, 5}});
    CHECK(m.pinched[3]);
    CHECK(flipAll(points, m) == 0);
}

TEST_CASE("flip: with the rule, the least angles of a run are larger than without") {
    const PointSet points = prepared(closedFamilies(1.0)[0].sample(3));
    const auto meanCosine = [&](const Params& params) {
        const Run run = runAll(points, params);
        double sum = 0;
        for (const Triangle& t : run.state.mesh()) sum += leastAngleCosine(points, t);
        return sum / static_cast<double>(run.mesh.triangles);
    };
    Params params = paper();
    const double without = meanCosine(params);
    params.robust.flip = true;
    CHECK(meanCosine(params) < without);
}

TEST_CASE("flip: leaves a flat mesh Delaunay, and no flip is ever taken back") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const PointSet points = prepared(sampleSheet(flatSheet(), 8, 80, seed));
        Params params = paper();
        params.robust.flip = true;
        const Run run = runAll(points, params);
        const RepairState m = beginRepair(points.size(), run.state.mesh());
        std::size_t wrong = 0;
        for (HalfEdge h = 0; h < m.twin.size(); ++h) {
            if (m.twin[h] == kNone) continue;
            // Opposite angles of more than 180 degrees would be against Delaunay.
            const auto angleAt = [&](HalfEdge side) {
                const Vec3& x = points.position[cornerOf(m, preceding(side))];
                const Vec3 u = points.position[cornerOf(m, side)] - x;
                const Vec3 v = points.position[cornerOf(m, following(side))] - x;
                return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
            };
            wrong += angleAt(h) + angleAt(m.twin[h]) > kPi + 1e-6 ? 1 : 0;
        }
        CHECK(wrong == 0);
    }
}

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
    const auto step = mendNextFault(points, rules, m);
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
            repeat([&] { return mendNextFault(points, params.robust, m).has_value(); });
        }
        CHECK_MESSAGE(fault == "", "seed ", seed);
    }
    CHECK(steps > 100);
}
