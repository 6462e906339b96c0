#include "spiraling_edge/mesh/mesh_compare.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

struct Made {
    PointSet points = prepared(findScene("torus")->build());
    std::vector<Triangle> mesh = reconstruct(points, paper()).state.mesh();
};

template <typename T>
void shuffle(std::vector<T>& list, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
}

/// The mesh as another program would write it: vertices and triangles in another order, each
/// triangle from another corner on, numbers rounded to float.
PointFile foreign(const Made& made) {
    std::vector<Index> order(made.points.size());
    std::iota(order.begin(), order.end(), Index{0});
    shuffle(order, 3);
    std::vector<Index> placeOf(order.size());
    PointFile file;
    for (std::size_t i = 0; i < order.size(); ++i) {
        placeOf[order[i]] = static_cast<Index>(i);
        const Vec3& x = made.points.position[order[i]];
        file.position.emplace_back(static_cast<float>(x.x), static_cast<float>(x.y),
                                   static_cast<float>(x.z));
    }
    Random random(5);
    for (const Triangle& t : made.mesh) {
        const Triangle u{placeOf[t.a], placeOf[t.b], placeOf[t.c]};
        const std::size_t turn = random.below(3);
        file.faces.push_back(turn == 0   ? u
                             : turn == 1 ? Triangle{u.b, u.c, u.a}
                                         : Triangle{u.c, u.a, u.b});
    }
    shuffle(file.faces, 7);
    return file;
}

}  // namespace

TEST_CASE("mesh comparison: a mesh in another order, written as floats, is the same") {
    const Made made;
    const MatchedMesh matched = matchMesh(made.points.position, foreign(made));
    CHECK(matched.unmatchedVertices.empty());
    const MeshDifference found = compareMeshes(made.points.position, made.mesh, matched.triangles);
    CHECK(found.same());
    CHECK(found.both == made.mesh.size());
    CHECK(found.reversed + found.onlyA + found.onlyB == 0);
}

TEST_CASE("mesh comparison: a vertex off by more than the tolerance is a stranger") {
    const Made made;
    PointFile file = foreign(made);
    Vec3 low = made.points.position[0];
    Vec3 high = low;
    for (const Vec3& x : made.points.position) {
        low = glm::min(low, x);
        high = glm::max(high, x);
    }
    const double tolerance = kSamePointTolerance * glm::length(high - low);
    file.position[file.faces[0].a].x += 3.0 * tolerance;
    file.position[file.faces[10].b].y += 0.4 * tolerance;
    const MatchedMesh matched = matchMesh(made.points.position, file);
    REQUIRE(matched.unmatchedVertices.size() == 1);
    CHECK(matched.unmatchedNumbers[0] == file.faces[0].a);
    CHECK(matched.triangles[0].a == made.points.size());
    std::vector<Vec3> position = made.points.position;
    position.push_back(matched.unmatchedVertices[0]);
    const MeshDifference found = compareMeshes(position, made.mesh, matched.triangles);
    REQUIRE(found.regions.size() == 1);
    // All triangles at that vertex, and nothing else.
    const auto around = std::count_if(file.faces.begin(), file.faces.end(), [&](const Triangle& t) {
        const Index v = file.faces[0].a;
        return t.a == v || t.b == v || t.c == v;
    });
    CHECK(found.onlyA == static_cast<std::size_t>(around));
    CHECK(found.onlyB == static_cast<std::size_t>(around));
}

TEST_CASE("mesh comparison: what was taken out, turned, doubled or added is found where it is") {
    const Made made;
    const std::vector<Vec3>& position = made.points.position;
    std::vector<Triangle> other = made.mesh;
    SUBCASE("taken out") {
        other.erase(other.begin() + 100);
        const MeshDifference found = compareMeshes(position, made.mesh, other);
        CHECK(found.onlyA == 1);
        CHECK(found.onlyB == 0);
        CHECK(found.a[100] == Match::Missing);
        REQUIRE(found.regions.size() == 1);
        CHECK(found.regions[0].inA == std::vector<Index>{100});
        CHECK(found.regions[0].inB.empty());
        const Triangle& t = made.mesh[100];
        std::vector<Index> corners{t.a, t.b, t.c};
        std::sort(corners.begin(), corners.end());
        CHECK(found.regions[0].points == corners);
    }
    SUBCASE("turned: the same corners, the other side") {
        std::swap(other[100].b, other[100].c);
        const MeshDifference found = compareMeshes(position, made.mesh, other);
        CHECK(found.reversed == 1);
        CHECK(found.onlyA + found.onlyB == 0);
        CHECK(found.a[100] == Match::Reversed);
        CHECK(found.b[100] == Match::Reversed);
        CHECK_FALSE(found.same());
    }
    SUBCASE("there twice") {
        other.push_back(made.mesh[100]);
        const MeshDifference found = compareMeshes(position, made.mesh, other);
        CHECK(found.both == made.mesh.size());
        CHECK(found.onlyB == 1);
        CHECK(found.b.back() == Match::Missing);
    }
    SUBCASE("a diagonal the other way round, and a triangle elsewhere") {
        // Two triangles over a common edge, on the other diagonal.
        std::size_t j = 1;
        const Triangle t = other[0];
        const auto cornerOff = [&](const Triangle& u) {  // of u, if it has the edge b -> a
            if (u.a == t.b && u.b == t.a) return u.c;
            if (u.b == t.b && u.c == t.a) return u.a;
            if (u.c == t.b && u.a == t.a) return u.b;
            return kNone;
        };
        while (cornerOff(other[j]) == kNone) ++j;
        const Index x = cornerOff(other[j]);
        other[0] = {t.c, t.a, x};
        other[j] = {t.c, x, t.b};
        // Far from it.
        std::size_t far = 0;
        for (std::size_t i = 0; i < other.size(); ++i) {
            const auto distance = [&](std::size_t k) {
                return glm::length(position[made.mesh[k].a] - position[t.a]);
            };
            if (distance(i) > distance(far)) far = i;
        }
        other.erase(other.begin() + static_cast<std::ptrdiff_t>(far));
        const MeshDifference found = compareMeshes(position, made.mesh, other);
        REQUIRE(found.regions.size() == 2);
        CHECK(found.regions[0].inA.size() == 2);
        CHECK(found.regions[0].inB.size() == 2);
        CHECK(found.regions[0].points.size() == 4);
        CHECK(found.regions[1].inA == std::vector<Index>{static_cast<Index>(far)});
        CHECK(glm::length(found.regions[0].place - position[t.a]) <= 2 * found.regions[0].radius);
    }
}

TEST_CASE("mesh comparison: of points at one place, that of the same number is the vertex") {
    PointFile file;
    file.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    file.faces = {{0, 1, 2}, {0, 3, 2}};
    const MatchedMesh matched = matchMesh(file.position, file);
    CHECK(matched.triangles == file.faces);
    // With fewer points the lower number is used.
    PointFile shorter = file;
    shorter.position = {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
    shorter.faces = {{1, 0, 2}};
    CHECK(matchMesh(file.position, shorter).triangles == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("mesh comparison: a set gives the counterpart of each triangle") {
    const TriangleSet set(std::vector<Triangle>{{3, 1, 2}, {4, 5, 6}});
    CHECK(set.find({1, 2, 3}) == Match::Same);
    CHECK(set.find({2, 1, 3}) == Match::Reversed);
    CHECK(set.find({6, 4, 5}) == Match::Same);
    CHECK(set.find({1, 2, 4}) == Match::Missing);
    CHECK(TriangleSet{}.find({1, 2, 3}) == Match::Missing);
}

TEST_CASE("mesh comparison: no points, no triangles") {
    CHECK(compareMeshes({}, {}, {}).same());
    const MatchedMesh matched = matchMesh({}, PointFile{});
    CHECK(matched.triangles.empty());
}
