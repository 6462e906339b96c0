/// The triangles near a box are found after any changes, also after those of a journal were undone.
#include "spiraling_edge/stepper/robust/mesh_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "spiraling_edge/geometry/second_layer.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

namespace {

/// Points in a cube at `offset`, of this extent.
PointSet crowd(std::size_t count, double extent, const Vec3& offset) {
    std::mt19937 random(3);
    const auto coordinate = [&] { return extent * static_cast<double>(random() % 100000) / 1e5; };
    std::vector<Vec3> position;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = coordinate();
        const double y = coordinate();
        position.push_back(offset + Vec3(x, y, coordinate()));
    }
    return pointsAt(position);
}

/// Three points, the last two near the first one.
Triangle someTriangle(const PointSet& points, std::mt19937& random) {
    const auto a = static_cast<Index>(random() % points.size());
    std::vector<std::pair<double, Index>> others;
    for (Index p = 0; p < points.size(); ++p) {
        if (p != a) others.emplace_back(glm::distance(points.position[p], points.position[a]), p);
    }
    std::sort(others.begin(), others.end());
    const std::size_t first = random() % 9;
    return {a, others[first].second, others[first + 1 + random() % 9].second};
}

/// True if the tree visits each triangle that conflict() holds for with one of the triangles.
bool findsConflicts(const PointSet& points, const MeshTree& tree,
                    const std::vector<Triangle>& triangles) {
    for (const Triangle& mine : triangles) {
        const ShapedTriangle shaped(points, mine);
        std::vector<std::size_t> visited(triangles.size());
        tree.anyNear(conflictBox(shaped.box, shaped.shape), [&](Index t) {
            REQUIRE(t < triangles.size());
            ++visited[t];
            return false;
        });
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (visited[t] > 1) return false;
            if (visited[t] == 0 && conflict(points, mine, triangles[t])) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("Mesh tree: finds all triangles in conflict, each once, after any changes") {
    struct Place {
        double extent;
        Vec3 offset;
    };
    for (const Place& place : {Place{1.0, Vec3(0.0)}, Place{1e-3, Vec3(500000, 5400000, 300)},
                               Place{1e-60, Vec3(0.0)}, Place{1e90, Vec3(0.0)}}) {
        CAPTURE(place.extent);
        const PointSet points = crowd(300, place.extent, place.offset);
        std::mt19937 random(7);
        std::vector<Triangle> triangles;
        for (int i = 0; i < 200; ++i) triangles.push_back(someTriangle(points, random));
        MeshTree tree(points, triangles);
        CHECK(findsConflicts(points, tree, triangles));
        for (int i = 0; i < 600; ++i) {
            const auto t = static_cast<Index>(random() % triangles.size());
            if (i % 3 == 0) {
                triangles.push_back(someTriangle(points, random));
                tree.put(static_cast<Index>(triangles.size() - 1), triangles.back());
            } else if (i % 3 == 1) {
                triangles[t] = someTriangle(points, random);
                tree.put(t, triangles[t]);
            } else {
                triangles[t] = triangles.back();
                tree.put(t, triangles[t]);
                triangles.pop_back();
                tree.remove(static_cast<Index>(triangles.size()));
            }
        }
        CHECK(findsConflicts(points, tree, triangles));
    }
}

TEST_CASE("Mesh tree: it is worn once many triangles were added, but not by those that change") {
    const PointSet points = crowd(300, 1.0, Vec3(0.0));
    std::mt19937 random(7);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 200; ++i) triangles.push_back(someTriangle(points, random));
    MeshTree tree(points, triangles);
    for (int i = 0; i < 5; ++i) {
        for (Index t = 0; t < 200; ++t) tree.put(t, triangles[t]);
    }
    CHECK_FALSE(tree.isWorn());
    for (Index t = 200; t < 400; ++t) tree.put(t, triangles[t - 200]);
    CHECK(tree.isWorn());
}

TEST_CASE("Mesh tree: a mesh without triangles has none near") {
    const PointSet points = crowd(5, 1.0, Vec3(0.0));
    MeshTree tree(points, {});
    const auto isVisited = [&] {
        return tree.anyNear(boxOf(points, {0, 1, 2}), [](Index) { return true; });
    };
    CHECK_FALSE(isVisited());
    tree.put(0, {0, 1, 2});
    CHECK(isVisited());
    tree.remove(0);
    CHECK_FALSE(isVisited());
}

TEST_CASE("Conflicts are those of the present mesh, also after changes were undone and redone") {
    // Two triangles that cross at x = 1; then one of them moves aside.
    const PointSet points = flatPoints(
        {{0, 0, 0}, {2, 0, 0}, {1, 1, 1.2}, {1, 0.4, -1}, {1.2, 0.4, 2}, {0.8, 0.4, 2}, {9, 9, 9}});
    RepairState m = beginRepair(7, {{0, 1, 2}, {3, 4, 5}});
    m.beginJournal();
    const RepairPlace crossing = m.place();
    CHECK(conflictsOf(points, m, m.triangles[0]) == std::vector<Index>{0, 1});
    m.setTriangle(1, {4, 5, 6});
    const RepairPlace apart = m.place();
    CHECK(conflictsOf(points, m, m.triangles[0]) == std::vector<Index>{0});
    m.moveTo(crossing);
    CHECK(conflictsOf(points, m, m.triangles[0]) == std::vector<Index>{0, 1});
    m.moveTo(apart);
    CHECK(conflictsOf(points, m, m.triangles[0]) == std::vector<Index>{0});
    m.popTriangle();
    m.moveTo(crossing);
    CHECK(conflictsOf(points, m, m.triangles[0]) == std::vector<Index>{0, 1});
}
