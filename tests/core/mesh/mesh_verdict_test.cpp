#include "spiraling_edge/mesh/mesh_verdict.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/run/reconstruct.h"
#include "support/clouds.h"
#include "support/open_surfaces.h"

using namespace se;
using namespace se::test;

namespace {

/// The points of a file with their judge, as a run has them.
PointSet judgedPoints(const PointFile& file) {
    PointSet points = prepare(file, {}).value().points;
    points.judge = judgeFor(file).value();
    return points;
}
std::vector<Triangle> meshOf(const PointSet& points) {
    return reconstruct(points, *paramsByName("robust")).state.mesh();
}
MeshVerdict verdictOf(const PointSet& points, const std::vector<Triangle>& mesh) {
    return judgeMesh(points, mesh).verdict;
}
void turnInsideOut(std::vector<Triangle>& mesh) {
    for (Triangle& t : mesh) std::swap(t.b, t.c);
}
/// A file of two, without normals if one lacks them.
PointFile both(PointFile a, const PointFile& b) {
    a.position.insert(a.position.end(), b.position.begin(), b.position.end());
    a.normal.insert(a.normal.end(), b.normal.begin(), b.normal.end());
    return a;
}
PointFile spherical(std::size_t count, double radius, const Vec3& middle = Vec3(0.0)) {
    PointFile file = fibonacciSphere(count);
    for (Vec3& x : file.position) x = radius * x + middle;
    return file;
}
MeshVerdict withPlaces(std::size_t places) {
    MeshVerdict verdict;
    verdict.totals.resize(failureClasses().size());
    verdict.placesOf.resize(failureClasses().size());
    verdict.triangles = 100;
    verdict.places = places;
    const auto holes = findFailureClass("holes") - failureClasses().data();
    verdict.totals[static_cast<std::size_t>(holes)] = {places, places, true};
    verdict.placesOf[static_cast<std::size_t>(holes)] = places;
    return verdict;
}

}  // namespace

TEST_CASE(
    "verdict: the headline counts places by their worst class, holes first, and points lost") {
    CHECK(headlineOf(withPlaces(0)) == "sound");
    CHECK(headlineOf(withPlaces(1)) == "1 place: 1 of holes");
    MeshVerdict verdict = withPlaces(2);
    const auto pairs = findFailureClass("intersecting_triangles") - failureClasses().data();
    verdict.placesOf[static_cast<std::size_t>(pairs)] = 5;
    verdict.places = 7;
    verdict.lost = 82;
    CHECK(headlineOf(verdict) == "7 places: 2 of holes, 5 of intersecting pairs; 82 points lost");
    CHECK(placesText(verdict) == "7 places");
    verdict.allPlaces = false;
    CHECK(headlineOf(verdict).starts_with("7 places or more: "));
    CHECK(placesText(verdict) == "7 places or more");
    // Lost points are said once.
    const auto lost = findFailureClass("lost_points") - failureClasses().data();
    verdict.placesOf[static_cast<std::size_t>(lost)] = 1;
    verdict.places = 8;
    CHECK(headlineOf(verdict).ends_with(": 2 of holes, 1 of lost points, 5 of intersecting pairs"));
    verdict.stopped = true;
    CHECK(headlineOf(verdict) == "stopped: too many triangles");
    MeshVerdict nothing = withPlaces(0);
    nothing.triangles = 0;
    CHECK(headlineOf(nothing) == "not sound: no triangle");
    MeshVerdict early = withPlaces(0);
    early.totals[static_cast<std::size_t>(pairs)].exact = false;
    CHECK(headlineOf(early) == "no fault found, but the search ended early");
    CHECK_FALSE(early.isSound());
}

TEST_CASE("verdict: faults are counted in one of the counts, or by their class") {
    for (const char* name :
         {"holes", "lost_points", "isolated_points", "flipped_triangles", "inward_pieces"})
        CHECK(isCounted(*findFailureClass(name)));
    for (const char* name : {"second_layers", "intersecting_triangles", "non_manifold_edges"})
        CHECK_FALSE(isCounted(*findFailureClass(name)));
    // Every name is that of a class of faults.
    for (const VerdictCount& count : verdictCounts()) {
        for (const std::string_view name : count.classes) {
            CAPTURE(count.name);
            if (!name.empty()) CHECK(findFailureClass(name)->fault);
        }
    }
}

TEST_CASE("verdict: sound is better, then fewer points amiss, however many places they are at") {
    // One tangle is one place, two holes are two.
    MeshVerdict tangled = withPlaces(1);
    tangled.amiss = 900;
    MeshVerdict holes = withPlaces(2);
    holes.amiss = 6;
    CHECK(isBetter(holes, tangled));
    CHECK_FALSE(isBetter(tangled, holes));
    CHECK_FALSE(isBetter(holes, holes));
    // A sound mesh may close an opening, and be in a piece more.
    MeshVerdict sound = withPlaces(0);
    sound.amiss = 30;
    sound.piecesOfPoints = 1;
    sound.pieces = 2;
    CHECK(isBetter(sound, holes));
    MeshVerdict whole = sound;
    whole.pieces = 1;
    CHECK(isBetter(whole, sound));
    MeshVerdict nearer = whole;
    whole.fidelity.meanDistance = 0.1;
    CHECK(isBetter(nearer, whole));
    CHECK_FALSE(isSounder(nearer, whole));
    for (const bool stopped : {true, false}) {
        MeshVerdict none = withPlaces(0);
        none.stopped = stopped;
        if (!stopped) none.triangles = 0;
        CHECK(isBetter(tangled, none));
        CHECK_FALSE(isBetter(none, tangled));
    }
}

TEST_CASE("verdict: a stray is counted beside the points lost, and in a triangle it is a spike") {
    PointFile file = fibonacciSphere(600);
    const PointSet clean = judgedPoints(file);
    const std::vector<Triangle> mesh = meshOf(clean);
    REQUIRE(verdictOf(clean, mesh).isSound());
    add(file, Vec3(0.0, 0.0, 3.0), Vec3(0.0, 0.0, 1.0));
    const PointSet points = judgedPoints(file);
    const MeshVerdict without = verdictOf(points, mesh);
    CHECK(without.isSound());
    CHECK(without.strays == 1);
    CHECK(without.lost == 0);
    // The stray in the place of one triangle.
    std::vector<Triangle> spiky = mesh;
    const Triangle t = spiky.back();
    spiky.pop_back();
    for (const auto& [a, b] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)})
        spiky.push_back({a, b, 600});
    const MeshVerdict with = verdictOf(points, spiky);
    CHECK_FALSE(with.isSound());
    const auto spikes = findFailureClass("spikes") - failureClasses().data();
    CHECK(with.totals[static_cast<std::size_t>(spikes)].total == 3);
}

TEST_CASE("verdict: of twins one may be in no triangle, of other points none") {
    PointFile file = fibonacciSphere(600);
    const std::vector<Triangle> mesh = meshOf(judgedPoints(file));
    add(file, file.position[100] + Vec3(1e-4, 0.0, 0.0), file.normal[100]);
    const MeshVerdict twin = verdictOf(judgedPoints(file), mesh);
    CHECK(twin.isSound());
    CHECK(twin.twins == 1);
    // Without the triangles at a point it is lost, and its neighbors are beside a hole.
    std::vector<Triangle> torn = mesh;
    std::erase_if(torn, [](const Triangle& t) { return t.a == 7 || t.b == 7 || t.c == 7; });
    const MeshVerdict lost = verdictOf(judgedPoints(fibonacciSphere(600)), torn);
    CHECK(lost.lost == 1);
    CHECK(lost.holeEdges == mesh.size() - torn.size());
    CHECK(lost.uncovered == lost.holeEdges + 1);
    CHECK(lost.amiss == lost.uncovered);
    CHECK(isBetter(twin, lost));
}

TEST_CASE("verdict: a closed piece faces in, unless it is within another and its normals say so") {
    const PointFile alone = fibonacciSphere(600);
    const PointSet points = judgedPoints(alone);
    std::vector<Triangle> mesh = meshOf(points);
    CHECK(verdictOf(points, mesh).facingIn == 0);
    turnInsideOut(mesh);
    CHECK(verdictOf(points, mesh).facingIn == 1);
    CHECK_FALSE(verdictOf(points, mesh).isSound());
    // The wall of a cavity: normals of the inner sphere point to its middle.
    PointFile inner = spherical(300, 0.6);
    for (Vec3& n : inner.normal) n = -n;
    const PointSet shell = judgedPoints(both(alone, inner));
    const std::vector<Triangle> walls = meshOf(shell);
    const MeshVerdict cavity = verdictOf(shell, walls);
    CHECK(cavity.pieces == 2);
    CHECK(cavity.facingIn == 0);
    CHECK(cavity.isSound());
    // Beside the other one it is inside out, whatever its normals say.
    for (Vec3& x : inner.position) x.x += 3.0;
    const PointSet beside = judgedPoints(both(alone, inner));
    CHECK(verdictOf(beside, meshOf(beside)).facingIn == 1);
}

TEST_CASE("verdict: a mesh in more pieces than the points is torn") {
    const PointFile two = both(spherical(600, 1.0), spherical(600, 1.0, Vec3(4.0, 0.0, 0.0)));
    const PointSet points = judgedPoints(two);
    CHECK(points.judge->facts.pieces == 2);
    const std::vector<Triangle> mesh = meshOf(points);
    CHECK(verdictOf(points, mesh).extraPieces() == 0);
    // Without a belt of triangles one of the spheres is in two pieces, and less is covered.
    std::vector<Triangle> torn = mesh;
    std::erase_if(torn, [&](const Triangle& t) {
        const auto inBelt = [&](Index p) {
            return std::abs(points.position[p].z) < 0.1 && points.position[p].x < 2.0;
        };
        return inBelt(t.a) || inBelt(t.b) || inBelt(t.c);
    });
    const MeshVerdict verdict = verdictOf(points, torn);
    CHECK(verdict.extraPieces() == 1);
    CHECK(verdict.covered() < 1.0);
    CHECK(verdict.uncovered > 0);
}

TEST_CASE("verdict: an opening of the points that the mesh covers is closed") {
    const Open open = sphereWithHoles({Vec3(0.0, 0.0, 1.0)}, 0.5, 3);
    const PointSet points = judgedPoints(open.file);
    CHECK(points.judge->openings.size() == 1);
    const MeshVerdict sound = verdictOf(points, meshOf(points));
    CHECK(sound.openings == 1);
    CHECK(sound.closed == 0);
    const MeshVerdict paper =
        verdictOf(points, reconstruct(points, *paramsByName("paper")).state.mesh());
    CHECK(paper.closed == 1);
    CHECK(paper.amiss >= points.judge->openings.front().size());
    CHECK(isBetter(sound, paper));
}

TEST_CASE("verdict: triangles against given normals count where these fit") {
    const PointFile file = fibonacciSphere(600);
    const PointSet points = judgedPoints(file);
    std::vector<Triangle> mesh = meshOf(points);
    turnInsideOut(mesh);
    CHECK(verdictOf(points, mesh).against == mesh.size());
    PointFile constant = file;
    for (Vec3& n : constant.normal) n = Vec3(0.0, 0.0, 1.0);
    CHECK(verdictOf(judgedPoints(constant), mesh).against == 0);
}
