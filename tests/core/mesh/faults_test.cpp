#include "spiraling_edge/mesh/faults.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

/// All intersections, by trying every pair.
std::vector<Fault> bruteIntersections(const PointSet& points, const Triangles& triangles) {
    const auto hasArea = [&](const Triangle& t) {
        const Vec3 n = glm::cross(points.position[t.b] - points.position[t.a],
                                  points.position[t.c] - points.position[t.a]);
        return t.a != t.b && t.b != t.c && t.c != t.a && glm::dot(n, n) > 0;
    };
    std::vector<Fault> found;
    for (Index i = 0; i < triangles.size(); ++i) {
        for (Index j = i + 1; j < triangles.size(); ++j) {
            if (!hasArea(triangles[i]) || !hasArea(triangles[j])) continue;
            if (trianglesShareMore(points.position, triangles[i], triangles[j])) {
                found.push_back({FaultKind::Intersecting, i, j});
            }
        }
    }
    return found;
}

/// All second layers, by trying every pair.
std::vector<Fault> bruteLayers(const PointSet& points, const Triangles& triangles) {
    std::vector<Fault> found;
    for (Index i = 0; i < triangles.size(); ++i) {
        const LayerShape shape = layerShape(points, triangles[i]);
        for (Index j = i + 1; j < triangles.size(); ++j) {
            if (isSecondLayer(points, triangles[i], shape, triangles[j],
                              layerShape(points, triangles[j]))) {
                found.push_back({FaultKind::SecondLayer, i, j});
            }
        }
    }
    return found;
}

std::vector<Fault> ofKind(const std::vector<Fault>& faults, FaultKind kind) {
    std::vector<Fault> found;
    for (const Fault& fault : faults) {
        if (fault.kind == kind) found.push_back(fault);
    }
    return found;
}

using Faults = std::vector<Fault>;

}  // namespace

TEST_CASE("faults: none on an octahedron with normals outwards") {
    PointSet points =
        pointsAt({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    points.normal = points.position;
    const Triangles triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                              {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    CHECK(findFaults(points, triangles).empty());
    CHECK(findFaults(points, Triangles{}).empty());
}

TEST_CASE("faults: none on a sphere, and none at its border") {
    const PointSet points = prepared(closedFamilies(0.5)[0].sample(1));
    const Run run = runAll(points, *paramsByName("robust"));
    CHECK(findFaults(points, run.state.mesh()).empty());
    Triangles open = run.state.mesh();
    open.resize(open.size() / 2);
    CHECK(findFaults(points, open).empty());
}

TEST_CASE("faults: each kind is found on two or three triangles") {
    using enum FaultKind;
    const PointSet fan = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
    const PointSet line = pointsAt({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}});
    const PointSet cross =
        pointsAt({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {2, 1, -1}, {1, 1, 1}});
    struct Row {
        const PointSet& points;
        Triangles triangles;
        FaultKind kind;
        Faults faults;
    };
    for (const Row& row :
         {Row{fan,
              {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}},
              NonManifoldEdge,
              {{NonManifoldEdge, 0, 1}, {NonManifoldEdge, 0, 2}}},
          {fan, {{0, 1, 2}, {0, 1, 3}}, InconsistentEdge, {{InconsistentEdge, 0, 1}}},
          {fan, {{0, 1, 2}, {0, 1, 3}}, Folded, {}},
          {fan, {{0, 1, 2}, {1, 0, 3}}, InconsistentEdge, {}},
          {line, {{0, 1, 2}}, Degenerate, {{Degenerate, 0, kNone}}},
          {line, {{0, 1, 3}, {1, 3, 3}}, Degenerate, {{Degenerate, 1, kNone}}},
          {cross, {{0, 1, 2}, {3, 4, 5}}, Intersecting, {{Intersecting, 0, 1}}}}) {
        CAPTURE(row.triangles);
        CAPTURE(static_cast<int>(row.kind));
        CHECK(ofKind(findFaults(row.points, row.triangles), row.kind) == row.faults);
    }
}

TEST_CASE("faults: a triangle against the sum of its normals, not against one of them") {
    PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    points.normal[0] = {0, 0, -1};
    CHECK(findFaults(points, Triangles{{0, 1, 2}}).empty());
    points.normal[1] = {0, 0, -1};
    CHECK(findFaults(points, Triangles{{0, 1, 2}}) == Faults{{FaultKind::Flipped, 0, kNone}});
}

TEST_CASE("faults: two triangles at an edge within ten degrees of each other are folded") {
    const auto foldedAt = [](double degrees) {
        const double angle = degrees * kPi / 180;
        const PointSet points =
            pointsAt({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {-std::cos(angle), 0, std::sin(angle)}}, {},
                     Vec3(0));
        const auto faults = findFaults(points, Triangles{{0, 1, 2}, {1, 0, 3}});
        CHECK(ofKind(faults, FaultKind::Intersecting).empty());
        return ofKind(faults, FaultKind::Folded);
    };
    CHECK(foldedAt(9.9) == Faults{{FaultKind::Folded, 0, 1}});
    CHECK(foldedAt(10.1).empty());
    CHECK(foldedAt(180).empty());
}

TEST_CASE("faults: folded flat is an intersection as well") {
    const PointSet points = pointsAt({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, 0.5, 0}});
    const auto counts = countFaults(findFaults(points, Triangles{{0, 1, 2}, {1, 0, 3}}));
    CHECK(counts[static_cast<std::size_t>(FaultKind::Folded)] == 1);
    CHECK(counts[static_cast<std::size_t>(FaultKind::Intersecting)] == 1);
}

TEST_CASE("faults: ordered by kind, triangle and other, each once") {
    Random random(3);
    PointSet points = pointsAt({});
    for (int i = 0; i < 30; ++i) points.position.push_back(random.inCube());
    points.normal.assign(30, Vec3(0, 0, 1));
    Triangles triangles;
    for (int i = 0; i < 60; ++i) {
        const auto any = [&] { return static_cast<Index>(random.below(30)); };
        triangles.push_back({any(), any(), any()});
    }
    const auto faults = findFaults(points, triangles);
    const auto less = [](const Fault& a, const Fault& b) {
        return std::tie(a.kind, a.triangle, a.other) < std::tie(b.kind, b.triangle, b.other);
    };
    CHECK(std::is_sorted(faults.begin(), faults.end(), less));
    CHECK(std::adjacent_find(faults.begin(), faults.end()) == faults.end());
    std::size_t total = 0;
    for (const std::size_t count : countFaults(faults)) {
        CHECK(count > 0);
        total += count;
    }
    CHECK(total == faults.size());
}

TEST_CASE("faults: the grid finds the intersections and layers that trying every pair finds") {
    std::size_t total = 0;
    std::size_t layers = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        Random random(seed);
        PointSet points = pointsAt({});
        Triangles triangles;
        const double size = random.between(0.05, 0.6);
        const Vec3 move = seed % 3 == 0 ? Vec3(1e6, -1e6, 1e5) : Vec3(0);
        for (Index i = 0; i < 150; ++i) {
            // Some span everything, or lie in one plane with others.
            const double reach = i % 40 == 0 ? 4.0 : size;
            const Vec3 center = random.inCube();
            for (int k = 0; k < 3; ++k) {
                Vec3 x = center + reach * random.inCube();
                if (seed % 4 == 0) x.z = i % 2;
                points.position.push_back(x + move);
            }
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            // Some have a corner in common with one made before.
            if (i > 0 && i % 5 == 0) triangles.back().a = static_cast<Index>(random.below(3 * i));
        }
        points.normal.assign(points.size(), Vec3(0, 0, 1));
        const Faults expected = bruteIntersections(points, triangles);
        total += expected.size();
        const Faults found = findFaults(points, triangles);
        CHECK_MESSAGE(ofKind(found, FaultKind::Intersecting) == expected, "seed ", seed);
        const Faults expectedLayers = bruteLayers(points, triangles);
        layers += expectedLayers.size();
        CHECK_MESSAGE(ofKind(found, FaultKind::SecondLayer) == expectedLayers, "seed ", seed);
    }
    CHECK(total > 2000);
    CHECK(layers > 2000);
}

TEST_CASE("faults: with a triangle made very often the search ends at its bound, and soon") {
    // Five billion pairs. Every second one is turned over, and without normals the order of the
    // corners tells the side: half of the pairs are second layers.
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, Vec3(0));
    Triangles triangles(100000, {0, 1, 2});
    for (std::size_t i = 0; i < triangles.size(); i += 2) triangles[i] = {0, 2, 1};
    const auto counts = countFaults(findFaults(points, triangles));
    CHECK(counts[static_cast<std::size_t>(FaultKind::Intersecting)] == kMaxPairs);
    CHECK(static_cast<double>(counts[static_cast<std::size_t>(FaultKind::SecondLayer)]) ==
          doctest::Approx(0.5 * kMaxPairs).epsilon(0.001));
    // Those about an edge grow with the triangles, not with their pairs.
    CHECK(counts[static_cast<std::size_t>(FaultKind::NonManifoldEdge)] == 99999);
}

TEST_CASE("faults: the search for pairs ends at its work limit and is marked incomplete") {
    // Narrow strips side by side around a diagonal: all boxes meet, no two triangles do, and none
    // lies over another.
    const auto strips = [](Index count) {
        const Vec3 along = Vec3(1, 1, 1);
        const Vec3 u = glm::normalize(Vec3(1, -1, 0));
        const Vec3 v = glm::normalize(Vec3(1, 1, -2));
        PointSet points = pointsAt({});
        Triangles triangles;
        for (Index i = 0; i < count; ++i) {
            const double angle = 6.283185307179586 * i / count;
            const Vec3 at = 0.3 * (std::cos(angle) * u + std::sin(angle) * v);
            const Vec3 aside = 1e-5 * (std::cos(angle) * v - std::sin(angle) * u);
            points.position.insert(points.position.end(), {at, at + along, at + along + aside});
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        points.normal.assign(points.size(), Vec3(0));
        return searchFaults(points, triangles);
    };
    const FaultSearch few = strips(300);
    CHECK(few.complete);
    CHECK(few.faults.empty());
    const FaultSearch many = strips(8000);
    CHECK_FALSE(many.complete);
    CHECK(many.work == kPairWork + 8000 * kPairWorkPerTriangle);
    CHECK(strips(8000).faults == many.faults);
}

TEST_CASE("faults: pairs in one plane, which take exact arithmetic, end the search sooner") {
    // All coplanar, and far from any axis.
    const auto tangled = [](Index count) {
        Random random(5);
        PointSet points = pointsAt({});
        Triangles triangles;
        for (Index i = 0; i < 3 * count; ++i) {
            const Vec3 x = random.inCube();
            points.position.emplace_back(x.x, x.y, 0.3 * x.x + 0.7 * x.y);
        }
        for (Index i = 0; i < count; ++i) triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        points.normal.assign(points.size(), Vec3(0));
        return searchFaults(points, triangles);
    };
    CHECK(tangled(100).complete);
    const FaultSearch ended = tangled(1500);
    CHECK_FALSE(ended.complete);
    CHECK_FALSE(ofKind(ended.faults, FaultKind::Intersecting).empty());
}

TEST_CASE("faults: a pair in one plane counts 2048 units more beyond 16 for each triangle") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const auto workOf = [&](std::size_t count) {
        return searchFaults(points, Triangles(count, {0, 1, 2})).work;
    };
    const std::uint64_t ofPair = workOf(2);
    CHECK(workOf(33) == 528 * ofPair);  // 16 pairs for each of 33.
    CHECK(workOf(40) == 780 * ofPair + (780 - 16 * 40) * 2048);
}

TEST_CASE("faults: a triangle over many cells crosses a small one like any other") {
    // The cells are as large as the many small triangles.
    std::vector<Vec3> position;
    Triangles triangles;
    for (int i = 0; i < 100; ++i) {
        const Vec3 x(0.05 * (i % 10), 0.05 * static_cast<int>(i / 10), 0);
        const auto first = static_cast<Index>(position.size());
        position.insert(position.end(), {x, x + Vec3(0.01, 0, 0), x + Vec3(0, 0.01, 0)});
        triangles.push_back({first, first + 1, first + 2});
    }
    // Upright through the first small one, and none other.
    const auto first = static_cast<Index>(position.size());
    position.insert(position.end(), {{0.002, 0.002, -9}, {0.002, 0.002, 9}, {-9, -9, 0}});
    triangles.push_back({first, first + 1, first + 2});
    const PointSet points = pointsAt(position);
    const std::vector<Fault> expected = bruteIntersections(points, triangles);
    CHECK(expected.size() == 1);
    CHECK(ofKind(findFaults(points, triangles), FaultKind::Intersecting) == expected);
}

TEST_CASE("faults: a triangle without area meets none, and none is folded onto it") {
    const PointSet points =
        pointsAt({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 1, -1}, {2, 1, 1}, {2, 1, 2}, {2, 0, 0}});
    // One through the inside of the first, and one at its edge 0 1.
    for (const Triangle& needle : {Triangle{3, 4, 5}, Triangle{1, 0, 6}}) {
        const std::vector<Fault> faults = findFaults(points, Triangles{{0, 1, 2}, needle});
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].kind == FaultKind::Degenerate);
    }
}
