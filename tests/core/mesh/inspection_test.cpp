#include "spiraling_edge/mesh/inspection.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/mesh/fidelity.h"

using namespace se;

namespace {

using Faces = std::vector<Triangle>;
using Counts = std::map<std::string, std::size_t>;

Counts countsOf(const PointSet& points, const Faces& triangles) {
    Counts counts;
    for (const MeshFailure& failure : inspectMesh(points, triangles))
        ++counts[std::string(failure.kind->name)];
    return counts;
}

PointSet positionsOnly(std::vector<Vec3> position) {
    PointSet points;
    points.position = std::move(position);
    return points;
}

/// Six points and eight triangles, closed, outwards.
PointSet octahedron() {
    PointSet points =
        positionsOnly({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    points.normal = points.position;
    return points;
}
const Faces kOctahedron{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                        {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

/// A flat grid of n x n points, two triangles per square.
struct Sheet {
    PointSet points;
    Faces triangles;
};
Sheet sheet(Index n) {
    Sheet result;
    for (Index y = 0; y < n; ++y) {
        for (Index x = 0; x < n; ++x) result.points.position.push_back({x, y, 0.0});
    }
    result.points.normal.assign(result.points.size(), {0, 0, 1});
    for (Index y = 0; y + 1 < n; ++y) {
        for (Index x = 0; x + 1 < n; ++x) {
            const Index p = y * n + x;
            result.triangles.push_back({p, p + 1, p + n + 1});
            result.triangles.push_back({p, p + n + 1, p + n});
        }
    }
    return result;
}

}  // namespace

TEST_CASE("inspection: nothing is wrong with a closed octahedron") {
    CHECK(countsOf(octahedron(), kOctahedron).empty());
}

TEST_CASE("inspection: a mesh of extreme size has the faults of one of size 1") {
    // A hill with a hole, a triangle through the surface, a flipped one, and a lost point.
    Sheet hill = sheet(12);
    for (Vec3& x : hill.points.position) x = {x.x / 12.0, x.y / 12.0, x.x * x.y / 200.0};
    std::swap(hill.triangles[100].b, hill.triangles[100].c);
    hill.triangles.erase(hill.triangles.begin() + 120);
    hill.triangles.push_back({3, 68, 140});
    hill.points.position.push_back({0.5, 0.5, 0.2});
    hill.points.normal.push_back({0, 0, 1});
    hill.points.type.assign(hill.points.size(), kInterior);
    const MeshInspection usual = inspectWithTotals(hill.points, hill.triangles);
    const std::vector<double> distances = distancesFromMesh(hill.points, hill.triangles);
    const Counts counts = countsOf(hill.points, hill.triangles);
    for (const char* name : {"holes", "intersecting_triangles", "flipped_triangles", "lost_points"})
        CHECK_MESSAGE(counts.contains(name), name);
    // About 1e100, 1e140, 1e150 and their inverses: powers of two, since which triangles touch
    // exactly depends on rounding.
    for (const int power : {332, 465, 498, -332, -465, -498}) {
        CAPTURE(power);
        const double scale = std::ldexp(1.0, power);
        PointSet points = hill.points;
        for (Vec3& x : points.position) x *= scale;
        const MeshInspection extreme = inspectWithTotals(points, hill.triangles);
        CHECK(countsOf(points, hill.triangles) == counts);
        REQUIRE(extreme.failures.size() == usual.failures.size());
        CHECK(extreme.meanEdge == doctest::Approx(scale * usual.meanEdge).epsilon(1e-9));
        CHECK(extreme.report.widestLoopWidth / scale ==
              doctest::Approx(usual.report.widestLoopWidth));
        CHECK(reportMesh(points, hill.triangles).degenerateTriangles == 0);
        for (std::size_t i = 0; i < usual.failures.size(); ++i) {
            CHECK(extreme.failures[i].points == usual.failures[i].points);
            CHECK(extreme.failures[i].length / scale == doctest::Approx(usual.failures[i].length));
            CHECK(extreme.failures[i].place.x / scale ==
                  doctest::Approx(usual.failures[i].place.x));
        }
        const std::vector<double> far = distancesFromMesh(points, hill.triangles);
        CHECK(far.back() / scale == doctest::Approx(distances.back()));
    }
}

TEST_CASE("inspection: one far point does not change what is found at the others") {
    PointSet points = octahedron();
    Faces faces = kOctahedron;
    points.position.insert(points.position.end(), {{3, 0, 0}, {4, 0, 0}, {1e150, 1e150, 0}});
    points.normal.resize(points.size(), Vec3(0, 0, 1));
    faces.push_back({6, 7, 8});
    for (const MeshFailure& failure : inspectMesh(points, faces)) {
        CAPTURE(describe(failure));
        CHECK(failure.points.back() == 8);
    }
}

TEST_CASE("inspection: without normals and types nothing is flipped") {
    PointSet points = octahedron();
    points.normal.clear();
    Faces inverse = kOctahedron;
    for (Triangle& t : inverse) std::swap(t.b, t.c);
    CHECK(countsOf(points, inverse) == Counts{{"inward_pieces", 1}});
    CHECK(countsOf(octahedron(), inverse) ==
          Counts{{"flipped_triangles", 8}, {"inward_pieces", 1}});
}

TEST_CASE("inspection: a missing triangle is a hole with its length and area") {
    Faces open = kOctahedron;
    open.erase(open.begin());
    const std::vector<MeshFailure> failures = inspectMesh(octahedron(), open);
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].kind->name == "holes");
    CHECK(failures[0].points == std::vector<Index>{0, 2, 4});
    CHECK(failures[0].length == doctest::Approx(3.0 * std::sqrt(2.0)));
    CHECK(failures[0].area == doctest::Approx(std::sqrt(3.0) / 2.0));
}

TEST_CASE("inspection: the border of a patch is an opening, and no fault") {
    const Sheet s = sheet(5);
    CHECK(countsOf(s.points, s.triangles) == Counts{{"openings", 1}});
    CHECK(isSound(inspectWithTotals(s.points, s.triangles).totals, s.triangles.size()));
}

TEST_CASE("inspection: a wide loop is an opening, a narrow one is a hole") {
    // Squares of 1, 3 and 5 cells are missing in the middle. The points at the wide ones see free
    // sectors of 180 degrees; of the smallest of 90.
    for (const Index missing : {Index{1}, Index{5}}) {
        Sheet s = sheet(12);
        const auto inside = [&](Index p) {
            const Vec3& x = s.points.position[p];
            return x.x >= 3 && x.y >= 3 && x.x <= 3 + missing && x.y <= 3 + missing;
        };
        std::erase_if(s.triangles,
                      [&](const Triangle& t) { return inside(t.a) && inside(t.b) && inside(t.c); });
        const Counts counts = countsOf(s.points, s.triangles);
        CHECK(counts.count("holes") == (missing == 1 ? 1 : 0));
        CHECK(counts.at("openings") == (missing == 1 ? 1 : 2));
    }
    // Long, but one edge wide: a seam.
    Sheet s = sheet(12);
    std::erase_if(s.triangles, [&](const Triangle& t) {
        const auto inside = [&](Index p) {
            const Vec3& x = s.points.position[p];
            return x.x >= 2 && x.x <= 9 && x.y >= 3 && x.y <= 4;
        };
        return inside(t.a) && inside(t.b) && inside(t.c);
    });
    CHECK(countsOf(s.points, s.triangles) == Counts{{"holes", 1}, {"openings", 1}});
}

TEST_CASE("inspection: without normals a loop is an open border, and no fault") {
    Faces open = kOctahedron;
    open.erase(open.begin());
    PointSet points = octahedron();
    CHECK(countsOf(points, open) == Counts{{"holes", 1}});
    points.normal.clear();
    CHECK(countsOf(points, open) == Counts{{"openings", 1}});
}

TEST_CASE("inspection: a border along the walls is no hole, one that leaves them is") {
    Sheet s = sheet(5);
    s.points.type.assign(s.points.size(), kInterior);
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const Vec3& x = s.points.position[i];
        std::uint8_t& type = s.points.type[i];
        if (x.x == 0.0) type |= kNegativeX;
        if (x.x == 4.0) type |= kPositiveX;
        if (x.y == 0.0) type |= kNegativeY;
        if (x.y == 4.0) type |= kPositiveY;
    }
    CHECK(countsOf(s.points, s.triangles) == Counts{{"openings", 1}});
    // A single interior point bulges past the chord of two wall points.
    Sheet bulging = s;
    std::erase_if(bulging.triangles, [](const Triangle& t) {
        return t == Triangle{1, 2, 7} || t == Triangle{1, 7, 6};
    });
    bulging.triangles.push_back({1, 7, 6});
    CHECK(countsOf(bulging.points, bulging.triangles) == Counts{{"openings", 1}});
    s.triangles.erase(s.triangles.begin() + 12);  // inside: touches interior points
    CHECK(countsOf(s.points, s.triangles) == Counts{{"holes", 1}, {"openings", 1}});
}

TEST_CASE("inspection: two fans at a point") {
    PointSet points = positionsOnly({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}});
    const std::vector<MeshFailure> failures = inspectMesh(points, Faces{{0, 1, 2}, {0, 3, 4}});
    const auto found = std::find_if(failures.begin(), failures.end(), [](const MeshFailure& f) {
        return f.kind->name == "non_manifold_vertices";
    });
    REQUIRE(found != failures.end());
    CHECK(found->points == std::vector<Index>{0});
    CHECK(found->triangles == std::vector<Index>{0, 1});
}

TEST_CASE("inspection: one triangle inside out") {
    Faces turned = kOctahedron;
    std::swap(turned[0].b, turned[0].c);
    const Counts counts = countsOf(octahedron(), turned);
    CHECK(counts == Counts{{"inconsistent_edges", 3}, {"flipped_triangles", 1}});
}

TEST_CASE("inspection: the same three points twice, in either winding") {
    Faces twice = kOctahedron;
    twice.push_back({4, 0, 2});
    CHECK(countsOf(octahedron(), twice).at("duplicate_triangles") == 1);
    twice.back() = {2, 0, 4};
    CHECK(countsOf(octahedron(), twice).at("duplicate_triangles") == 1);
    twice.push_back({4, 2, 0});
    CHECK(countsOf(octahedron(), twice).at("duplicate_triangles") == 1);
}

TEST_CASE("inspection: triangles of two common points, or with a corner twice, are no duplicates") {
    const PointSet points = positionsOnly({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    const Faces aroundEdge{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    CHECK(countsOf(points, aroundEdge).count("duplicate_triangles") == 0);
    for (const Triangle& t : {Triangle{0, 1, 1}, Triangle{0, 0, 1}, Triangle{1, 0, 1}})
        CHECK(countsOf(points, {t}).count("duplicate_triangles") == 0);
}

TEST_CASE("inspection: triangles without area, and slivers") {
    const PointSet points =
        positionsOnly({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0.01, 0}, {1, 0.02, 0}});
    CHECK(countsOf(points, {{0, 1, 2}}).at("degenerate_triangles") == 1);
    CHECK(countsOf(points, {{0, 1, 2}}).count("slivers") == 0);
    CHECK(countsOf(points, {{0, 1, 1}}).at("degenerate_triangles") == 1);
    // The least angles are atan(0.01) = 0.57 and atan(0.02) = 1.15 degrees.
    CHECK(countsOf(points, {{0, 2, 3}}).at("slivers") == 1);
    CHECK(countsOf(points, {{0, 2, 4}}).count("slivers") == 0);
}

TEST_CASE("inspection: a height of a millionth of the longest edge makes a needle") {
    const auto counts = [](double height) {
        return countsOf(positionsOnly({{0, 0, 0}, {2, 0, 0}, {1, height, 0}}), {{0, 1, 2}});
    };
    CHECK(counts(1.99e-6).at("degenerate_triangles") == 1);
    CHECK(counts(2.01e-6).count("degenerate_triangles") == 0);
    CHECK(counts(2.01e-6).at("slivers") == 1);
}

TEST_CASE("inspection: slivers and openings are remarks, a second layer is a fault") {
    Sheet s = sheet(4);
    s.points.position[0] = {0.001, 0.9995, 0.0};  // nearly on a side of its two triangles
    const MeshInspection thin = inspectWithTotals(s.points, s.triangles);
    CHECK(thin.failures.size() > 1);
    CHECK(faultCount(thin.totals) == 0);
    const auto first = static_cast<Index>(s.points.size());
    for (const Vec3& x : {Vec3(1, 1, 0.3), Vec3(2, 1, 0.3), Vec3(1, 2, 0.3)}) {
        s.points.position.push_back(x);
        s.points.normal.push_back({0, 0, 1});
    }
    s.triangles.push_back({first, first + 1, first + 2});
    const MeshInspection found = inspectWithTotals(s.points, s.triangles);
    CHECK_FALSE(isSound(found.totals, s.triangles.size()));
    CHECK(countsOf(s.points, s.triangles).at("second_layers") > 0);
    // Without the search for pairs the mesh is not known to be sound.
    s.triangles.pop_back();
    CHECK_FALSE(isSound(inspectLocally(s.points, s.triangles).totals, s.triangles.size()));
}

TEST_CASE("inspection: a few triangles within two edges of a larger piece, points near and far") {
    Sheet s = sheet(40);
    const auto first = static_cast<Index>(s.points.size());
    // The mean edge is (2 + sqrt(2)) / 3 = 1.14 long.
    for (const Vec3& x :
         {Vec3(41.2, 0, 0), Vec3(42, 0, 0), Vec3(41.5, 1, 0), Vec3(50, 0, 0), Vec3(51, 0, 0),
          Vec3(50, 1, 0), Vec3(20.5, 20.5, 0.2), Vec3(20, 20, 30), Vec3(20.6, 20.6, 0.2)}) {
        s.points.position.push_back(x);
        s.points.normal.push_back({0, 0, 1});
    }
    s.triangles.push_back({first, first + 1, first + 2});      // 2.2 from the sheet
    s.triangles.push_back({first + 3, first + 4, first + 5});  // 8 from the other one
    s.points.aside.assign(s.points.size(), Aside::No);
    s.points.aside.back() = Aside::Noise;
    const Counts counts = countsOf(s.points, s.triangles);
    CHECK(counts.at("small_components") == 1);
    CHECK(counts.at("lost_points") == 1);
    CHECK(counts.at("isolated_points") == 1);
    CHECK(counts.at("openings") == 3);
    CHECK(counts.count("holes") == 0);
}

TEST_CASE("inspection: fourteen triangles are a piece of their own") {
    const auto counts = [](Index side) {
        Sheet s = sheet(10);
        const Sheet other = sheet(side);  // 8, 18 triangles
        const auto first = static_cast<Index>(s.points.size());
        for (const Vec3& x : other.points.position) {
            s.points.position.push_back(x + Vec3(10.5, 0, 0));
            s.points.normal.push_back({0, 0, 1});
        }
        for (const Triangle& t : other.triangles)
            s.triangles.push_back({t.a + first, t.b + first, t.c + first});
        return countsOf(s.points, s.triangles);
    };
    CHECK(counts(3).at("small_components") == 1);
    CHECK(counts(4).count("small_components") == 0);
}

TEST_CASE("inspection: no mesh at all") {
    CHECK(inspectMesh({}, {}).empty());
    CHECK(countsOf(octahedron(), {}) == Counts{{"isolated_points", 6}});
}

TEST_CASE("inspection: every class has a name of its own and is found by it") {
    for (const FailureClass& each : failureClasses()) {
        CHECK(findFailureClass(each.name) == &each);
        CHECK_FALSE(each.meaning.empty());
    }
    CHECK(findFailureClass("dragons") == nullptr);
}

TEST_CASE("inspection: of a tangled mesh the first crossings are listed, and how many there are") {
    PointSet points;
    points.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto crossings = [&](std::size_t count) {
        const MeshInspection found = inspectWithTotals(points, Faces(count, {0, 1, 2}));
        const auto place = static_cast<std::size_t>(findFailureClass("intersecting_triangles") -
                                                    failureClasses().data());
        CHECK(isComplete(found.totals) == found.totals[place].all());
        CHECK(found.failures.size() >= found.totals[place].listed);
        return found.totals[place];
    };
    const ClassTotal all = crossings(20);
    CHECK(all.all());
    CHECK(amountText(all) == "190");
    const ClassTotal some = crossings(200);
    CHECK(some.exact);
    CHECK(amountText(some) == "first 10000 of 19900");
    const ClassTotal ended = crossings(3000);
    CHECK_FALSE(ended.exact);
    CHECK(amountText(ended).starts_with("first 10000 of at least "));
}

namespace {

/// A flat ring of triangles about a hole whose points lie at these radii, at equal angles.
Sheet around(const std::vector<double>& radius) {
    Sheet result;
    const auto n = static_cast<Index>(radius.size());
    const auto place = [&](Index i, double r) {
        const double angle = 2.0 * 3.14159265358979 * i / n;
        result.points.position.push_back({r * std::cos(angle), r * std::sin(angle), 0.0});
    };
    for (Index i = 0; i < n; ++i) place(i, radius[i]);
    for (Index i = 0; i < n; ++i) place(i, 7.0);
    result.points.normal.assign(result.points.size(), {0, 0, 1});
    for (Index i = 0; i < n; ++i) {
        const Index next = (i + 1) % n;
        result.triangles.push_back({i, n + i, n + next});
        result.triangles.push_back({i, n + next, next});
    }
    return result;
}

}  // namespace

TEST_CASE("inspection: a wide loop is a hole where most of its points see little of it") {
    // A star: every second point looks into a tip of 78 degrees.
    std::vector<double> star;
    for (int i = 0; i < 16; ++i) star.push_back(i % 2 == 0 ? 3.0 : 4.2);
    const Sheet s = around(star);
    CHECK(countsOf(s.points, s.triangles) == Counts{{"holes", 1}, {"openings", 1}});
}

TEST_CASE("inspection: the surface ends at a point that juts into an opening") {
    // Every third point sees 250 degrees of it, the others 126.
    std::vector<double> gear;
    for (int i = 0; i < 30; ++i) gear.push_back(i % 3 == 0 ? 4.15 : 5.0);
    const Sheet s = around(gear);
    CHECK(countsOf(s.points, s.triangles) == Counts{{"openings", 2}});
}

TEST_CASE("inspection: a narrow loop is an opening if it runs along walls") {
    Faces open = kOctahedron;
    open.erase(open.begin());
    PointSet points = octahedron();
    points.type.assign(6, kInterior);
    CHECK(countsOf(points, open) == Counts{{"holes", 1}});
    for (const Index p : {0, 2, 4}) points.type[p] = kPositiveX;
    CHECK(countsOf(points, open) == Counts{{"openings", 1}});
}

TEST_CASE("inspection: a loop runs along walls with single points off them, and most on them") {
    // Seven points make a loop too narrow for an opening.
    const auto found = [](const std::vector<Index>& off) {
        Sheet s = around(std::vector<double>(7, 3.0));
        s.points.type.assign(s.points.size(), kPositiveX);
        for (const Index p : off) s.points.type[p] = kInterior;
        return countsOf(s.points, s.triangles).count("holes") == 0;
    };
    CHECK(found({}));
    CHECK(found({0}));
    CHECK(found({0, 3}));
    CHECK_FALSE(found({0, 1}));
    CHECK_FALSE(found({0, 2, 4}));
}

TEST_CASE("inspection: sound means triangles, no fault, and that all were looked for") {
    const Sheet s = sheet(4);
    std::vector<ClassTotal> totals = inspectWithTotals(s.points, s.triangles).totals;
    REQUIRE(isSound(totals, s.triangles.size()));
    CHECK_FALSE(isSound(totals, 0));
    for (std::size_t i = 0; i < totals.size(); ++i) {
        std::vector<ClassTotal> other = totals;
        other[i].exact = false;
        CHECK_FALSE(isSound(other, 1));
        other = totals;
        ++other[i].total;
        CHECK(isSound(other, 1) == !failureClasses()[i].fault);
    }
}

TEST_CASE("inspection: a point that no mesh can have is not missing in it") {
    PointSet points = octahedron();
    points.position.push_back(points.position[0]);  // A copy.
    points.normal.push_back(points.normal[0]);
    points.position.push_back({0.5, 0.5, 0.5});  // No direction.
    points.normal.push_back(Vec3(0.0));
    CHECK(countsOf(points, kOctahedron).empty());
    points.normal.back() = {1, 0, 0};
    CHECK(countsOf(points, kOctahedron) == Counts{{"lost_points", 1}});
}

TEST_CASE("inspection: a hole that has become smaller is still there") {
    MeshFailure hole;
    hole.kind = findFailureClass("holes");
    hole.points = {1, 2, 3, 4, 5};
    MeshFailure smaller = hole;
    smaller.points = {2, 3, 9};
    CHECK(isStillThere(hole, {&smaller, 1}));
    smaller.points = {3, 8, 9};
    CHECK_FALSE(isStillThere(hole, {&smaller, 1}));
    MeshFailure unused;
    unused.kind = findFailureClass("lost_points");
    unused.points = {7};
    MeshFailure isolated = unused;
    isolated.kind = findFailureClass("isolated_points");
    CHECK(isStillThere(unused, {&isolated, 1}));
    CHECK_FALSE(isStillThere(unused, {&hole, 1}));
}
