/// Beyond the paper, after the last pivot: flip (docs/robust.md).
#include <doctest/doctest.h>

#include <set>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/faults.h"
#include "support/clouds.h"
#include "support/open_surfaces.h"
#include "support/repair_mesh.h"

using namespace se;
using namespace se::test;

namespace {

std::size_t flipAll(const PointSet& points, RepairState& m) {
    std::size_t count = 0;
    while (flipNext(points, RobustThresholds{}, m)) {
        ++count;
        CHECK(manifoldFault(m) == "");
    }
    return count;
}

}  // namespace

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

TEST_CASE("flip: none where the diagonal is better, or the other one would be a fault") {
    const std::vector<Vec3> rhombus{{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}};
    std::vector<Vec3> with = rhombus;
    with.insert(with.end(), {{1, 5, 0}, {-1, 5, 0}});
    struct Row {
        const char* what;
        std::vector<Vec3> position;
        Triangles triangles;
    };
    for (const Row& row :
         {Row{"the better diagonal", {{-1, 0, 0}, {0, -3, 0}, {1, 0, 0}, {0, 3, 0}}, kSquare},
          {"an exact square", square(), kSquare},
          {"a ridge of 60 degrees", {{-3, 0, 0.6}, {0, -1, 0}, {3, 0, 0.6}, {0, 1, 0}}, kSquare},
          {"a dart, which is not convex", {{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}}, kSquare},
          {"a thin tetrahedron, which has the other diagonal",
           rhombus,
           {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {2, 1, 3}}},
          {"a point of two fans", with, {{0, 1, 2}, {0, 2, 3}, {3, 4, 5}}}}) {
        CAPTURE(row.what);
        RepairState m = beginRepair(row.position.size(), row.triangles);
        CHECK(flipAll(flatPoints(row.position), m) == 0);
    }
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

TEST_CASE(
    "flip: a narrow triangle that stands on a flat surface is laid down, if it is flat then") {
    // 2 stands over the middle of the edge 0 1.
    const auto flips = [](const Vec3& x) {
        const PointSet points = flatPoints({{-1, 0, 0}, {1, 0, 0}, x, {0, -1, 0}});
        RepairState m = beginRepair(4, {{0, 1, 2}, {1, 0, 3}});
        return flipAll(points, m);
    };
    CHECK(flips({0, 0.05, 0.2}) == 1);
    // As narrow as may be, and then at 32 degrees.
    CHECK(flips({0, 0.1, 0.33}) == 0);
}

namespace {

/// A steep valley along the edge 0 1, which a flip makes a ridge along 2 3, with more triangles at
/// its points.
struct Valley {
    PointSet points;
    RepairState repair;
};
Valley valleyWith(const std::vector<Vec3>& more, const Triangles& others) {
    std::vector<Vec3> position{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0.8}, {0, -1, 0.8}};
    position.insert(position.end(), more.begin(), more.end());
    Triangles triangles{{0, 1, 2}, {1, 0, 3}};
    triangles.insert(triangles.end(), others.begin(), others.end());
    Valley valley{flatPoints(position), beginRepair(position.size(), triangles)};
    valley.repair.queue = std::vector<HalfEdge>{0};
    return valley;
}
bool flips(Valley& valley) {
    return flipNext(valley.points, RobustThresholds{}, valley.repair).has_value();
}

}  // namespace

TEST_CASE("flip: an edge whose triangles are in conflict with another, if that ends it") {
    Valley alone = valleyWith({}, {});
    CHECK_FALSE(flips(alone));
    // 0 4 5 is upright; it cuts the valley and stays below the ridge.
    const std::vector<Vec3> more{{0.2, 0.4, -0.5}, {0.2, 0.4, 0.5}};
    Valley cut = valleyWith(more, {{0, 2, 4}, {0, 4, 5}});
    CHECK(flips(cut));
    // A triangle takes part in four such flips, so that they end.
    for (const int before : {3, 4}) {
        Valley often = valleyWith(more, {{0, 2, 4}, {0, 4, 5}});
        often.repair.conflictFlips.resize(4, static_cast<std::uint8_t>(before));
        CHECK(flips(often) == (before < 4));
    }
}

TEST_CASE("flip: an edge beside which a triangle is folded, which leaves fewer faults of shape") {
    // 2 1 4 lies close under 0 1 2.
    Valley folds = valleyWith({{-0.2, 0.3, 0.22}}, {{2, 1, 4}});
    // So that fewer conflicts are no reason.
    folds.repair.conflictFlips.resize(3, 4);
    CHECK(flips(folds));
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
