/// Rules beyond the paper that decide about one pivot: its candidates, and the edges that its fan
/// may use. Each on the least input that needs it: with the rule, and without.
#include <doctest/doctest.h>

#include "fan_scene.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

// ---- angles -------------------------------------------------------------------------------------

TEST_CASE("tangent: a point far below the tangent plane is sorted by its direction in the plane") {
    // 30 degrees in the plane, 74 between the vectors; the sector ends at 60.
    const Vec3 deep = polar(30) - Vec3(0, 0, 3);
    const auto candidates = [&](const Params& params) {
        Rig rig({{0, 0, 0}, polar(0), polar(60), {-9, -9, 0}, {9, -9, 0}, deep}, params);
        rig.list(0, {5}).ring(kRing).runTo(Phase::Limits);
        return rig.candidates();
    };
    CHECK(candidates(paper()).empty());
    CHECK(candidates(paperBut(&RobustRules::tangent)) == Points{5});
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
    Rig on(bayPoints(), paperBut(&RobustRules::unblocked));
    bay(on);
    CHECK(on.startPoint() == 1);
    CHECK(on.endPoint() == 6);  // Nothing blocks it there.
    CHECK(on.verdictOn<LimitEvidence>(5) == Verdict::Blocked);
    CHECK(on.candidates() == Points{7});
}

TEST_CASE("unblocked: a DONE point in the triangle is not in the way") {
    Rig rig(bayPoints(), paperBut(&RobustRules::unblocked));
    bay(rig.done({7}));
    CHECK(rig.startPoint() == 5);
}

TEST_CASE("unblocked: a USED point near the new spoke is in the way, if it is nearer") {
    // 8 is beyond the triangle 0, 1, 5 seen from 0, but within its circle.
    const auto start = [](const Vec3& x, bool used) {
        Rig rig(underHalf({{1.1, 1.2, 0}, {-1.1, 1.2, 0}, {20, 0, 0}, x, {21, 0, 0}, {21, 1, 0}}),
                paperBut(&RobustRules::unblocked));
        rig.list(0, {1, 2, 5, 6, 8});
        if (used) rig.stacked({8, 9, 10});
        rig.ring({0, 2, 6, 3, 4, 5, 1}).runTo(Phase::Reciprocal);
        CHECK(rig.endPoint() == 6);  // Outside of the circle there.
        return rig.startPoint();
    };
    CHECK(start({0.5, 1.0, 0}, true) == 1);
    CHECK(start({0.5, 1.0, 0}, false) == 5);
    CHECK(start({0.75, 1.45, 0}, true) == 5);  // Within the circle, farther than 5.
}

TEST_CASE("stepback: a point is tested again when the one after it is removed") {
    // 5 is inside the wide sphere with 6; 6 is removed; with last instead, 5 is outside.
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
    CHECK(triangles(paperBut(&RobustRules::stepBack)) == kWithout5);
}

TEST_CASE("wallsdone: a wall point whose ring neighbors share its wall is no candidate") {
    const auto candidates = [](unsigned after, const Params& params) {
        Rig rig({{0, 0, 0},
                 {1, 0, 0},
                 {-1, 0, 0},
                 {-9, -9, 0},
                 {9, -9, 0},
                 {0, 1, 0},
                 {-0.7, 1.7, 0},
                 {0.7, 1.7, 0}},
                params);
        rig.type(5, kPositiveX).type(6, kPositiveX).type(7, after);
        rig.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).runTo(Phase::Hole);
        return rig.candidates();
    };
    CHECK(candidates(kPositiveX, paper()) == Points{5});
    CHECK(candidates(kPositiveX, paperBut(&RobustRules::wallsDone)).empty());
    // Not complete: after it the ring leaves the wall.
    CHECK(candidates(kInterior, paperBut(&RobustRules::wallsDone)) == Points{5});
    CHECK(candidates(kNegativeY, paperBut(&RobustRules::wallsDone)) == Points{5});
}

// ---- guard --------------------------------------------------------------------------------------

TEST_CASE("guard: a candidate that would use an edge twice is dropped") {
    // 5 is on a ring opposite to p; a distant triangle already has the edge 0 -> 5.
    const std::vector<Vec3> more{{0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}, {0, 9, 0}};
    for (const Triangle& old : {Triangle{0, 5, 8}, Triangle{5, 0, 8}}) {
        Rig off(underHalf(more));
        off.mesh({old}).list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
        CHECK(off.newTriangles() == kWith5);
        Rig on(underHalf(more), paperBut(&RobustRules::guard));
        on.mesh({old}).list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
        CHECK(on.newTriangles() == kWithout5);
        const auto found = on.all<GuardEvidence>();
        REQUIRE(found.size() == 1);
        CHECK(found[0].verdict == Verdict::EdgeTaken);
        CHECK(found[0].a == 5);
        CHECK(found[0].b == kNone);
        CHECK(found[0].dropped == 5);
    }
}

TEST_CASE("guard: an edge at first or last that is taken refuses the fan") {
    for (const Triangle& old : {Triangle{0, 1, 5}, Triangle{2, 0, 5}}) {
        Rig off(underHalf({{0, 9, 0}}));
        off.mesh({old}).ring(kRing).pivot();
        CHECK(off.newTriangles() == kWithout5);
        Rig on(underHalf({{0, 9, 0}}), paperBut(&RobustRules::guard));
        on.mesh({old}).ring(kRing).pivot();
        CHECK(on.newTriangles().empty());
        CHECK(objections(on) == Verdicts{Verdict::EdgeTaken});
        CHECK(on.all<GuardEvidence>()[0].dropped == kNone);
        CHECK(on.state().counters.refused == 1);
        CHECK(on.activeRing() == Points{2, 3, 4, 1, 0});  // Its turn comes again.
    }
}

TEST_CASE("guard: the ring steps at the pivot are no edges that are taken") {
    Rig rig(underHalf({}), paperBut(&RobustRules::guard));
    rig.mesh({{1, 0, 4}, {0, 2, 3}}).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWithout5);
    CHECK(objections(rig).empty());
}

TEST_CASE("guard: an edge beside an open step at the pivot is taken, since the step is not it") {
    for (const Index from : {1U, 0U}) {
        const Triangle old = from == 1 ? Triangle{1, 0, 4} : Triangle{0, 2, 3};
        Rig off(underHalf({}));
        off.mesh({old}).ring(kRing).open(from).pivot();
        CHECK(off.newTriangles() == kWithout5);
        Rig on(underHalf({}), paperBut(&RobustRules::guard));
        on.mesh({old}).ring(kRing).open(from).pivot();
        CHECK(on.newTriangles().empty());
        CHECK(objections(on) == Verdicts{Verdict::EdgeTaken});
    }
}

namespace {

/// 5 and 6 are on rings of their own, opposite to p; `old` exists between them.
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

}  // namespace

TEST_CASE("guard: an edge closed away from its ring entries is not made") {
    Rig off(twoOppositePoints());
    twoOpposite(off, {6, 5, 11});
    CHECK(off.newTriangles() == kWith5And6);
    Rig on(twoOppositePoints(), paperBut(&RobustRules::guard));
    twoOpposite(on, {6, 5, 11});
    CHECK(on.newTriangles() == kWith5);  // The farther of the two was dropped.
    CHECK(objections(on) == Verdicts{Verdict::EntryMissed});
    CHECK(on.all<GuardEvidence>()[0].a == 5);
    CHECK(on.all<GuardEvidence>()[0].b == 6);
}

TEST_CASE("guard: a rim edge that is there in the same direction is not made") {
    Rig off(twoOppositePoints());
    twoOpposite(off, {5, 6, 11});
    CHECK(off.newTriangles() == kWith5And6);
    Rig on(twoOppositePoints(), paperBut(&RobustRules::guard));
    twoOpposite(on, {5, 6, 11});
    CHECK(on.newTriangles() == kWith5);
    CHECK(objections(on) == Verdicts{Verdict::EdgeTaken});
}

TEST_CASE("guard: an edge closed at its ring entries is made") {
    // 6 -> 5 is a step of the stacked ring, and the triangle closes it.
    Rig rig(underHalf({{0.4, 1, 0}, {-0.4, 1.1, 0}, {0, 9, 0}}), paperBut(&RobustRules::guard));
    rig.mesh({{6, 5, 7}}).list(0, {5, 6}).stacked({6, 5, 7}).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWith5And6);
    CHECK(objections(rig).empty());
}

TEST_CASE("guard: an edge that is open between its ring entries is not closed by them") {
    // As above, but the step 6 -> 5 is no edge: the edge is elsewhere.
    Rig rig(underHalf({{0.4, 1, 0}, {-0.4, 1.1, 0}, {0, 9, 0}}), paperBut(&RobustRules::guard));
    rig.mesh({{6, 5, 7}}).list(0, {5, 6}).stacked({6, 5, 7}).open(6, 5).ring(kRing).pivot();
    CHECK(rig.newTriangles() == kWith5);
    CHECK(objections(rig) == Verdicts{Verdict::EntryMissed});
}

TEST_CASE("guard: without the dropped candidate 6.3 is repeated with all the others") {
    // 8 was removed for 5, whose edge is taken.
    const std::vector<Vec3> more{{0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}, {1, 1, 0}, {0, 9, 0}};
    Rig off(underHalf(more));
    off.list(0, {5, 8}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
    CHECK(off.newTriangles() == kWith5);
    Rig on(underHalf(more), paperBut(&RobustRules::guard));
    on.mesh({{0, 5, 9}}).list(0, {5, 8}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
    CHECK(on.newTriangles() == Triangles{{0, 1, 8}, {0, 8, 2}});
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
    const Params gap = paperBut(&RobustRules::gap);
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
    CHECK(made(paperBut(&RobustRules::noPillow), 1).empty());
    CHECK(made(paperBut(&RobustRules::noPillow), 2) == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
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
    CHECK(made(paperBut(&RobustRules::noPillow)).empty());
    CHECK(made(paperBut(&RobustRules::guard)) == Triangles{{0, 2, 1}});  // No edge is used twice.
}
