#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/mesh/mesh_topology.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Points with normals away from the origin.
PointSet pointsAround(std::vector<Vec3> position) {
    PointSet points;
    for (const Vec3& x : position) {
        points.normal.push_back(glm::length(x) > 0 ? glm::normalize(x) : Vec3(0, 0, 1));
    }
    points.position = std::move(position);
    return points;
}
PointSet tetrahedron() { return pointsAround({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}); }
const Triangles kTetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

}  // namespace

TEST_CASE("mesh: a tetrahedron is a closed manifold of Euler number 2") {
    const MeshReport r = reportMesh(tetrahedron(), kTetrahedron);
    CHECK(r.closedManifold());
    CHECK(r.points == 4);
    CHECK(r.triangles == 4);
    CHECK(r.edges == 6);
    CHECK(r.usedPoints == 4);
    CHECK(r.eulerCharacteristic == 2);
    CHECK(r.components == 1);
    CHECK(r.boundaryLoops == 0);
    CHECK(r.flippedTriangles == 0);
}

TEST_CASE("mesh: nothing at all is not closed") {
    const MeshReport r = reportMesh(tetrahedron(), {});
    CHECK_FALSE(r.closedManifold());
    CHECK(r.unusedPoints == 4);
    CHECK(r.components == 0);
    CHECK(r.eulerCharacteristic == 0);
}

TEST_CASE("mesh: an open quad has one boundary loop of four edges") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}});
    const MeshReport r = reportMesh(points, Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(r.boundaryEdges == 4);
    CHECK(r.boundaryLoops == 1);
    CHECK(r.edges == 5);
    CHECK(r.eulerCharacteristic == 1);
    CHECK(r.unusedPoints == 1);
    CHECK(r.nonManifoldVertices == 0);
    CHECK_FALSE(r.closedManifold());
}

TEST_CASE("mesh: two triangles at one point are a bow tie") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}});
    const MeshReport r = reportMesh(points, Triangles{{0, 1, 2}, {0, 3, 4}});
    CHECK(r.nonManifoldVertices == 1);
    CHECK(r.nonManifoldEdges == 0);
    CHECK(r.components == 1);
}

TEST_CASE("mesh: three triangles on an edge") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
    const MeshReport r = reportMesh(points, Triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    CHECK(r.nonManifoldEdges == 1);
    CHECK(r.inconsistentEdges == 1);
}

TEST_CASE("mesh: two triangles that pass their edge the same way are inconsistent") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
    CHECK(reportMesh(points, Triangles{{0, 1, 2}, {1, 0, 3}}).inconsistentEdges == 0);
    const MeshReport r = reportMesh(points, Triangles{{0, 1, 2}, {0, 1, 3}});
    CHECK(r.inconsistentEdges == 1);
    CHECK(r.nonManifoldEdges == 0);
    Triangles turned = kTetrahedron;
    turned[0] = {0, 1, 2};
    CHECK_FALSE(reportMesh(tetrahedron(), turned).closedManifold());
}

TEST_CASE("mesh: a triangle against the normals of its corners is flipped") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(reportMesh(points, Triangles{{0, 1, 2}}).flippedTriangles == 0);
    CHECK(reportMesh(points, Triangles{{0, 2, 1}}).flippedTriangles == 1);
}

TEST_CASE("mesh: a corner twice or no area is degenerate") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}});
    CHECK(reportMesh(points, Triangles{{0, 1, 2}}).degenerateTriangles == 1);
    CHECK(reportMesh(points, Triangles{{0, 1, 1}}).degenerateTriangles == 1);
    CHECK(reportMesh(points, Triangles{{0, 1, 3}}).degenerateTriangles == 0);
}

TEST_CASE("mesh: components and loops are counted apart") {
    std::vector<Vec3> position;
    Triangles triangles;
    for (Index i = 0; i < 3; ++i) {
        const double x = 5.0 * i;
        position.insert(position.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const MeshReport r = reportMesh(pointsAt(position), triangles);
    CHECK(r.components == 3);
    CHECK(r.boundaryLoops == 3);
    CHECK(r.eulerCharacteristic == 3);
}

TEST_CASE("mesh: a ring of triangles has two boundary loops and Euler number 0") {
    std::vector<Vec3> position;
    Triangles triangles;
    for (Index i = 0; i < 6; ++i) {
        position.push_back(polar(60 * i, 1));
        position.push_back(polar(60 * i, 2));
        const Index a = 2 * i;
        const Index b = (2 * i + 2) % 12;
        triangles.push_back({a, a + 1, b});
        triangles.push_back({a + 1, b + 1, b});
    }
    const MeshReport r = reportMesh(pointsAt(position), triangles);
    CHECK(r.boundaryLoops == 2);
    CHECK(r.eulerCharacteristic == 0);
    CHECK(r.flippedTriangles == 0);
    CHECK(r.nonManifoldVertices == 0);
}

TEST_CASE("mesh: an edge is irregular unless two triangles pass it in opposite directions") {
    CHECK(MeshTopology(4, kTetrahedron).irregularEdges.empty());
    // 0-1 has three triangles, 1-2 two that pass it alike; the others have one each.
    const Triangles triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 5}};
    const MeshTopology mesh(6, triangles);
    CHECK(mesh.edges == 9);
    CHECK(mesh.irregularEdges.size() == 9);
    CHECK(mesh.irregularEdges[0].size() == 3);
    CHECK(std::count_if(mesh.irregularEdges.begin(), mesh.irregularEdges.end(), isInconsistent) ==
          2);
    CHECK(MeshTopology(3, Triangles{{0, 1, 2}}).irregularEdges.size() == 3);
}

TEST_CASE("mesh: components are counted over used points, and named by their least ones") {
    const MeshTopology mesh(8, Triangles{{1, 2, 3}, {3, 2, 4}, {7, 6, 5}, {5, 5, 6}});
    CHECK(mesh.components == 2);
    CHECK(mesh.usedPoints == 7);
    CHECK_FALSE(mesh.used[0]);
    CHECK(mesh.component == std::vector<Index>{0, 1, 1, 1, 1, 5, 5, 5});
    const MeshTopology empty(0, {});
    CHECK(empty.sides.empty());
    CHECK(empty.edges == 0);
    CHECK(empty.components == 0);
    CHECK(empty.nonManifoldPoints.empty());
}

TEST_CASE("mesh: sides are sorted by edge and then by triangle, whatever the order of triangles") {
    const Triangles triangles{{9, 4, 0}, {2, 7, 4}, {0, 4, 2}, {4, 9, 2}, {0, 2, 4}, {5, 6, 7}};
    const std::vector<TriangleSide> sides = sortedSides(triangles);
    CHECK(sides.size() == 3 * triangles.size());
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const auto key = [&](std::size_t k) {
            return std::tuple(sides[k].low, sides[k].high, sides[k].triangle);
        };
        CHECK(key(i - 1) < key(i));
    }
    for (const TriangleSide& side : sides) {
        const auto [a, b, c] = triangles[side.triangle];
        const auto [u, v] =
            side.ascending ? std::pair(side.low, side.high) : std::pair(side.high, side.low);
        CHECK(((u == a && v == b) || (u == b && v == c) || (u == c && v == a)));
    }
    CHECK(sortedSides({}).empty());
}

TEST_CASE(
    "mesh: sides, and the faults of shapes and edges, are the same on any number of threads") {
    // A bent sheet, large enough for every thread to have a part of it. Every second triangle faces
    // down, so that every edge inside has a fault, and one edge has twenty more triangles.
    constexpr Index kSide = 260;
    PointSet points;
    for (Index i = 0; i < kSide * kSide; ++i) {
        const double x = i % kSide;
        points.position.emplace_back(x, static_cast<double>(i / kSide), 0.01 * x * x);
    }
    points.normal.assign(points.size(), Vec3(0, 0, 1));
    Triangles triangles;
    for (Index y = 0; y + 1 < kSide; ++y) {
        for (Index x = 0; x + 1 < kSide; ++x) {
            const Index p = y * kSide + x;
            triangles.push_back({p, p + 1, p + kSide + 1});
            triangles.push_back({p, p + kSide, p + kSide + 1});
        }
    }
    const Index middle = kSide * kSide / 2;
    for (Index i = 0; i < 20; ++i) triangles.push_back({middle, middle + 1, 3 * i});
    const std::vector<TriangleSide> one = sortedSides(triangles, 1);
    const FaultSearch faults = searchFaults(points, triangles, one, 1);
    CHECK(faults.faults.size() > 200000);
    for (const unsigned threads : {2U, 3U, 7U}) {
        CAPTURE(threads);
        const std::vector<TriangleSide> several = sortedSides(triangles, threads);
        const auto areSame = [](const TriangleSide& a, const TriangleSide& b) {
            return a.sameEdge(b) && a.triangle == b.triangle && a.ascending == b.ascending;
        };
        CHECK(std::equal(one.begin(), one.end(), several.begin(), several.end(), areSame));
        const FaultSearch found = searchFaults(points, triangles, one, threads);
        CHECK(found.faults == faults.faults);
        CHECK(found.work == faults.work);
    }
}
