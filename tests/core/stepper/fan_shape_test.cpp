/// Rules beyond the paper on the shape of a fan and on other parts of the mesh in its place. Each
/// on the least input that needs it: with the rule, and without.
#include <doctest/doctest.h>

#include <cmath>

#include "fan_scene.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

// ---- nocross ------------------------------------------------------------------------------------

TEST_CASE("nocross: a spoke across a ring edge nearby is not made") {
    // The step 7 -> 6 of a stacked ring lies between p and 5, its finished side towards p.
    const auto run = [](const Params& params) {
        Rig rig(underHalf({{0, 2, 0}, {-0.5, 1, 0}, {0.5, 1, 0}, {0, 3, 0}}), params);
        rig.list(0, {5, 6, 7}).stacked({7, 6, 8}).ring(kRing).pivot();
        return std::pair(rig.newTriangles(), objections(rig));
    };
    CHECK(run(paper()).first == kWith5);
    const auto [made, found] = run(paperBut(&RobustRules::noCross));
    CHECK(made == kWithout5);
    CHECK(found == Verdicts{Verdict::Crosses});
}

TEST_CASE("nocross: a ring step is found from either of its points, if it is an edge") {
    const auto made = [](const Points& list, bool open) {
        Rig rig(underHalf({{0, 2, 0}, {-0.9, 1, 0}, {0.9, 1, 0}, {0, 3, 0}}),
                paperBut(&RobustRules::noCross));
        rig.list(0, list).stacked({7, 6, 8});
        if (open) rig.open(7);
        rig.ring(kRing).pivot();
        return rig.newTriangles();
    };
    CHECK(made({5, 6}, false) == kWithout5);
    CHECK(made({5, 7}, false) == kWithout5);
    CHECK(made({5, 6, 7}, true) == kWith5);
}

TEST_CASE("nocross: a rim edge across a ring edge nearby is not made") {
    // The tip 7 of a stacked ring lies between 5 and 6, its finished side around it.
    const std::vector<Vec3> points =
        underHalf({{0.9, 1.2, 0}, {-0.9, 1.2, 0}, {0, 0.9, 0}, {0.2, 3, 0}, {-0.2, 3, 0}});
    const auto run = [&](const Params& params) {
        Rig rig(points, params);
        rig.list(0, {5, 6, 7}).stacked({7, 9, 8}).ring(kRing).pivot();
        return std::pair(rig.newTriangles(), objections(rig));
    };
    CHECK(run(paper()).first == kWith5And6);
    const auto [made, found] = run(paperBut(&RobustRules::noCross));
    CHECK(made == kWith5);
    CHECK(found == Verdicts{Verdict::Crosses});
}

TEST_CASE("nocross: edges that only share a point with the fan do not cross it") {
    Rig rig(underHalf({{0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}}), paperBut(&RobustRules::noCross));
    rig.list(0, {5, 6, 7}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
    CHECK(objections(rig).empty());
    CHECK_FALSE(rig.newTriangles().empty());
}

// ---- nofold -------------------------------------------------------------------------------------

TEST_CASE("nofold: a triangle against the normal of a corner is not made") {
    const auto made = [](const Vec3& normal, const Params& params) {
        Rig rig(underHalf({{0, 1, 0}}), params);
        rig.normal(5, normal).list(0, {5}).ring(kRing).pivot();
        if (rig.newTriangles() != kWith5) {
            CHECK(objections(rig) == Verdicts{Verdict::AgainstNormal});
            CHECK(rig.all<GuardEvidence>()[0].dropped == 5);
        }
        return rig.newTriangles();
    };
    const Params fold = paperBut(&RobustRules::noFold);
    CHECK(made({0, 0, -1}, paper()) == kWith5);
    CHECK(made({0, 0, -1}, fold) == kWithout5);
    CHECK(made({1, 0, -0.01}, fold) == kWithout5);
    CHECK(made({1, 0, 0.01}, fold) == kWith5);
}

TEST_CASE("nofold: a triangle within 30 degrees of the old one across an edge is not made") {
    // The old triangle has the ring step 1 -> 0; in projection along it, the two are `degrees`
    // apart.
    const auto made = [](double degrees, const Params& params) {
        const Vec3 in = polar(101.3);  // Across the step, towards 5.
        const double angle = degrees * kPi / 180;
        const Vec3 old = 0.5 * polar(11.3) + std::cos(angle) * in + Vec3(0, 0, std::sin(angle));
        Rig rig(overHalf({{0, 1, 0}, old}), params);
        rig.mesh({{1, 0, 6}}).list(0, {5}).ring(kRing).pivot();
        return rig.newTriangles();
    };
    const Params fold = paperBut(&RobustRules::noFold);
    CHECK(made(5, paper()) == kWith5);
    CHECK(made(5, fold).empty());
    CHECK(made(170, fold) == kWith5);
    CHECK(made(60, fold) == kWith5);
}

TEST_CASE("nofold: the same for the last triangle of the fan") {
    const auto made = [](double height, const Params& params) {
        // 6 lies over 0, 5, 2, across the step 0 -> 2.
        Rig rig(overHalf({{0, 1, 0}, {-0.4, 0.9, height}}), params);
        rig.mesh({{0, 2, 6}}).list(0, {5}).ring(kRing).pivot();
        return rig.newTriangles();
    };
    CHECK(made(0.05, paper()) == kWith5);
    CHECK(made(0.05, paperBut(&RobustRules::noFold)).empty());
    CHECK(made(5.0, paperBut(&RobustRules::noFold)) == kWith5);
}

TEST_CASE("nofold: the triangle that folds over is reported") {
    Rig rig(overHalf({{0, 1, 0}, {0.4, 0.9, 0.05}}), paperBut(&RobustRules::noFold));
    rig.mesh({{1, 0, 6}}).list(0, {5}).ring(kRing).pivot();
    CHECK(rig.newTriangles().empty());
    CHECK(objections(rig) == Verdicts{Verdict::FoldsOver});
}

// ---- nomeet -------------------------------------------------------------------------------------

TEST_CASE("nomeet: a triangle that meets a finished one nearby is not made") {
    // A finished triangle stands upright through 0, 1, 5.
    const auto run = [](const Vec3& normal, bool listed, const Params& params) {
        Rig rig(underHalf({{0, 1, 0}, {0.3, 0.5, -1}, {0.3, 0.5, 1}, {0.3, 3, 0}}), params);
        for (const Index p : {6U, 7U, 8U}) rig.normal(p, normal);
        rig.mesh({{6, 8, 7}}).done({6, 7, 8}).list(0, listed ? Points{5, 6, 7} : Points{5});
        rig.ring(kRing).pivot();
        return std::pair(rig.newTriangles(), objections(rig));
    };
    const Vec3 side(1, 0, 0);
    const Vec3 up(0, 0, 1);
    CHECK(run(side, true, paper()).first == kWith5);
    const auto [made, found] = run(side, true, paperBut(&RobustRules::noMeet));
    CHECK(made == kWithout5);
    CHECK(found == Verdicts{Verdict::Meets});
    // It tests only listed points, and only where the surface bends.
    CHECK(run(side, false, paperBut(&RobustRules::noMeet)).first == kWith5);
    CHECK(run(up, true, paperBut(&RobustRules::noMeet)).first == kWith5);
}

TEST_CASE("nomeet: a triangle at a common edge or corner does not meet the old one") {
    Rig rig(underHalf({{0, 1, 0}, {0.5, -1, -1}}), paperBut(&RobustRules::noMeet));
    rig.normal(6, {1, 0, 0});
    rig.mesh({{1, 0, 6}, {6, 0, 3}}).done({6}).list(0, {1, 5, 6}).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWith5);
}

// ---- nolayer ------------------------------------------------------------------------------------

TEST_CASE("nolayer: a triangle that is a second layer of a finished one nearby is not made") {
    // A small finished triangle lies over 0, 1, 5 at a height; 9 makes the place count as bent.
    const auto run = [](double height, const Vec3& normal, const Params& params) {
        Rig rig(underHalf({{0, 1, 0},
                           {0.3, 0.35, height},
                           {0.5, 0.35, height},
                           {0.35, 0.55, height},
                           {0.5, -2, 0}}),
                params);
        for (const Index p : {6U, 7U, 8U}) rig.normal(p, normal);
        rig.normal(9, {1, 0, 0});
        rig.mesh({{6, 7, 8}}).done({6, 7, 8, 9}).list(0, {5, 6, 7, 9}).ring(kRing).pivot();
        return std::pair(rig.newTriangles(), objections(rig));
    };
    const Params layer = paperBut(&RobustRules::noLayer);
    const Vec3 up(0, 0, 1);
    CHECK(run(0.1, up, paper()).first == kWith5);
    const auto [made, found] = run(0.1, up, layer);
    CHECK(made == kWithout5);
    CHECK(found == Verdicts{Verdict::Covers});
    // Too far above; and the other side of a thin wall.
    CHECK(run(2.0, up, layer).first == kWith5);
    CHECK(run(0.1, -up, layer).first == kWith5);
}

TEST_CASE("nolayer: every triangle of the fan is tested") {
    // The finished triangle lies over 0, 5, 2.
    const auto made = [](const Params& params) {
        Rig rig(underHalf({{0, 1, 0},
                           {-0.5, 0.35, 0.1},
                           {-0.3, 0.35, 0.1},
                           {-0.35, 0.55, 0.1},
                           {0.5, -2, 0}}),
                params);
        rig.normal(9, {1, 0, 0}).mesh({{6, 7, 8}}).done({6, 7, 8, 9});
        rig.list(0, {5, 6, 7, 9}).ring(kRing).pivot();
        return rig.newTriangles();
    };
    CHECK(made(paper()) == kWith5);
    CHECK(made(paperBut(&RobustRules::noLayer)) == kWithout5);
}

// ---- rim ----------------------------------------------------------------------------------------

namespace {

/// p = 0 between first and last; 5 .. 10 are finished points close around p, from `from` on.
std::vector<Vec3> atRim(double degrees, double from, double step, double near) {
    std::vector<Vec3> position{Vec3(0), polar(0), polar(degrees), {-9, -9, 0}, {9, -9, 0}};
    for (int i = 0; i < 6; ++i) position.push_back(polar(from + i * step, near));
    return position;
}
Rig& prepareRim(Rig& rig) {
    // Two in a list: the surface ends there.
    return rig.list(1, {0, 2}).list(2, {0, 1}).done({5, 6, 7, 8, 9, 10}).ring(kRing);
}

}  // namespace

TEST_CASE("rim: a wide triangle over three points where the surface ends is not made") {
    const auto made = [](double degrees, const Params& params) {
        Rig rig(atRim(degrees, 200, 30, 1), params);
        prepareRim(rig).list(0, {1, 2}).pivot();
        if (rig.triangles().empty()) CHECK(objections(rig) == Verdicts{Verdict::OverRim});
        return rig.triangles();
    };
    const Params rim = paperBut(&RobustRules::rim);
    CHECK(made(150, paper()) == kWithout5);
    CHECK(made(150, rim).empty());
    CHECK(made(119, rim) == kWithout5);
}

TEST_CASE("rim: a triangle larger than the spacing is not made there") {
    const auto made = [](double near, const Params& params) {
        Rig rig(atRim(100, 250, 5, near), params);
        prepareRim(rig).list(0, {1, 2, 5, 6, 7, 8, 9, 10}).pivot();
        return rig.triangles();
    };
    // The circle has a radius of 0.78.
    CHECK(made(0.3, paper()) == kWithout5);
    CHECK(made(0.3, paperBut(&RobustRules::rim)).empty());
    CHECK(made(0.7, paperBut(&RobustRules::rim)).empty());
    CHECK(made(0.85, paperBut(&RobustRules::rim)) == kWithout5);
}

TEST_CASE("rim: is no matter where one of the three has neighbors all around, or lies on a wall") {
    Rig inside(atRim(150, 0, 60, 1), paperBut(&RobustRules::rim));
    prepareRim(inside).list(0, {1, 2, 5, 6, 7, 8, 9, 10}).pivot();
    CHECK(inside.triangles() == kWithout5);
    Rig wall(atRim(150, 200, 30, 1), paperBut(&RobustRules::rim));
    prepareRim(wall).list(0, {1, 2}).type(1, kPositiveX).pivot();
    CHECK(wall.triangles() == kWithout5);
}

TEST_CASE("rim: the surface ends where neighbors leave a gap of more than 120 degrees") {
    const auto endsWith = [](std::vector<double> degrees) {
        std::vector<Vec3> position{Vec3(0)};
        Points all;
        for (const double d : degrees) {
            all.push_back(static_cast<Index>(position.size()));
            // At any height.
            position.push_back(polar(d) + Vec3(0, 0, all.size() % 2 == 0 ? 0.7 : -0.7));
        }
        Rig rig(position);
        rig.list(0, all);
        return isRim(rig.points(), 0, RobustThresholds{}.rimGapCosine);
    };
    CHECK_FALSE(endsWith({0, 60, 120, 180, 240, 300}));
    CHECK_FALSE(endsWith({0, 100, 200, 281}));
    CHECK(endsWith({0, 100, 200, 239}));
    CHECK(endsWith({0, 30, 60, 90}));
    CHECK(endsWith({0, 180}));
    CHECK(endsWith({}));
}

// ---- delay --------------------------------------------------------------------------------------

TEST_CASE("delay: a steep fan waits for a circuit of the ring without a triangle") {
    const auto pivotsUntilMade = [](double tilt, const Params& params) {
        Rig rig(overHalf({{0, 1, 0}}), params);
        const double angle = tilt * kPi / 180;
        rig.normal(5, {std::sin(angle), 0, std::cos(angle)}).list(0, {5}).ring(kRing);
        int pivots = 0;
        while (rig.newTriangles().empty() && !rig.state().finished()) {
            rig.pivot();
            ++pivots;
        }
        CHECK(rig.newTriangles() == kWith5);
        return pivots;
    };
    CHECK(pivotsUntilMade(61, paper()) == 1);
    CHECK(pivotsUntilMade(59, paperBut(&RobustRules::delay)) == 1);
    CHECK(pivotsUntilMade(61, paperBut(&RobustRules::delay)) == 6);  // A ring of five.
}

TEST_CASE("delay: a fan is steep by the normal of the pivot too, and the triangle is named") {
    for (const double tilt : {59.0, 61.0}) {
        Rig rig(overHalf({{0, 1, 0}}), paperBut(&RobustRules::delay));
        const double angle = tilt * kPi / 180;
        rig.normal(0, {0, std::sin(angle), std::cos(angle)}).list(0, {5}).ring(kRing).pivot();
        CHECK(rig.newTriangles().empty() == (tilt > 60));
        if (tilt < 60) continue;
        REQUIRE(objections(rig) == Verdicts{Verdict::Steep});
        CHECK(rig.all<GuardEvidence>()[0].a == 1);
        CHECK(rig.all<GuardEvidence>()[0].b == 5);
    }
}

namespace {

Params paperWith(std::initializer_list<bool RobustRules::*> rules) {
    Params params = paper();
    for (const auto rule : rules) params.robust.*rule = true;
    return params;
}

}  // namespace

TEST_CASE("delay: a triangle against one normal waits for a second circuit, against all for ever") {
    const auto run = [](const Vec3& of0, const Vec3& of5, const Params& params) {
        Rig rig(overHalf({{0, 1, 0}}), params);
        rig.normal(0, of0).normal(5, of5).list(0, {5}).ring(kRing);
        int pivots = 0;
        while (rig.newTriangles().empty() && !rig.state().finished()) {
            rig.pivot();
            ++pivots;
        }
        return rig.newTriangles().empty() ? 0 : pivots;
    };
    const Params both = paperWith({&RobustRules::noFold, &RobustRules::delay});
    const Vec3 up(0, 0, 1);
    const Vec3 under(1, 0, -0.2);
    CHECK(run(up, under, paper()) == 1);
    CHECK(run(up, under, paperBut(&RobustRules::noFold)) == 0);
    CHECK(run(up, under, both) == 11);
    CHECK(run({1, 0, 0.1}, {0, 0, -1}, both) == 11);  // 0.1 - 1 + 1 is still above zero.
    CHECK(run({1, 0, 0.01}, {0, 0, -1}, paperBut(&RobustRules::noFold)) == 0);
}

TEST_CASE("delay: the allowance ends with the next triangle") {
    Rig rig(overHalf({{0, 1, 0}}), paperBut(&RobustRules::delay));
    rig.normal(5, {1, 0, 0.1}).list(0, {5}).ring(kRing);
    for (int i = 0; i < 5; ++i) rig.pivot();
    CHECK(rig.state().retryLevel == kDelayedAllowed);
    CHECK(rig.newTriangles().empty());
    rig.pivot();
    CHECK(rig.newTriangles() == kWith5);
    CHECK(rig.state().retryLevel == 0);
}
