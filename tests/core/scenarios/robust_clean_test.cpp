/// The rules beyond the paper, all together, on even samples of smooth surfaces (docs/robust.md):
/// a sound mesh of the ideal number of triangles, at any size.
#include <doctest/doctest.h>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/spec/run_spec.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// The topology of a mesh of a whole surface.
struct Topology {
    long long euler;
    std::size_t components, loops;
};

struct LeastAngles {
    double mean = 0.0;
    double least = 180.0;
};

/// Least angles of the triangles, in degrees.
LeastAngles leastAngles(const PointSet& points, const std::vector<Triangle>& triangles) {
    LeastAngles angles;
    for (const Triangle& t : triangles) {
        const double least = std::acos(leastAngleCosine(points, t)) * 180 / kPi;
        angles.mean += least / static_cast<double>(triangles.size());
        angles.least = std::min(angles.least, least);
    }
    return angles;
}

/// Runs and checks everything that must hold for any clean cloud, closed or cut by walls.
void checkClean(const PointSet& points, const Topology& topology, const std::string& what) {
    const Run run = runAll(points, robust());
    const MeshReport& mesh = run.mesh;
    std::size_t onWalls = 0;
    for (const std::uint8_t type : points.type) onWalls += isBoundary(type) ? 1 : 0;
    const auto ideal = 2 * static_cast<long long>(points.size()) - static_cast<long long>(onWalls) -
                       2 * topology.euler;
    CHECK_MESSAGE(run.state.finished(), what);
    CHECK_MESSAGE(describeFaults(points, run.state.mesh()) == "", what);
    CHECK_MESSAGE(mesh.unusedPoints == 0, what);
    CHECK_MESSAGE(mesh.nonManifoldVertices == 0, what);
    CHECK_MESSAGE(static_cast<long long>(mesh.triangles) == ideal, what);
    CHECK_MESSAGE(mesh.eulerCharacteristic == topology.euler, what);
    CHECK_MESSAGE(mesh.components == topology.components, what);
    CHECK_MESSAGE(mesh.boundaryLoops == topology.loops, what);
    CHECK_MESSAGE(mesh.boundaryEdges == onWalls, what);
    CHECK_MESSAGE(mesh.closedManifold() == (topology.loops == 0), what);
    CHECK_MESSAGE(run.state.counters.holes == 0, what);
    if (topology.loops == 0) CHECK_MESSAGE(run.state.counters.openings == 0, what);
    const LeastAngles angles = leastAngles(points, run.state.mesh());
    CHECK_MESSAGE(angles.mean >= 42.0, what);
    // No triangle over three points in line stands on a curved surface.
    if (points.size() > 3000) CHECK_MESSAGE(angles.least > 15.0, what);
}

/// A surface in a box, to be sampled at any size.
struct NamedShape {
    std::string name;
    ImplicitSurface surface;
    Vec3 low, high;
    Topology topology;
    PointSet sample(std::size_t count, std::uint64_t seed) const {
        const Field field{surface.value, surface.gradient, low, high, 0.0, Outside::HigherValues};
        const Result<PointFile> file = se::sample(field, {.count = count, .seed = seed});
        REQUIRE_MESSAGE(file.ok(), name);
        return prepared(file.value());
    }
};

NamedShape closed(const std::string& name, const ImplicitSurface& surface,
                  const Topology& topology) {
    return {name, surface, surface.low, surface.high, topology};
}
NamedShape gyroidInBox() { return {"gyroid", gyroid(), Vec3(-2.7), Vec3(3.1), {-3, 1, 1}}; }

std::vector<NamedShape> namedShapes() {
    return {closed("sphere", unitSphere(), {2, 1, 0}),
            closed("torus", torus(), {0, 1, 0}),
            closed("linked tori", linkedTori(), {0, 2, 0}),
            closed("genus 2", doubleTorus(), {-2, 1, 0}),
            {"wavy sheet", wavySheet(), Vec3(-1.0), Vec3(1.0), {1, 1, 1}},
            gyroidInBox()};
}

/// Checks a cloud of each size for every seed.
void checkSizes(const NamedShape& shape, std::initializer_list<std::size_t> sizes,
                std::uint64_t seeds) {
    for (const std::size_t size : sizes) {
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const PointSet points = shape.sample(size, seed);
            checkClean(points, shape.topology,
                       shape.name + " of " + std::to_string(points.size()) + ", seed " +
                           std::to_string(seed));
        }
    }
}

}  // namespace

TEST_CASE("robust: clean clouds come out as well with other numbers of neighbors") {
    for (const Family& family : closedFamilies(1.0)) {
        const PointFile file = family.sample(4);
        for (const std::size_t k : {10U, 16U}) {
            checkClean(prepared(file, reach(k)),
                       {family.euler, static_cast<std::size_t>(family.components), 0},
                       family.name + ", k " + std::to_string(k));
        }
    }
}

TEST_CASE("robust: clean clouds of 215 to 3,700 points come out sound and of the ideal number" *
          doctest::test_suite("long")) {
    for (const NamedShape& shape : namedShapes()) {
        // The pieces of a gyroid this large need more points than 215.
        if (shape.name == "gyroid") continue;
        // And so do tubes as near each other as these.
        if (shape.name != "linked tori") checkSizes(shape, {215}, 2);
        checkSizes(shape, {1400}, 2);
        checkSizes(shape, {3700}, 1);
    }
}

TEST_CASE("robust: a gyroid in a box ends at its walls and nowhere else" *
          doctest::test_suite("long")) {
    checkSizes({"gyroid", gyroid(), Vec3(-2.7), Vec3(0.9), {-1, 1, 3}}, {215}, 4);
    checkSizes(gyroidInBox(), {1400}, 2);
    checkSizes(gyroidInBox(), {3700}, 1);
}

TEST_CASE("bothwalls: where the ring passes from wall to wall no point is left pinched") {
    for (const std::uint64_t seed : {18, 84}) {
        const PointSet points = gyroidInBox().sample(1400, seed);
        for (const bool on : {false, true}) {
            Params params = robust();
            params.robust.bothWalls = on;
            // Both would repair it.
            params.robust.closeHoles = params.robust.dropPatches = false;
            CHECK(runAll(points, params).mesh.nonManifoldVertices == (on ? 0 : 1));
        }
    }
}

TEST_CASE("robust: clean clouds of 43,000 points come out sound and of the ideal number" *
          doctest::test_suite("long")) {
    for (const NamedShape& shape : namedShapes()) {
        if (shape.name == "linked tori" || shape.name == "gyroid") checkSizes(shape, {43000}, 1);
    }
}

TEST_CASE("robust: a sphere cut by a box ends at its six windows and nowhere else" *
          doctest::test_suite("long")) {
    checkSizes({"windows", unitSphere(), Vec3(-0.9), Vec3(0.9), {2 - 6, 1, 6}}, {215, 1400, 3700},
               2);
}

TEST_CASE("nocross: an end that passes by a ring point closer by is not moved over the ring") {
    // The triangle 0 3 2 would hold 4, from which the ring runs on to 5 across its side 0 3.
    const auto run = [](const Params& params) {
        Rig rig({{0, 0, 0},
                 polar(0),
                 polar(170),
                 polar(124, 1.6),
                 polar(125, 1.0),
                 polar(72, 1.2),
                 polar(30, 2.5)},
                params);
        rig.list(0, {1, 2, 3, 4, 5}).ring({0, 2, 3, 4, 5, 6, 1}).pivot();
        return rig.newTriangles();
    };
    const Triangles overRing{{0, 1, 5}, {0, 5, 3}, {0, 3, 2}};
    CHECK(run(paper()) == overRing);
    CHECK(run(paperBut(&RobustRules::noCross)).empty());
}

TEST_CASE("nocross: edges of one straight border do not cross, however it lies") {
    // The border runs through 5, 2, 3 and 4; 5 and 2 are to be joined, 3 and 4 are.
    const std::vector<Vec3> upright{{0, 0, 0},       {1, 0.2, 0},     {-0.5, -0.1, 0},
                                    {-0.5, -0.2, 0}, {-0.5, -1.2, 0}, {-0.5, 0.9, 0}};
    const Triangles both{{0, 1, 5}, {0, 5, 2}};
    // Rounding errors rarely conspire.
    constexpr int kTurns = 10000;
    for (int turn = 0; turn < kTurns; ++turn) {
        const double degrees = 360.0 * turn / kTurns;
        std::vector<Vec3> turned;
        const Vec3 x = polar(degrees);
        const Vec3 y = polar(degrees + 90);
        for (const Vec3& p : upright) turned.push_back(p.x * x + p.y * y);
        Rig rig(turned, paperBut(&RobustRules::noCross));
        rig.list(0, {5, 3}).ring({0, 2, 3, 4, 1}).pivot();
        CHECK_MESSAGE(rig.newTriangles() == both, degrees, " degrees");
    }
}

TEST_CASE("robust: no point of a straight border is passed over" * doctest::test_suite("long")) {
    const NamedShape sheet{"flat sheet", flatSheet(), Vec3(-1.0), Vec3(1.0), {1, 1, 1}};
    checkSizes(sheet, {100, 215}, 12);
    checkSizes(sheet, {1400}, 1);
}

namespace {

/// The middles of the cells of a grid on each face of a cube, moved about by a quarter of a cell.
PointFile cubeOfFaces(int cells, std::uint64_t seed) {
    Random random(seed);
    PointFile file;
    for (const int axis : {0, 1, 2}) {
        for (const double side : {-1.0, 1.0}) {
            for (int i = 0; i < cells * cells; ++i) {
                const Vec3 moved = 0.25 * random.inCube();
                Vec3 place(side);
                place[(axis + 1) % 3] = 2.0 * (i % cells + 0.5 + moved.x) / cells - 1.0;
                place[(axis + 2) % 3] = 2.0 * (i / cells + 0.5 + moved.y) / cells - 1.0;
                Vec3 normal(0.0);
                normal[axis] = side;
                file.position.push_back(place);
                file.normal.push_back(normal);
            }
        }
    }
    return file;
}

}  // namespace

TEST_CASE("robust: a cube without points on its edges is one closed piece, by right angles too") {
    const RunSpec spec = specOf(robust());
    for (const std::uint64_t seed : {1, 2, 3}) {
        const PointFile file = cubeOfFaces(20, seed);
        const PrepareOptions options = prepareOptionsOf(spec, robust(), file).value();
        const PointSet points = prepare(file, options).value().points;
        const Run run = runAll(points, robust());
        CAPTURE(seed);
        CHECK(describeFaults(points, run.state.mesh()) == "");
        CHECK(run.mesh.unusedPoints == 0);
        CHECK(run.mesh.components == 1);
        CHECK(run.mesh.closedManifold());
        CHECK(run.mesh.eulerCharacteristic == 2);
    }
}
