#include "spiraling_edge/run/reconstruct.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "spiraling_edge/geometry/z_curve.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/random_points.h"

using namespace se;
using namespace se::test;

namespace {

Params paramsOf(const char* name) { return paramsByName(name).value(); }

void shuffle(std::vector<Index>& values, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t i = values.size(); i > 1; --i)
        std::swap(values[i - 1], values[random.below(i)]);
}

/// A flat square of side * side points at distance 1, in an order by chance; every list holds the
/// eight around.
PointSet scatteredSquare(Index side) {
    std::vector<Index> at(std::size_t{side} * side);
    for (Index i = 0; i < at.size(); ++i) at[i] = i;
    shuffle(at, 1);
    PointSet points;
    points.position.resize(at.size());
    points.normal.assign(at.size(), Vec3(0, 0, 1));
    points.type.assign(at.size(), kInterior);
    std::vector<Index> placeOf(at.size());
    for (Index i = 0; i < at.size(); ++i) {
        points.position[at[i]] = Vec3(i % side, i / side, 0);
        placeOf[at[i]] = i;
    }
    constexpr std::pair<int, int> kSteps[] = {{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                              {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    for (Index p = 0; p < at.size(); ++p) {
        const int x = static_cast<int>(placeOf[p] % side);
        const int y = static_cast<int>(placeOf[p] / side);
        std::vector<Index> list;
        for (const auto& [dx, dy] : kSteps) {
            const bool inside = x + dx >= 0 && y + dy >= 0 && x + dx < static_cast<int>(side) &&
                                y + dy < static_cast<int>(side);
            if (inside)
                list.push_back(at[static_cast<Index>(y + dy) * side + static_cast<Index>(x + dx)]);
        }
        points.neighbors.append(list);
    }
    return points;
}

/// Steps both runs together: at every pivot the same point, ring length and triangles.
void checkSameSteps(const PointSet& points, const Params& params) {
    const Renumbered renumbered = renumberAlongZCurve(points);
    REQUIRE(validate(renumbered.points).ok());
    Stepper plain(points, params);
    Stepper other(renumbered.points, params);
    std::size_t triangles = 0;
    while (plain.stepPivot()) {
        REQUIRE(other.stepPivot());
        const State& a = plain.state();
        const State& b = other.state();
        REQUIRE(a.phase == b.phase);
        REQUIRE(a.counters == b.counters);
        REQUIRE(a.triangles.size() == b.triangles.size());
        for (; triangles < a.triangles.size(); ++triangles) {
            const Triangle& t = b.triangles[triangles];
            const Triangle back{renumbered.original[t.a], renumbered.original[t.b],
                                renumbered.original[t.c]};
            REQUIRE(a.triangles[triangles] == back);
        }
        if (a.phase != Phase::Pivot) continue;
        REQUIRE(a.rings.point(a.pivot.pivot) == renumbered.original[b.rings.point(b.pivot.pivot)]);
    }
    CHECK_FALSE(other.stepPivot());
    State back = other.takeState();
    restoreIndices(renumbered, back);
    CHECK(stateHash(back) == stateHash(plain.state()));
    CHECK(back.mesh() == plain.state().mesh());
    CHECK(back.status == plain.state().status);
}

}  // namespace

TEST_CASE("reconstruct: the rules of the paper make the same mesh of points of any size") {
    for (const char* name : {"sphere", "torus", "grid"}) {
        CAPTURE(name);
        PointFile file = findScene(name)->build();
        const auto meshOf = [&] {
            const PointSet points = prepare(file, {}).value().points;
            return reconstruct(points, paramsOf("paper")).state.mesh();
        };
        const std::vector<Triangle> usual = meshOf();
        const std::vector<Vec3> given = file.position;
        for (const int power : {100, 200, 332, 498, -100, -200, -332, -498}) {
            CAPTURE(power);
            for (std::size_t p = 0; p < given.size(); ++p)
                file.position[p] = std::ldexp(1.0, power) * given[p];
            CHECK(meshOf() == usual);
        }
    }
}

TEST_CASE("renumbering: a run takes the same steps, whatever the rules") {
    for (const Family& family : closedFamilies()) {
        CAPTURE(family.name);
        const PointSet points = prepared(family.sample(3));
        for (const char* rules : {"paper", "robust"}) checkSameSteps(points, paramsOf(rules));
    }
}

TEST_CASE("renumbering: a run takes the same steps on points that no surface gave") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        checkSameSteps(randomPoints(seed), paramsOf("robust"));
    }
}

TEST_CASE("renumbering: seeds are looked for in the old order") {
    // Two triangles far apart; the one named first is taken first, wherever the curve begins.
    PointSet points;
    for (const double x : {100.0, 0.0}) {
        for (const Vec3& corner : {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 1, 0)}) {
            points.position.push_back(corner);
            points.normal.emplace_back(0, 0, 1);
            points.type.push_back(kInterior);
        }
    }
    for (const Index first : {0U, 3U}) {
        for (Index p = first; p < first + 3; ++p) {
            std::vector<Index> list;
            for (Index q = first; q < first + 3; ++q)
                if (q != p) list.push_back(q);
            points.neighbors.append(list);
        }
    }
    const Renumbered renumbered = renumberAlongZCurve(points);
    CHECK(renumbered.original.front() == 3);
    CHECK(renumbered.original[renumbered.points.inOrder(0)] == 0);
    checkSameSteps(points, Params{});
}

TEST_CASE("reconstruct: many scattered points give the state of a plain run") {
    const PointSet points = scatteredSquare(320);
    Stepper plain(points, Params{});
    plain.run();
    const Reconstruction made = reconstruct(points, Params{});
    CHECK(made.reason == StopReason::Finished);
    CHECK(stateHash(made.state) == stateHash(plain.state()));
    CHECK(made.state.status == plain.state().status);
}

TEST_CASE("reconstruct: ends when the condition holds, and not before") {
    const PointSet points = scatteredSquare(20);
    const auto ended =
        reconstruct(points, Params{}, [](const State& s) { return s.counters.pivots == 7; });
    CHECK(ended.reason == StopReason::Condition);
    CHECK(ended.state.counters.pivots == 7);
    CHECK(reconstruct(points, Params{}, [](const State&) { return false; }).reason ==
          StopReason::Finished);
}

TEST_CASE("the order of the Z-curve: every point once, near ones together, none finite last") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double most = std::numeric_limits<double>::max();
    std::vector<Vec3> corners{{nan, 0, 0}, {1, 1, 1}, {0, 0, 0}, {1, 1, 0}, {0, 0, 1},
                              {1, 0, 0},   {0, 1, 0}, {1, 0, 1}, {0, 1, 1}};
    // x turns fastest, z slowest: a cube's corners as binary numbers.
    CHECK(zCurveOrder(corners) == std::vector<Index>{2, 5, 6, 3, 4, 7, 8, 1, 0});
    for (Vec3& c : corners) c = (c - 0.5) * most;
    CHECK(zCurveOrder(corners) == std::vector<Index>{2, 5, 6, 3, 4, 7, 8, 1, 0});
    CHECK(zCurveOrder(std::vector<Vec3>(3, Vec3(5.0))) == std::vector<Index>{0, 1, 2});
    CHECK(zCurveOrder({}).empty());
    // Along a Gray-code curve each step goes along one axis.
    const std::vector<Index> order = grayCurveOrder(corners);
    REQUIRE(order.size() == corners.size());
    for (std::size_t i = 1; i < 8; ++i) {
        const Vec3 step = corners[order[i]] - corners[order[i - 1]];
        CHECK((step.x != 0.0) + (step.y != 0.0) + (step.z != 0.0) == 1);
    }
    CHECK(order.back() == 0);
    // What is not finite comes last in any place, as on the Z-curve.
    const std::vector<Vec3> halfway{{nan, 0, 0}, {0, 0, 0.51}, {1, 1, 1}, {0, 0, 0}};
    CHECK(grayCurveOrder(halfway).back() == 0);
}
