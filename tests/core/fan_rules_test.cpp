/// Each rule beyond the paper that decides about one pivot, on the least input that needs it: with
/// the rule, and without.
#include <doctest/doctest.h>

#include "../support/clouds.h"
#include "../support/oracles.h"
#include "../support/rig.h"
#include "spiraling_edge/rules.h"

using namespace se;
using namespace se::test;

namespace {

/// p = 0 between first = 1 in the east and last = 2 in the west, a little under 180 degrees apart,
/// so that the three alone make a triangle. 3 and 4 are far in the south, and their sectors, as
/// those of 1 and 2, lead outside: no other pivot of the ring makes anything.
std::vector<Vec3> underHalf(const std::vector<Vec3>& more) {
    std::vector<Vec3> position{{0, 0, 0}, {1, 0.2, 0}, {-1, 0.2, 0}, {-9, -9, 0}, {9, -9, 0}};
    position.insert(position.end(), more.begin(), more.end());
    return position;
}
/// The same, a little over 180 degrees: the three alone make nothing.
std::vector<Vec3> overHalf(const std::vector<Vec3>& more) {
    std::vector<Vec3> position = underHalf(more);
    position[1].y = position[2].y = -0.2;
    return position;
}
const Points kRing{0, 2, 3, 4, 1};
const Triangles kWithout5{{0, 1, 2}};
const Triangles kWith5{{0, 1, 5}, {0, 5, 2}};

Params paperWith(std::initializer_list<bool Rules::*> rules) {
    Params params = paper();
    for (const auto rule : rules) params.rules.*rule = true;
    return params;
}

/// What the guard said, none if it was silent.
std::vector<Verdict> objections(const Rig& rig) {
    std::vector<Verdict> verdicts;
    for (const auto& e : rig.all<GuardEvidence>()) verdicts.push_back(e.verdict);
    return verdicts;
}
using Verdicts = std::vector<Verdict>;

}  // namespace

// ---- where the angles come from -----------------------------------------------------------------

TEST_CASE("tangent: a point far below the tangent plane is sorted by its direction in the plane") {
    // 30 degrees in the plane, 74 between the vectors; the sector ends at 60.
    const Vec3 deep = polar(30) - Vec3(0, 0, 3);
    const auto candidates = [&](const Params& params) {
        Rig rig({{0, 0, 0}, polar(0), polar(60), {-9, -9, 0}, {9, -9, 0}, deep}, params);
        rig.list(0, {5}).ring(kRing).runTo(Phase::Limits);
        return rig.candidates();
    };
    CHECK(candidates(paper()).empty());
    CHECK(candidates(paperBut(&Rules::tangent)) == Points{5});
}

TEST_CASE("tangent: angles in the plane add up to a full turn on a cone, 3-D angles do not") {
    const Vec3 normal(0, 0, 1);
    double plane = 0;
    double space = 0;
    for (int i = 0; i < 6; ++i) {
        const Vec3 a = polar(60 * i) - Vec3(0, 0, 1);
        const Vec3 b = polar(60 * (i + 1)) - Vec3(0, 0, 1);
        plane += angleOf(makeFrame(Vec3(0), normal, a, true), b).degrees();
        space += angleOf(makeFrame(Vec3(0), normal, a, false), b).degrees();
    }
    CHECK(plane == doctest::Approx(360));
    CHECK(space < 300);
}

namespace {

/// The bay of Figure 4; 7 lies within the triangle 0, 1, 5.
Rig& bay(Rig& rig) {
    rig.list(0, {1, 2, 5, 6, 7}).ring({0, 2, 6, 3, 4, 5, 1}).runTo(Phase::Reciprocal);
    return rig;
}
std::vector<Vec3> bayPoints() { return underHalf({{1.1, 1.2, 0}, {-1.1, 1.2, 0}, {0.8, 0.6, 0}}); }

}  // namespace

TEST_CASE("unblocked: start does not advance over an UNUSED point in the triangle it would make") {
    Rig off(bayPoints());
    bay(off);
    CHECK(off.startPoint() == 5);
    CHECK(off.candidates().empty());
    CHECK(off.verdictOn<DropEvidence>(7) == Verdict::Outside);
    Rig on(bayPoints(), paperBut(&Rules::unblocked));
    bay(on);
    CHECK(on.startPoint() == 1);
    CHECK(on.endPoint() == 6);  // Nothing is in the way there.
    CHECK(on.verdictOn<LimitEvidence>(5) == Verdict::Blocked);
    CHECK(on.candidates() == Points{7});
}

TEST_CASE("unblocked: a DONE point in the triangle is not in the way") {
    Rig rig(bayPoints(), paperBut(&Rules::unblocked));
    bay(rig.done({7}));
    CHECK(rig.startPoint() == 5);
}

TEST_CASE("stepback: a point is looked at again when the one behind it has gone") {
    // 5 is inside the wide sphere with 6; 6 goes; with last instead, 5 is outside.
    const auto triangles = [](const Params& params) {
        Rig rig({{0, 0, 0},
                 polar(0),
                 polar(100),
                 {-9, -9, 0},
                 {9, -9, 0},
                 polar(40, 1.7),
                 polar(70, 5)},
                params);
        rig.list(0, {5, 6}).ring(kRing).pivot();
        return rig.triangles();
    };
    CHECK(triangles(paper()) == kWith5);
    CHECK(triangles(paperBut(&Rules::stepBack)) == kWithout5);
}

TEST_CASE("wallsdone: a wall point whose ring neighbors share its wall is no candidate") {
    const auto candidates = [](unsigned behind, const Params& params) {
        Rig rig({{0, 0, 0},
                 {1, 0, 0},
                 {-1, 0, 0},
                 {-9, -9, 0},
                 {9, -9, 0},
                 {0, 1, 0},
                 {-0.7, 1.7, 0},
                 {0.7, 1.7, 0}},
                params);
        rig.type(5, kPositiveX).type(6, kPositiveX).type(7, behind);
        rig.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).runTo(Phase::Hole);
        return rig.candidates();
    };
    CHECK(candidates(kPositiveX, paper()) == Points{5});
    CHECK(candidates(kPositiveX, paperBut(&Rules::wallsDone)).empty());
    // Not complete: behind it the ring leaves the wall.
    CHECK(candidates(kInterior, paperBut(&Rules::wallsDone)) == Points{5});
    CHECK(candidates(kNegativeY, paperBut(&Rules::wallsDone)) == Points{5});
}

// ---- guard --------------------------------------------------------------------------------------

TEST_CASE("guard: a candidate that would use an edge twice is dropped") {
    // 5 stands on a ring opposite to p; a triangle far off has the edge 0 -> 5 already.
    const std::vector<Vec3> more{{0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}, {0, 9, 0}};
    for (const Triangle& old : {Triangle{0, 5, 8}, Triangle{5, 0, 8}}) {
        Rig off(underHalf(more));
        off.mesh({old}).list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
        CHECK(off.newTriangles() == kWith5);
        Rig on(underHalf(more), paperBut(&Rules::guard));
        on.mesh({old}).list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
        CHECK(on.newTriangles() == kWithout5);
        const auto said = on.all<GuardEvidence>();
        REQUIRE(said.size() == 1);
        CHECK(said[0].verdict == Verdict::EdgeTaken);
        CHECK(said[0].a == 5);
        CHECK(said[0].b == kNone);
        CHECK(said[0].dropped == 5);
    }
}

TEST_CASE("guard: an edge at first or last that is taken refuses the fan") {
    for (const Triangle& old : {Triangle{0, 1, 5}, Triangle{2, 0, 5}}) {
        Rig off(underHalf({{0, 9, 0}}));
        off.mesh({old}).ring(kRing).pivot();
        CHECK(off.newTriangles() == kWithout5);
        Rig on(underHalf({{0, 9, 0}}), paperBut(&Rules::guard));
        on.mesh({old}).ring(kRing).pivot();
        CHECK(on.newTriangles().empty());
        CHECK(objections(on) == Verdicts{Verdict::EdgeTaken});
        CHECK(on.all<GuardEvidence>()[0].dropped == kNone);
        CHECK(on.state().counters.refused == 1);
        CHECK(on.activeRing() == Points{2, 3, 4, 1, 0});  // Its turn comes again.
    }
}

TEST_CASE("guard: the ring steps at the pivot are no edges that are taken") {
    Rig rig(underHalf({}), paperBut(&Rules::guard));
    rig.mesh({{1, 0, 4}, {0, 2, 3}}).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWithout5);
    CHECK(objections(rig).empty());
}

namespace {

/// 5 and 6 stand on rings of their own, opposite to p; `old` is there between them.
Rig& twoOpposite(Rig& rig, const Triangle& old) {
    return rig.mesh({old})
        .list(0, {5, 6})
        .stacked({5, 7, 8})
        .stacked({6, 9, 10})
        .ring(kRing)
        .pivot();
}
std::vector<Vec3> twoOppositePoints() {
    return underHalf({{0.4, 1, 0},
                      {-0.4, 1.1, 0},
                      {0.9, 1.8, 0},
                      {0.3, 1.9, 0},
                      {-0.3, 1.9, 0},
                      {-0.9, 1.8, 0},
                      {0, 9, 0}});
}
const Triangles kWith5And6{{0, 1, 5}, {0, 5, 6}, {0, 6, 2}};

}  // namespace

TEST_CASE("guard: an edge closed away from its ring entries is not made") {
    Rig off(twoOppositePoints());
    twoOpposite(off, {6, 5, 11});
    CHECK(off.newTriangles() == kWith5And6);
    Rig on(twoOppositePoints(), paperBut(&Rules::guard));
    twoOpposite(on, {6, 5, 11});
    CHECK(on.newTriangles() == kWith5);  // The farther of the two went.
    CHECK(objections(on) == Verdicts{Verdict::EntryMissed});
    CHECK(on.all<GuardEvidence>()[0].a == 5);
    CHECK(on.all<GuardEvidence>()[0].b == 6);
}

TEST_CASE("guard: a rim edge that is there in the same direction is not made") {
    Rig off(twoOppositePoints());
    twoOpposite(off, {5, 6, 11});
    CHECK(off.newTriangles() == kWith5And6);
    Rig on(twoOppositePoints(), paperBut(&Rules::guard));
    twoOpposite(on, {5, 6, 11});
    CHECK(on.newTriangles() == kWith5);
    CHECK(objections(on) == Verdicts{Verdict::EdgeTaken});
}

TEST_CASE("guard: an edge closed at its ring entries is made") {
    // 6 -> 5 is a step of the stacked ring, and the triangle closes it.
    Rig rig(underHalf({{0.4, 1, 0}, {-0.4, 1.1, 0}, {0, 9, 0}}), paperBut(&Rules::guard));
    rig.mesh({{6, 5, 7}}).list(0, {5, 6}).stacked({6, 5, 7}).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWith5And6);
    CHECK(objections(rig).empty());
}

// ---- gap ----------------------------------------------------------------------------------------

TEST_CASE("gap: a fan with 180 degrees or more between two spokes is refused") {
    const auto made = [](double degrees, const Params& params) {
        Rig rig({{0, 0, 0}, polar(0), polar(300), {9, -12, 0}, {12, -9, 0}, polar(degrees)},
                params);
        rig.list(0, {5}).ring(kRing).pivot();
        CHECK(rig.state().counters.refused == (rig.triangles().empty() ? 1 : 0));
        return rig.triangles();
    };
    const Params gap = paperBut(&Rules::gap);
    CHECK(made(200, paper()) == kWith5);
    CHECK(made(200, gap).empty());
    CHECK(made(100, paper()) == kWith5);
    CHECK(made(100, gap).empty());
    CHECK(made(150, gap) == kWith5);
    CHECK(made(179, gap) == kWith5);
}

// ---- nopillow -----------------------------------------------------------------------------------

TEST_CASE("nopillow: a ring of two and one candidate would be the same triangle twice") {
    const auto made = [](const Params& params, std::size_t candidates) {
        Rig rig({{0, 0, 0}, polar(0), polar(120), polar(240)}, params);
        rig.list(0, candidates == 1 ? Points{2} : Points{2, 3}).ring({0, 1}).open(0).open(1);
        rig.pivot();
        return rig.triangles();
    };
    CHECK(made(paper(), 1) == Triangles{{0, 1, 2}, {0, 2, 1}});
    CHECK(made(paperBut(&Rules::noPillow), 1).empty());
    CHECK(made(paperBut(&Rules::noPillow), 2) == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
}

TEST_CASE("nopillow: the other side of a finished triangle is left open") {
    // The normal of 0 is wrong, so that the triangle's outside looks like a hole.
    const auto made = [](const Params& params) {
        Rig rig({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, params);
        rig.normal(0, {0, 0, -1});
        rig.mesh({{0, 1, 2}}).ring({0, 1, 2}).pivot();
        return rig.newTriangles();
    };
    CHECK(made(paper()) == Triangles{{0, 2, 1}});
    CHECK(made(paperBut(&Rules::noPillow)).empty());
    CHECK(made(paperBut(&Rules::guard)) == Triangles{{0, 2, 1}});  // No edge is used twice.
}

// ---- nocross ------------------------------------------------------------------------------------

TEST_CASE("nocross: a spoke across a ring edge nearby is not made") {
    // The step 7 -> 6 of a stacked ring lies between p and 5, its finished side towards p.
    const auto run = [](const Params& params) {
        Rig rig(underHalf({{0, 2, 0}, {-0.5, 1, 0}, {0.5, 1, 0}, {0, 3, 0}}), params);
        rig.list(0, {5, 6, 7}).stacked({7, 6, 8}).ring(kRing).pivot();
        return std::pair(rig.newTriangles(), objections(rig));
    };
    CHECK(run(paper()).first == kWith5);
    const auto [made, said] = run(paperBut(&Rules::noCross));
    CHECK(made == kWithout5);
    CHECK(said == Verdicts{Verdict::Crosses});
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
    const auto [made, said] = run(paperBut(&Rules::noCross));
    CHECK(made == kWith5);
    CHECK(said == Verdicts{Verdict::Crosses});
}

TEST_CASE("nocross: edges that only share a point with the fan do not cross it") {
    Rig rig(underHalf({{0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}}), paperBut(&Rules::noCross));
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
    const Params fold = paperBut(&Rules::noFold);
    CHECK(made({0, 0, -1}, paper()) == kWith5);
    CHECK(made({0, 0, -1}, fold) == kWithout5);
    CHECK(made({1, 0, -0.01}, fold) == kWithout5);
    CHECK(made({1, 0, 0.01}, fold) == kWith5);
}

TEST_CASE("nofold: a triangle within 30 degrees of the old one across an edge is not made") {
    // The old triangle has the ring step 1 -> 0; seen along it, the two are `degrees` apart.
    const auto made = [](double degrees, const Params& params) {
        const Vec3 in = polar(101.3);  // Across the step, towards 5.
        const double angle = degrees * kPi / 180;
        const Vec3 old = 0.5 * polar(11.3) + std::cos(angle) * in + Vec3(0, 0, std::sin(angle));
        Rig rig(overHalf({{0, 1, 0}, old}), params);
        rig.mesh({{1, 0, 6}}).list(0, {5}).ring(kRing).pivot();
        return rig.newTriangles();
    };
    const Params fold = paperBut(&Rules::noFold);
    CHECK(made(5, paper()) == kWith5);
    CHECK(made(5, fold).empty());
    CHECK(made(170, fold) == kWith5);
    CHECK(made(60, fold) == kWith5);
}

TEST_CASE("nofold: what folds over is said") {
    Rig rig(overHalf({{0, 1, 0}, {0.4, 0.9, 0.05}}), paperBut(&Rules::noFold));
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
    const auto [made, said] = run(side, true, paperBut(&Rules::noMeet));
    CHECK(made == kWithout5);
    CHECK(said == Verdicts{Verdict::Meets});
    // It looks only at what is listed, and only where the surface bends.
    CHECK(run(side, false, paperBut(&Rules::noMeet)).first == kWith5);
    CHECK(run(up, true, paperBut(&Rules::noMeet)).first == kWith5);
}

TEST_CASE("nomeet: a triangle at a common edge or corner does not meet the old one") {
    Rig rig(underHalf({{0, 1, 0}, {0.5, -1, -1}}), paperBut(&Rules::noMeet));
    rig.normal(6, {1, 0, 0});
    rig.mesh({{1, 0, 6}, {6, 0, 3}}).done({6}).list(0, {1, 5, 6}).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWith5);
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
    const Params rim = paperBut(&Rules::rim);
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
    CHECK(made(0.3, paperBut(&Rules::rim)).empty());
    CHECK(made(0.7, paperBut(&Rules::rim)).empty());
    CHECK(made(0.85, paperBut(&Rules::rim)) == kWithout5);
}

TEST_CASE("rim: is no matter where one of the three has neighbors all around, or lies on a wall") {
    Rig inside(atRim(150, 0, 60, 1), paperBut(&Rules::rim));
    prepareRim(inside).list(0, {1, 2, 5, 6, 7, 8, 9, 10}).pivot();
    CHECK(inside.triangles() == kWithout5);
    Rig wall(atRim(150, 200, 30, 1), paperBut(&Rules::rim));
    prepareRim(wall).list(0, {1, 2}).type(1, kPositiveX).pivot();
    CHECK(wall.triangles() == kWithout5);
}

TEST_CASE("rim: the surface ends where neighbors leave a gap of more than 120 degrees") {
    const auto endsWith = [](std::vector<double> degrees) {
        std::vector<Vec3> position{Vec3(0)};
        Points all;
        for (const double d : degrees) {
            all.push_back(static_cast<Index>(position.size()));
            // However far up or down they are.
            position.push_back(polar(d) + Vec3(0, 0, all.size() % 2 == 0 ? 0.7 : -0.7));
        }
        Rig rig(position);
        rig.list(0, all);
        return isRim(rig.points(), 0);
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
    CHECK(pivotsUntilMade(59, paperBut(&Rules::delay)) == 1);
    CHECK(pivotsUntilMade(61, paperBut(&Rules::delay)) == 6);  // A ring of five.
}

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
    const Params both = paperWith({&Rules::noFold, &Rules::delay});
    const Vec3 up(0, 0, 1);
    const Vec3 under(1, 0, -0.2);
    CHECK(run(up, under, paper()) == 1);
    CHECK(run(up, under, paperBut(&Rules::noFold)) == 0);
    CHECK(run(up, under, both) == 11);
    CHECK(run({1, 0, 0.1}, {0, 0, -1}, both) == 11);  // 0.1 - 1 + 1 is still above zero.
    CHECK(run({1, 0, 0.01}, {0, 0, -1}, paperBut(&Rules::noFold)) == 0);
}

TEST_CASE("delay: patience ends with the next triangle") {
    Rig rig(overHalf({{0, 1, 0}}), paperBut(&Rules::delay));
    rig.normal(5, {1, 0, 0.1}).list(0, {5}).ring(kRing);
    for (int i = 0; i < 5; ++i) rig.pivot();
    CHECK(rig.state().patience == kDelayedAllowed);
    CHECK(rig.newTriangles().empty());
    rig.pivot();
    CHECK(rig.newTriangles() == kWith5);
    CHECK(rig.state().patience == 0);
}
