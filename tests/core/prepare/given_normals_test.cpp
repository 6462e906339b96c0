#include "spiraling_edge/prepare/given_normals.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/stepper/params.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// Each normal tilted by an angle, to changing directions.
PointFile tilted(PointFile file, double degrees) {
    Random random(7);
    for (Vec3& n : file.normal) n = tilted(n, degrees, random);
    return file;
}

/// A box of n x n points a face, from a first axis on, with the normals of the faces; edges are
/// left out.
PointFile box(int n, const Vec3& size, int first = 0) {
    PointFile file;
    for (int axis = first; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            for (int i = 0; i < n * n; ++i) {
                Vec3 x(0.0);
                x[axis] = 0.5 * sign;
                x[(axis + 1) % 3] = (i % n + 0.5) / n - 0.5;
                x[(axis + 2) % 3] = (i / n + 0.5) / n - 0.5;
                file.position.push_back(x * size);
                Vec3 normal(0.0);
                normal[axis] = sign;
                file.normal.push_back(normal);
            }
        }
    }
    return file;
}

PointFile noisy(PointFile file, double width) {
    Random random(5);
    for (Vec3& x : file.position) x += width * random.between(-1.0, 1.0) * random.direction();
    return file;
}

PointFile flippedWhere(PointFile file, const std::function<bool(const Vec3&)>& where) {
    for (std::size_t p = 0; p < file.normal.size(); ++p) {
        if (where(file.position[p])) file.normal[p] = -file.normal[p];
    }
    return file;
}

PointFile withNormals(PointFile file, const std::function<Vec3(const Vec3&)>& normalAt) {
    for (std::size_t p = 0; p < file.normal.size(); ++p)
        file.normal[p] = normalAt(file.position[p]);
    return file;
}

/// One normal in twenty turned, by chance, and where.
std::pair<PointFile, std::vector<bool>> turnedByChance(PointFile file) {
    Random random(3);
    std::vector<bool> turned(file.normal.size(), false);
    for (std::size_t p = 0; p < turned.size(); ++p) {
        turned[p] = random.below(20) == 0;
        if (turned[p]) file.normal[p] = -file.normal[p];
    }
    return {std::move(file), std::move(turned)};
}

MeshJudge judgeOf(const PointFile& file) {
    const auto judge = judgeFor(file);
    REQUIRE(judge.ok());
    return *judge.value();
}

/// Checks that of right normals that of p, turned, is found alone. Returns the file with it.
PointFile checkFound(const PointFile& right, Index p) {
    PointFile file = right;
    file.normal[p] = -file.normal[p];
    const MeshJudge judge = judgeOf(file);
    CHECK(judge.facts.flippedNormals == 1);
    CHECK(judge.points.normal[p] == right.normal[p]);
    return file;
}

/// How many of the normals turned by chance are found, and how many others are accused.
struct TurnedFound {
    std::size_t turned = 0;
    std::size_t found = 0;
    std::size_t accused = 0;

    void add(const PointFile& right) {
        const auto [file, isTurned] = turnedByChance(right);
        const MeshJudge judge = judgeOf(file);
        for (Index p = 0; p < right.normal.size(); ++p) {
            if (glm::length(right.normal[p]) == 0.0) continue;
            turned += isTurned[p] ? 1U : 0U;
            const bool changed = glm::dot(judge.points.normal[p], file.normal[p]) < 0.0;
            (isTurned[p] ? found : accused) += changed ? 1U : 0U;
        }
    }
};

}  // namespace

TEST_CASE(
    "given normals: right ones fit and agree, at edges, in thin sheets, in noise and inside out") {
    struct Case {
        const char* name;
        PointFile file;
    };
    const auto out = [](const Vec3& x) { return -x; };
    const Case cases[] = {
        {"sphere", fibonacciSphere(600)},
        {"inside out", withNormals(fibonacciSphere(600), out)},
        {"tilted by 5 degrees", tilted(fibonacciSphere(600), 5.0)},
        {"sharp edges", box(12, Vec3(1.0))},
        {"a plate a third of a spacing thick", box(20, Vec3(1.0, 1.0, 0.017), 2)},
        {"noise of a tenth of the spacing", noisy(fibonacciSphere(1200), 0.01)},
        {"a tetrahedron", fibonacciSphere(4)},
        {"an octahedron", fibonacciSphere(6)},
    };
    for (const Case& each : cases) {
        CAPTURE(each.name);
        const MeshJudge judge = judgeOf(each.file);
        CHECK(judge.facts.normalsFit);
        CHECK(judge.areRight());
        CHECK(departureText(judge).empty());
    }
}

TEST_CASE("given normals: tilted ones, lines of sight, constants and chance do not fit") {
    Random random(3);
    const Vec3 scanner(4.0, 1.0, 2.0);
    struct Case {
        const char* name;
        PointFile file;
    };
    const Case cases[] = {
        {"tilted by 20 degrees", tilted(fibonacciSphere(600), 20.0)},
        {"tilted by 40 degrees", tilted(fibonacciSphere(600), 40.0)},
        {"tilted by 60 degrees", tilted(fibonacciSphere(600), 60.0)},
        {"all +z",
         withNormals(fibonacciSphere(600), [](const Vec3&) { return Vec3(0.0, 0.0, 1.0); })},
        {"lines of sight", withNormals(fibonacciSphere(600),
                                       [&](const Vec3& x) { return glm::normalize(scanner - x); })},
        {"chance",
         withNormals(fibonacciSphere(600), [&](const Vec3&) { return random.direction(); })},
        {"unsigned bytes",
         withNormals(fibonacciSphere(600), [](const Vec3& x) { return x + Vec3(1.0); })},
    };
    for (const Case& each : cases) {
        CAPTURE(each.name);
        const MeshJudge judge = judgeOf(each.file);
        CHECK_FALSE(judge.facts.normalsFit);
        CHECK(judge.facts.normalDegrees > 16.0);
        CHECK(departureText(judge).starts_with("by derived normals: the given ones are "));
        // Derived normals are those of the surface.
        for (Index p = 0; p < each.file.position.size(); ++p)
            CHECK(glm::dot(judge.points.normal[p], each.file.position[p]) > 0.9);
    }
}

TEST_CASE("given normals: zeros and numbers that are none do not fit") {
    for (const double value : {0.0, std::nan("")}) {
        const MeshJudge judge =
            judgeOf(withNormals(fibonacciSphere(600), [&](const Vec3&) { return Vec3(value); }));
        CHECK_FALSE(judge.facts.normalsFit);
        CHECK(glm::dot(judge.points.normal[5], judge.points.position[5]) > 0.9);
    }
}

TEST_CASE("given normals: a patch that contradicts the rest is judged by its other side") {
    for (const double from : {0.3, 0.8, 0.97}) {
        CAPTURE(from);
        const PointFile right = fibonacciSphere(600);
        const PointFile file = flippedWhere(right, [&](const Vec3& x) { return x.z > from; });
        const MeshJudge judge = judgeOf(file);
        CHECK(judge.facts.normalsFit);
        CHECK_FALSE(judge.areRight());
        for (Index p = 0; p < right.normal.size(); ++p)
            CHECK(glm::dot(judge.points.normal[p], right.normal[p]) > 0.99);
    }
}

TEST_CASE("given normals: a single flipped one is found beside the edges of a part") {
    constexpr Index n = 12;
    const PointFile right = box(n, Vec3(1.0));
    for (Index p = 0; p < n * n; ++p) {
        // At a corner too few points lie beside it.
        const bool atCorner = (p % n == 0 || p % n == n - 1) && (p / n == 0 || p / n == n - 1);
        if (atCorner) continue;
        CAPTURE(p);
        checkFound(right, p);
    }
}

TEST_CASE("given normals: a single flipped one is found on a ridge, where no plane goes on") {
    // Two slopes of 40 degrees; on the ridge the normals point straight up.
    constexpr Index n = 13;
    const Vec3 slope = glm::normalize(Vec3(std::sin(0.7), 0.0, std::cos(0.7)));
    PointFile right;
    for (Index i = 0; i < n * n; ++i) {
        const double x = static_cast<double>(i % n) - 6.0;
        const double y = static_cast<double>(i / n);
        right.position.emplace_back(x * std::cos(0.7), y, -std::abs(x) * std::sin(0.7));
        right.normal.push_back(x == 0.0 ? Vec3(0, 0, 1)
                                        : Vec3(x > 0.0 ? slope.x : -slope.x, 0.0, slope.z));
    }
    CHECK(judgeOf(right).areRight());
    const std::vector<bool> present(right.position.size(), true);
    const NeighborLists nearest = nearestPoints(right.position, present, 12, 1).value();
    for (Index row = 1; row + 1 < n; ++row) {
        const Index p = row * n + 6;
        CAPTURE(row);
        const PointFile file = checkFound(right, p);
        // It belongs to the part that it was against.
        const Sides sides = sidesOf({file.position, file.normal, present, nearest});
        CHECK(sides.flipped[p]);
        CHECK(sides.component[p] == sides.component[nearest[p].front()]);
    }
}

TEST_CASE("given normals: few points under a dense plate keep their side, and so in a slot") {
    for (const double facing : {1.0, -1.0}) {
        PointFile file;
        for (int i = 0; i < 30 * 30; ++i) {
            file.position.emplace_back(i % 30, i / 30, 0.0);
            file.normal.emplace_back(0.0, 0.0, facing);
        }
        // Each of them has only points of the dense side about it.
        for (int i = 0; i < 36; ++i) {
            file.position.emplace_back(2.3 + 5.0 * (i % 6), 2.4 + 5.0 * (i / 6), -0.6);
            file.normal.emplace_back(0.0, 0.0, -facing);
        }
        CHECK(judgeOf(file).facts.flippedNormals == 0);
    }
}

TEST_CASE("given normals: nothing is said of the side of a stray") {
    PointFile file;
    for (int i = 0; i < 12 * 12; ++i) {
        file.position.emplace_back(i % 12, i / 12, 0.0);
        file.normal.emplace_back(0.0, 0.0, 1.0);
    }
    // Five spacings beyond the rim, 40 degrees up, against each normal mirrored halfway.
    const Vec3 along(std::cos(0.7), 0.0, std::sin(0.7));
    file.position.push_back(Vec3(11.0, 5.5, 0.0) + 5.0 * along);
    file.normal.push_back(2.0 * along.z * along - Vec3(0.0, 0.0, 1.0));
    CHECK(judgeOf(file).facts.flippedNormals == 0);
}

TEST_CASE("given normals: those turned by chance are found, and no others") {
    TurnedFound sum;
    for (const PointFile& right : {fibonacciSphere(900), box(12, Vec3(1.0)),
                                   noisy(fibonacciSphere(900), 0.02), box(12, Vec3(3.0, 1.0, 0.5))})
        sum.add(right);
    CHECK(sum.found + 1 >= sum.turned);  // but one at a corner
    CHECK(sum.accused == 0);
}

TEST_CASE("given normals: those of shared sets turned by chance are found" *
          doctest::test_suite("long")) {
    const std::vector<std::vector<std::string>> groups{
        {"bunny_small", "camel", "coupling", "elephant", "femur", "hippo", "oni", "three_peaks"},
        {"bones", "fandisk", "fin90", "kitten", "nefertiti", "seven_parts", "sphere_even",
         "table1_electron_cloud", "table1_hyperboloid", "torus_knot", "blobs", "brain_piece"}};
    for (const std::vector<std::string>& names : groups) {
        TurnedFound sum;
        for (const std::string& name : names) {
            CAPTURE(name);
            const auto file = sharedPoints("points/" + name + ".ply");
            if (!file) return;
            // By its own normals, one point of the bones stands against the others.
            const std::size_t flipped = judgeOf(*file).facts.flippedNormals;
            CHECK(flipped == (name == "bones" ? 1 : 0));
            sum.add(*file);
            sum.accused -= flipped;
        }
        CAPTURE(sum.turned);
        CAPTURE(sum.found);
        CHECK(sum.found >= sum.turned * 9 / 10);
        // One more of the bones, whose parts are thinner than their spacing.
        CHECK(sum.accused <= (names.front() == "bones" ? 1 : 0));
    }
}

TEST_CASE("given normals: the order of the points and the number of threads change nothing") {
    const PointFile file = tilted(box(16, Vec3(1.0, 1.0, 0.3)), 15.0);
    PointFile reversed = file;
    std::reverse(reversed.position.begin(), reversed.position.end());
    std::reverse(reversed.normal.begin(), reversed.normal.end());
    CHECK(judgeOf(file).facts.normalsFit == judgeOf(reversed).facts.normalsFit);
    const MeshJudge one = *judgeFor(file, 1).value();
    const MeshJudge three = *judgeFor(file, 3).value();
    CHECK(one.facts.normalsFit == three.facts.normalsFit);
    CHECK(one.points.normal == three.points.normal);
}

TEST_CASE(
    "given normals: the vertices of a hard edge are one point with the mean of their normals") {
    // The corners of a cube, a vertex for each of the three faces that meet there.
    PointFile file;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 x((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                     (corner & 4) != 0 ? 1.0 : -1.0);
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
            file.position.push_back(x);
            file.normal.push_back(glm::dot(x, axis) * axis);
        }
    }
    // A face with two triangles there has two vertices, and counts once.
    file.position.push_back(file.position[0]);
    file.normal.push_back(file.normal[0]);
    std::vector<Vec3> normal = file.normal;
    CHECK(averageOverCopies(placedPoints(file.position), normal) == 8);
    for (Index p = 0; p < 24; p += 3)
        CHECK(glm::distance(normal[p], glm::normalize(file.position[p])) < 1e-12);
    CHECK(normal[1] == file.normal[1]);
    // Two sides of a sheet cancel out: the first stays.
    std::vector<Vec3> sheet{Vec3(0, 0, 1), Vec3(0, 0, -1)};
    CHECK(averageOverCopies(placedPoints(std::vector<Vec3>(2, Vec3(0.0))), sheet) == 0);
    CHECK(sheet[0] == Vec3(0, 0, 1));
}

TEST_CASE("judge: a mesh turned against right normals has flipped triangles, whatever made it") {
    const PointFile file = fibonacciSphere(600);
    PrepareOptions options;
    const PointSet run = prepare(file, options).value().points;
    std::vector<Triangle> mesh = reconstruct(run, *paramsByName("robust")).state.mesh();
    REQUIRE(mesh.size() == 1196);
    for (Triangle& t : mesh) std::swap(t.b, t.c);
    PointSet points = run;
    for (Vec3& n : points.normal) n = -n;
    CHECK(inspectWithTotals(points, mesh).report.flippedTriangles == 0);
    points.judge = judgeFor(file).value();
    CHECK(inspectWithTotals(points, mesh).report.flippedTriangles == mesh.size());
    // The user's word turns a piece only where its shape does not speak against it.
    options.normals = NormalSource::Oriented;
    points.judge = judgeOfRun(file, options, {}, points).value();
    CHECK(inspectWithTotals(points, mesh).report.flippedTriangles == mesh.size());
    const PointFile inward = withNormals(file, [](const Vec3& x) { return -x; });
    points.judge = judgeOfRun(inward, options, {}, run).value();
    for (Triangle& t : mesh) std::swap(t.b, t.c);
    CHECK(faultCount(inspectWithTotals(points, mesh).totals) == 0);
}

TEST_CASE("given normals: points on the edges of a part alone say nothing against its normals") {
    // Rings around the two ends of a cylinder: their planes are none of the surface.
    PointFile file;
    for (int i = 0; i < 240; ++i) {
        const double a = 2.0 * std::numbers::pi * (i / 4) / 60.0;
        const double r = i % 2 == 0 ? 1.0 : 0.97;
        const double side = i % 4 < 2 ? 1.0 : -1.0;
        file.position.emplace_back(r * std::cos(a), r * std::sin(a), 0.2 * side);
        const Vec3 out(std::cos(a), std::sin(a), 0.0);
        file.normal.push_back(glm::normalize(i % 2 == 0 ? out : -out));
    }
    CHECK(judgeOf(file).facts.normalsFit);
}

TEST_CASE("given normals: those of the shared sets fit, and tilted or constant ones do not" *
          doctest::test_suite("long")) {
    const std::filesystem::path folder = sharedFile("points");
    if (folder.empty()) return;
    std::size_t spoiled = 0;
    std::size_t found = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder)) {
        const PointFile file = readPoints(each.path()).value();
        // Large sets take long, and show nothing that smaller ones of their kind do not.
        if (!file.hasNormals() || file.position.size() > 15'000) continue;
        CHECK_MESSAGE(judgeOf(file).facts.normalsFit, each.path().filename());
        const auto up = [](const Vec3&) { return Vec3(0, 0, 1); };
        for (const PointFile& wrong :
             {tilted(file, 20.0), tilted(file, 40.0), tilted(file, 60.0), withNormals(file, up)}) {
            ++spoiled;
            found += judgeOf(wrong).facts.normalsFit ? 0U : 1U;
        }
    }
    // Where too few places are planar nothing is known.
    CHECK(10 * found >= 7 * spoiled);
    for (const char* name : {"normals_tilted_20_degrees.xyz", "normals_are_ray_directions.ply"}) {
        CAPTURE(name);
        const auto file = sharedPoints("cases/" + std::string(name));
        if (file) CHECK_FALSE(judgeOf(*file).facts.normalsFit);
    }
}
