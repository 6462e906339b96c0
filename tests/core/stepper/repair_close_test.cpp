/// Beyond the paper, after the last pivot: closeholes and droppatches (docs/robust.md).
#include <doctest/doctest.h>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/repair.h"
#include "spiraling_edge/stepper/robust/hole_filling.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/random_points.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

namespace {

/// The lengths of the rings of the holes that are filled, in order; the state is checked after
/// each.
Points closeAll(const PointSet& points, const Params& params, RepairState& m) {
    Points lengths;
    m.next = 0;
    while (const auto step = closeNextHole(points, params, m)) {
        lengths.push_back(step->length);
        CHECK(manifoldFault(m) == "");
    }
    return lengths;
}

std::size_t borderSides(const RepairState& m) {
    return static_cast<std::size_t>(std::count(m.twin.begin(), m.twin.end(), kNone));
}

constexpr std::size_t kOutline = 4 * (kAcross - 1);

}  // namespace

// ---- closeholes ---------------------------------------------------------------------------------

TEST_CASE("closeholes: a hole of six is filled by four triangles, and the outline stays open") {
    const PointSet points = flatPoints(gridPoints());
    const Triangles before = gridWithout({gridPoint(3, 3)});
    RepairState m = beginRepair(points.size(), before);
    CHECK(closeAll(points, robust(), m) == Points{6});
    CHECK(m.triangles.size() == before.size() + 4);
    CHECK(borderSides(m) == kOutline);
}

TEST_CASE("closeholes: each of several holes") {
    const PointSet points = flatPoints(gridPoints());
    RepairState m = beginRepair(points.size(), gridWithout({gridPoint(2, 4), gridPoint(4, 2)}));
    CHECK(closeAll(points, robust(), m) == Points{6, 6});
    CHECK(borderSides(m) == kOutline);
}

TEST_CASE("closeholes: holes that touch at a point are filled, and the point has one fan again") {
    const PointSet points = flatPoints(gridPoints());
    // Both rings hold the point between them.
    RepairState m = beginRepair(points.size(), gridWithout({gridPoint(2, 3), gridPoint(4, 3)}));
    REQUIRE(m.pinched[gridPoint(3, 3)]);
    CHECK(closeAll(points, robust(), m) == Points{6, 6});
    CHECK(borderSides(m) == kOutline);
    CHECK_FALSE(m.pinched[gridPoint(3, 3)]);
}

TEST_CASE("closeholes: a hole with a triangle through it stays open") {
    auto position = gridPoints();
    const auto first = static_cast<Index>(position.size());
    position.insert(position.end(), {{2.9, 2.9, -0.5}, {3.1, 2.9, 0.5}, {3.0, 3.2, 0.5}});
    const PointSet points = flatPoints(position);
    Triangles triangles = gridWithout({gridPoint(3, 3)});
    triangles.push_back({first, first + 1, first + 2});
    RepairState m = beginRepair(points.size(), triangles);
    CHECK(closeAll(points, robust(), m).empty());
    CHECK(m.triangles == triangles);
}

TEST_CASE("closeholes: rings longer than filllength, and holes wider than fillwidth, stay open") {
    const PointSet points = flatPoints(gridPoints());
    RepairState m = beginRepair(points.size(), gridWithout({gridPoint(3, 3)}));
    Params shorter = robust();
    shorter.maxFillLength = 5;
    CHECK(closeAll(points, shorter, m).empty());
    Params narrower = robust();
    narrower.maxFillWidth = 1.0;
    CHECK(closeAll(points, narrower, m).empty());
}

TEST_CASE("closeholes: a wide hole where the surface ends at most points stays open") {
    // Three by three points less: at 12 of the 16 around, half of the directions are free.
    Points gone;
    for (Index row = 2; row <= 4; ++row) {
        for (Index column = 2; column <= 4; ++column) gone.push_back(gridPoint(column, row));
    }
    const PointSet points = flatPoints(gridPoints());
    RepairState m = beginRepair(points.size(), gridWithout(gone));
    CHECK(closeAll(points, robust(), m).empty());
    // The user may want it closed: 14 edges, 4.05 across.
    for (const double width : {4.0, 4.1}) {
        Params limited = robust();
        limited.maxHoleWidth = width;
        RepairState mesh = beginRepair(points.size(), gridWithout(gone));
        CHECK(closeAll(points, limited, mesh) == (width < 4.05 ? Points{} : Points{14}));
    }
}

TEST_CASE("closeholes: of holes of 6 and 8 edges, those within the limits of the user are filled") {
    const PointSet points = flatPoints(gridPoints());
    const Triangles six = gridWithout({gridPoint(3, 3)});
    const Triangles eight = gridWithout({gridPoint(3, 3), gridPoint(4, 3)});
    const auto closed = [&](const Triangles& mesh, double width, std::uint32_t edges) {
        Params limited = robust();
        limited.maxHoleWidth = width;
        limited.maxHoleEdges = edges;
        RepairState m = beginRepair(points.size(), mesh);
        return closeAll(points, limited, m);
    };
    CHECK(closed(six, 0.0, 6) == Points{6});
    CHECK(closed(eight, 0.0, 6).empty());
    CHECK(closed(eight, 0.0, 8) == Points{8});
    // 1.76 and 2.08 across.
    CHECK(closed(six, 1.9, 0) == Points{6});
    CHECK(closed(eight, 1.9, 0).empty());
    CHECK(closed(six, 1.9, 5).empty());
}

TEST_CASE("closeholes: the limits of the user close no loop along walls, and no outline") {
    // A strip of two rows whose outline lies on the walls but for one point of the inner hole.
    PointSet points = flatPoints(gridPoints());
    Params limited = robust();
    limited.maxHoleWidth = 100.0;
    RepairState outline = beginRepair(points.size(), gridWithout({}));
    CHECK(closeAll(points, limited, outline).empty());
    for (const auto& [column, row] :
         {std::pair<Index, Index>{2, 2}, {3, 2}, {4, 2}, {4, 3}, {4, 4}, {3, 4}, {2, 4}, {2, 3}})
        points.type[gridPoint(column, row)] = kNegativeX;
    RepairState walls = beginRepair(points.size(), gridWithout({gridPoint(3, 3)}));
    CHECK(closeAll(points, limited, walls).empty());
}

TEST_CASE("closeholes: an edge of two triangles that has no twins gets no third") {
    // On the same side of the hole's edge as the triangle of the grid; the tip over the hole, or
    // beside it, where the border sides of the hole still follow each other.
    for (const double y : {2.5, 1.5}) {
        auto position = gridPoints();
        const auto tip = static_cast<Index>(position.size());
        position.emplace_back(2.5, y, 1.0);
        const PointSet points = flatPoints(position);
        Triangles triangles = gridWithout({gridPoint(3, 3)});
        triangles.push_back({gridPoint(3, 2), gridPoint(2, 2), tip});
        RepairState m = beginRepair(points.size(), triangles);
        CHECK_FALSE(closeNextHole(points, robust(), m));
        CHECK(m.triangles == triangles);
    }
}

TEST_CASE("closeholes: a hole with no room for a triangle is widened by one across its side") {
    // The points 0 1 2 lie almost on a line. The triangle over it goes, and its tip is joined to
    // the point in the middle.
    const PointSet points =
        flatPoints({{0, 0, 0}, {2, -0.01, 0}, {4, 0, 0}, {2, 3, 0}, {1, -2, 0}, {3, -2, 0}});
    RepairState m = beginRepair(6, {{2, 1, 5}, {1, 0, 4}, {1, 4, 5}, {0, 2, 3}});
    CHECK(closeAll(points, robust(), m) == Points{3});
    CHECK(asSet(m.triangles) == asSet({{2, 1, 5}, {1, 0, 4}, {1, 4, 5}, {0, 1, 3}, {1, 2, 3}}));
    CHECK(m.takenOut == 0);
}

TEST_CASE("closeholes: a point that leaves no room for a triangle is taken out") {
    // A triangle is missing; where it had a neighbor, a flipped triangle leads to a point over the
    // grid, so that the hole has a fourth point, at which every triangle lies over the grid.
    auto position = gridPoints();
    const auto point = static_cast<Index>(position.size());
    position.emplace_back(3.5, 2.3, 0.3);
    const PointSet points = flatPoints(position);
    const Triangle missing{gridPoint(3, 3), gridPoint(4, 3), gridPoint(4, 4)};
    Triangles triangles = gridWithout({});
    std::erase(triangles, missing);
    triangles.push_back({missing.a, missing.b, point});
    RepairState m = beginRepair(points.size(), triangles);
    CHECK(closeAll(points, robust(), m) == Points{4});
    CHECK(asSet(m.triangles) == asSet(gridWithout({})));
    CHECK(m.sideOf[point] == kNone);
    CHECK(m.takenOut == 1);
}

// ---- the filling of a ring ----------------------------------------------------------------------

TEST_CASE("filling: of a rhombus, with the diagonal that makes the least angle larger") {
    const PointSet points = flatPoints({{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}});
    RepairState m = beginRepair(4, {});
    const HoleRing ring{{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, {}};
    Filling filling = FillingSearch(points, m, ring).find();
    std::sort(filling.begin(), filling.end());
    CHECK(filling == Filling{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("filling: with no edge that a triangle has already") {
    // An upright triangle on one diagonal, which cuts every filling with the other.
    std::vector<Vec3> position = square();
    position.emplace_back(2, 2, 5);
    const PointSet points = flatPoints(position);
    const HoleRing ring{{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, {}};
    RepairState free = beginRepair(5, {});
    CHECK(FillingSearch(points, free, ring).find().size() == 2);
    RepairState taken = beginRepair(5, {{0, 2, 4}});
    CHECK(FillingSearch(points, taken, ring).find().empty());
}

TEST_CASE("filling: with no triangle folded onto the one across a side") {
    // A wedge whose lower triangle is there, under the upper one.
    const auto size = [](double height) {
        PointSet points = flatPoints({{0, 0, 0}, {4, 0, 0}, {2, 4, height}, {2, 4, -height}});
        points.normal = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        RepairState m = beginRepair(4, {{1, 0, 3}});
        const HoleRing ring{{0, 1, 2}, {0, kNone, kNone}, {}};
        return FillingSearch(points, m, ring).find().size();
    };
    CHECK(size(1.0) == 1);
    CHECK(size(0.2) == 0);
}

TEST_CASE("filling: with no two triangles of which one lies over the other") {
    // A winding ramp. After a full turn it lies over its beginning.
    const auto size = [](Index quarters) {
        std::vector<Vec3> position;
        const auto add = [&](Index i, double radius) {
            position.push_back(polar(90.0 * i, radius) + Vec3(0, 0, 0.1 * i));
        };
        for (Index i = 0; i <= quarters; ++i) add(i, 2.0);
        for (Index i = quarters + 1; i-- > 0;) add(i, 0.5);
        const PointSet points = flatPoints(position);
        HoleRing ring;
        for (Index p = 0; p < points.size(); ++p) ring.points.push_back(p);
        ring.outer.assign(ring.size(), kNone);
        RepairState m = beginRepair(points.size(), {});
        return FillingSearch(points, m, ring).find().size();
    };
    CHECK(size(3) == 6);
    CHECK(size(5) == 0);
}

TEST_CASE("filling: around a point inside, which all triangles have where it sees the whole ring") {
    std::vector<Vec3> position = square();
    position.emplace_back(2, 2, 0);
    const PointSet points = flatPoints(position);
    RepairState m = beginRepair(5, {});
    HoleRing ring{{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, {}, 4};
    const Filling filling = FillingSearch(points, m, ring).find();
    CHECK(filling.size() == 4);
    putFilling(m, ring, filling);
    CHECK(asSet(m.triangles) == asSet({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
    CHECK(reachedSides(m, 4) == 4);
}

TEST_CASE("filling: around a point inside, with others where it does not see the ring") {
    // Behind the notch at 3 the point at 6 does not see 4.
    const PointSet points =
        flatPoints({{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {2, 2, 0}, {1, 6, 0}, {0, 6, 0}, {4, 1, 0}});
    RepairState m = beginRepair(7, {});
    const HoleRing ring{{0, 1, 2, 3, 4, 5}, std::vector<HalfEdge>(6, kNone), {}, 6};
    const Filling filling = FillingSearch(points, m, ring).find();
    CHECK(filling.size() == 6);
    putFilling(m, ring, filling);
    CHECK_FALSE(joined(m, 6, 4));
    CHECK(reachedSides(m, 6) >= 3);
    double area = 0.0;
    for (const Triangle& t : m.triangles) area += 0.5 * areaVector(points, t).z;
    CHECK(area == doctest::Approx(22.0));
}

TEST_CASE("filling: a ring is widened by the triangle across a side, but not to a pinched point") {
    for (const bool pinched : {false, true}) {
        Triangles triangles{{0, 1, 2}};
        if (pinched) triangles.push_back({2, 3, 4});
        const RepairState m = beginRepair(6, triangles);
        HoleRing ring{{1, 0, 5}, {0, kNone, kNone}, {}};
        CHECK(widenByTriangle(m, 0, ring) == !pinched);
        CHECK(ring.points == (pinched ? Points{1, 0, 5} : Points{1, 2, 0, 5}));
        CHECK(ring.gone == (pinched ? Points{} : Points{0}));
    }
}

// ---- droppatches --------------------------------------------------------------------------------

namespace {

/// A grid, and a tetrahedron over its middle.
struct Patched {
    PointSet points;
    Triangles triangles;
};
Patched patched(double height) {
    auto position = gridPoints();
    const auto p = static_cast<Index>(position.size());
    for (const Vec3& x : {Vec3{3, 3, 0}, Vec3{4, 3, 0}, Vec3{3, 4, 0}, Vec3{3.3, 3.3, 0.6}})
        position.push_back(x + Vec3(0, 0, height));
    Patched input{flatPoints(position), gridWithout({})};
    for (const Triangle& t : {Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
        input.triangles.push_back({p + t.a, p + t.b, p + t.c});
    return input;
}

}  // namespace

TEST_CASE("droppatches: a tetrahedron over a finished surface is taken out") {
    const Patched input = patched(0.3);
    RepairState m = beginRepair(input.points.size(), input.triangles);
    const auto step = dropNextPatch(input.points, m);
    REQUIRE(step);
    CHECK(step->triangles == 4);
    CHECK(step->point == kAcross * kAcross);
    CHECK(asSet(m.triangles) == asSet(gridWithout({})));
    CHECK(manifoldFault(m) == "");
    CHECK(m.sideOf[step->point] == kNone);
    CHECK_FALSE(dropNextPatch(input.points, m));
}

TEST_CASE("droppatches: a small component alone stays") {
    const PointSet points = flatPoints({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.6}});
    RepairState m = beginRepair(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    CHECK_FALSE(dropNextPatch(points, m));
    CHECK(m.triangles.size() == 4);
}

TEST_CASE("droppatches: of equal fans at a point the first stays") {
    const PointSet points = flatPoints(gridPoints());
    const Index pinch = gridPoint(3, 3);
    const Triangles before = gridWithout({gridPoint(2, 3), gridPoint(4, 3)});
    RepairState m = beginRepair(points.size(), before);
    REQUIRE(m.pinched[pinch]);
    const auto step = dropNextFans(m);
    REQUIRE(step);
    CHECK(step->point == pinch);
    CHECK(step->triangles == 1);
    CHECK(step->kept == 1);
    auto left = asSet(before);
    left.erase({pinch, gridPoint(4, 4), gridPoint(3, 4)});
    CHECK(asSet(m.triangles) == left);
    CHECK(manifoldFault(m) == "");
    CHECK_FALSE(m.pinched[pinch]);
    CHECK_FALSE(dropNextFans(m));
}

TEST_CASE("droppatches: the larger of two fans stays") {
    RepairState m = beginRepair(7, {{0, 1, 2}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}});
    const auto step = dropNextFans(m);
    REQUIRE(step);
    CHECK(step->kept == 3);
    CHECK(asSet(m.triangles) == asSet({{0, 3, 4}, {0, 4, 5}, {0, 5, 6}}));
    CHECK(m.sideOf[1] == kNone);
    CHECK(manifoldFault(m) == "");
}

TEST_CASE("droppatches: without the third triangle of an edge, the two others are neighbors") {
    // A tetrahedron, and a triangle on one of its edges.
    RepairState m = beginRepair(5, {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}, {0, 1, 4}});
    REQUIRE(m.pinched[0]);
    REQUIRE(dropNextFans(m));
    CHECK(asSet(m.triangles) == asSet({{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}}));
    CHECK(manifoldFault(m) == "");
    CHECK(borderSides(m) == 0);
}

TEST_CASE("droppatches: a point that loses its only triangle is stranded") {
    RepairState m = beginRepair(8, {{0, 1, 2}, {2, 3, 4}, {4, 5, 6}, {5, 4, 7}});
    const auto step = dropNextFans(m);
    REQUIRE(step);
    CHECK(step->point == 2);
    // Without 2 3 4, point 4 has one fan.
    CHECK_FALSE(dropNextFans(m));
    CHECK(asSet(m.triangles) == asSet({{0, 1, 2}, {4, 5, 6}, {5, 4, 7}}));
    CHECK(m.sideOf[3] == kNone);
    CHECK(manifoldFault(m) == "");
}

TEST_CASE("droppatches: a point whose fan is divided by the step before loses one part") {
    // Four triangles about 1, the middle two at 4, where another fan has three.
    RepairState m = beginRepair(
        11, {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {4, 7, 8}, {4, 8, 9}, {4, 9, 10}});
    const auto first = dropNextFans(m);
    REQUIRE(first);
    CHECK(first->point == 4);
    CHECK(first->triangles == 2);
    CHECK(first->kept == 3);
    CHECK(m.pinched[1]);
    CHECK(adjacencyFault(m) == "");
    const auto second = dropNextFans(m);
    REQUIRE(second);
    CHECK(second->point == 1);
    CHECK(second->triangles == 1);
    CHECK(m.triangles.size() == 4);
    CHECK(reachedSides(m, 4) == 3);
    CHECK(manifoldFault(m) == "");
    CHECK_FALSE(dropNextFans(m));
}

TEST_CASE("droppatches: no point of a finished run has two fans") {
    std::size_t without = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        const PointSet points = randomPoints(seed);
        without += runAll(points, paper()).mesh.nonManifoldVertices;
        const Run run = runAll(points, paperBut(&RobustRules::dropPatches));
        CHECK(run.mesh.nonManifoldVertices == 0);
    }
    CHECK(without > 0);
}

TEST_CASE("droppatches: holes that meet at a point are filled before its fans would go") {
    const PointSet points = flatPoints(gridPoints());
    Params params = paperBut(&RobustRules::dropPatches);
    params.robust.closeHoles = true;
    Stepper stepper(points, params);
    State state(points.size());
    state.phase = Phase::Remesh;  // The last of the first round.
    state.repair = beginRepair(points.size(), gridWithout({gridPoint(2, 3), gridPoint(4, 3)}));
    REQUIRE(state.repair.pinched[gridPoint(3, 3)]);
    stepper.setState(state);
    stepper.run();
    CHECK(stepper.state().repair.droppedPatches == 0);
    CHECK(stepper.state().repair.closedHoles == 2);
    CHECK(stepper.state().repair.round == kRepairRounds);
}
