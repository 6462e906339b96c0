#include <doctest/doctest.h>

#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Figure 4: p = 0 at the bottom of a bay of the ring 5 -> 1 -> 0 -> 2 -> 6; first 1, last 2, the
/// points beyond them q = 5 and t = 6; r = 9 and s = 8 lie beyond the new limits, 7 lies between.
std::vector<Vec3> bay() {
    return {{0, 0, 0},     {1, 0.2, 0},    {-1, 0.2, 0}, {-9, -9, 0},   {9, -9, 0},
            {1.1, 1.2, 0}, {-1.1, 1.2, 0}, {0, 1.3, 0},  {1.3, 0.8, 0}, {-1.3, 0.8, 0}};
}
const Points kBayRing{0, 2, 6, 3, 4, 5, 1};

}  // namespace

TEST_CASE("6.1 concave means a free angle below 180 degrees") {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 s = random.inCube();
        const Vec3 flat(1, 1, 0);
        const Vec3 before = (s + random.direction()) * flat;
        const Vec3 after = (s + random.direction()) * flat;
        const double free = turnDegrees(before - s * flat, after - s * flat);
        if (std::abs(free - 180) < 1e-3 || free < 1e-3 || free > 359.999) continue;
        CHECK(testConcave(s * flat, Vec3(0, 0, 1), before, after).concave() == (free < 180));
    }
}

TEST_CASE("6.1 a straight ring is not concave") {
    const Vec3 up(0, 0, 1);
    CHECK_FALSE(testConcave({1, 2, 0}, up, {0, 2, 0}, {3, 2, 0}).concave());
    CHECK_FALSE(testConcave({1, 2, 0}, up, {1, 1, 0}, {1, 5, 0}).concave());
}

TEST_CASE("6.1 Figure 4: start and end advance where the ring is concave, points beyond are out") {
    Rig rig(bay());
    rig.list(0, {1, 2, 5, 6, 7, 8, 9}).ring(kBayRing);
    REQUIRE(rig.runTo(Phase::Convex));
    CHECK(rig.startPoint() == 5);
    CHECK(rig.endPoint() == 6);
    CHECK(rig.candidates() == Points{7});
    CHECK(rig.verdictOn<DropEvidence>(8) == Verdict::Outside);
    CHECK(rig.verdictOn<DropEvidence>(9) == Verdict::Outside);
    rig.pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 5}, {0, 5, 7}, {0, 7, 6}, {0, 6, 2}});
}

TEST_CASE("6.1 Figure 4: z stays the reference vector when start advances") {
    Rig rig(bay());
    rig.list(0, {5, 6, 7}).ring(kBayRing).runTo(Phase::Convex);
    const double start = turnDegrees(bay()[1], bay()[5]);
    CHECK(rig.state().pivot.startAngle.degrees() == doctest::Approx(start));
    CHECK(rig.state().pivot.frame.z.x == doctest::Approx(1 / std::sqrt(1.04)));
}

TEST_CASE("6.1 start and end stay where the next ring point is not among p's neighbors") {
    Rig rig(bay());
    rig.list(0, {1, 2, 7}).ring(kBayRing).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 1);
    CHECK(rig.endPoint() == 2);
    // The log has turn and angle, which this needed not.
    const LimitEvidence start = rig.all<LimitEvidence>().front();
    CHECK(start.verdict == Verdict::NotListed);
    CHECK(start.to == 5);
    CHECK(start.turn == testConcave(bay()[1], Vec3(0, 0, 1), bay()[5], bay()[0]).turn);
    CHECK(start.toDegrees == doctest::Approx(turnDegrees(bay()[1], bay()[5])));
}

TEST_CASE("6.1 start and end stay where the ring is convex") {
    // A pivot with 300 degrees free; 5 is listed, inside the limits, and beyond first.
    Rig rig({Vec3(0), polar(0), polar(300), {9, -9, 0}, {9, 9, 0}, {-0.2, -1, 0}, polar(90)});
    rig.list(0, {1, 2, 5, 6}).ring({0, 2, 3, 4, 5, 1}).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 1);
    CHECK(rig.verdictOn<LimitEvidence>(5) == Verdict::NotConcave);
}

TEST_CASE("6.1 start does not advance to a point beyond last, nor end to one before first") {
    Rig rig({Vec3(0), polar(0), polar(100), {-9, -9, 0}, {9, 9, 0}, polar(120, 2), polar(50)});
    rig.list(0, {1, 2, 5, 6}).ring({0, 2, 3, 4, 5, 1}).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 1);
    CHECK(rig.verdictOn<LimitEvidence>(5) == Verdict::Outside);
    Rig other({Vec3(0), polar(0), polar(100), {-9, -9, 0}, {9, 9, 0}, polar(-20, 2), polar(50)});
    other.list(0, {1, 2, 5, 6}).ring({0, 2, 5, 4, 3, 1}).runTo(Phase::Convex);
    CHECK(other.endPoint() == 2);
    CHECK(other.verdictOn<LimitEvidence>(5) == Verdict::Outside);
}

TEST_CASE("6.1 start and end do not advance across 180 degrees or more at the pivot") {
    // 5 is 200 degrees from first, seen at p; only because the normal at first tilts away does the
    // ring look concave there. The triangle 0, 1, 5 would be inverted.
    const std::vector<Vec3> position{Vec3(0),     polar(0),  polar(300),
                                     {-9, -9, 0}, {9, 9, 0}, polar(200)};
    Rig rig(position);
    rig.normal(1, {0, 0, -1}).list(0, {1, 2, 5}).ring({0, 2, 3, 4, 5, 1}).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 1);
    CHECK(rig.verdictOn<LimitEvidence>(5) == Verdict::HalfTurn);
    Rig any(position, paperBut(&Readings::belowHalfTurn));
    any.normal(1, {0, 0, -1}).list(0, {1, 2, 5}).ring({0, 2, 3, 4, 5, 1}).runTo(Phase::Convex);
    CHECK(any.startPoint() == 5);
    // The same at end: 5 is 200 degrees before last.
    const std::vector<Vec3> other{Vec3(0),     polar(0),  polar(300),
                                  {-9, -9, 0}, {9, 9, 0}, polar(100)};
    Rig end(other);
    end.normal(2, {0, 0, -1}).list(0, {1, 2, 5}).ring({0, 2, 5, 4, 3, 1}).runTo(Phase::Convex);
    CHECK(end.endPoint() == 2);
    CHECK(end.verdictOn<LimitEvidence>(5) == Verdict::HalfTurn);
}

TEST_CASE("6.1 start and end advance while the ring is concave") {
    const std::vector<Vec3> deep{{0, 0, 0}, {1, 0.1, 0},   {-1, 0.2, 0},  {-9, 9, 0},
                                 {9, 9, 0}, {1.3, 0.6, 0}, {1.2, 1.2, 0}, {0, 1.2, 0}};
    Rig rig(deep);
    rig.list(0, {5, 6, 7}).ring({0, 2, 3, 4, 6, 5, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 2}});
    CHECK(rig.status(1) == kDone);
    CHECK(rig.status(5) == kDone);
    CHECK(rig.status(6) == 1);
}

TEST_CASE("6.1 the limits do not depend on the order of the list, unless read as printed") {
    const std::vector<Vec3> deep{{0, 0, 0}, {1, 0.1, 0},   {-1, 0.2, 0}, {-9, 9, 0},
                                 {9, 9, 0}, {1.3, 0.6, 0}, {1.2, 1.2, 0}};
    for (const Points& order : {Points{5, 6}, Points{6, 5}}) {
        Rig rig(deep);
        rig.rawList(0, order).ring({0, 2, 3, 4, 6, 5, 1}).runTo(Phase::Convex);
        CHECK(rig.startPoint() == 6);
        Rig asTheyCome(deep, paperBut(&Readings::limitsFirst));
        asTheyCome.rawList(0, order).ring({0, 2, 3, 4, 6, 5, 1}).runTo(Phase::Convex);
        CHECK(asTheyCome.startPoint() == (order == Points{5, 6} ? 6 : 5));
    }
}

TEST_CASE("6.1 as printed, a point that the same angle has eliminated moves no limit") {
    // 5, before first on the ring, lies beyond 6 in one direction.
    const std::vector<Vec3> behind{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {-9, 9, 0},
                                   {9, 9, 0}, {0, 2, 0}, {0, 1, 0}};
    Rig rig(behind);
    rig.list(0, {5, 6}).ring({0, 2, 3, 4, 5, 1}).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 5);
    Rig asTheyCome(behind, paperBut(&Readings::limitsFirst));
    asTheyCome.list(0, {5, 6}).ring({0, 2, 3, 4, 5, 1}).runTo(Phase::Convex);
    CHECK(asTheyCome.startPoint() == 1);
    CHECK(asTheyCome.candidates() == Points{6});
}

TEST_CASE("6.1 as printed, start and end move between two entries of one point too") {
    // 1 is before and after 0 on the ring; 3, before it once more, makes the ring concave there.
    const std::vector<Vec3> pinched{{0, 0, 0}, {1, 0, 0}, {-9, -9, 0}, {0.5, 1, 0}, {9, -9, 0}};
    const auto start = [&](const Params& params) {
        Rig rig(pinched, params);
        rig.list(0, {1, 3}).ring({0, 1, 2, 4, 3, 1}).runTo(Phase::Convex);
        return rig.startPoint();
    };
    CHECK(start(paper()) == 1);
    CHECK(start(paperBut(&Readings::closeTwo)) == 3);
}

TEST_CASE("7, 6.1 a step that is no edge of the mesh moves no limit") {
    Rig rig(bay());
    rig.list(0, {5, 6}).ring(kBayRing).open(5).open(2).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 1);
    CHECK(rig.endPoint() == 2);
    CHECK(rig.verdictOn<LimitEvidence>(5) == Verdict::NotAnEdge);
    CHECK(rig.verdictOn<LimitEvidence>(6) == Verdict::NotAnEdge);
    Rig literal(bay(), paperBut(&Readings::openSteps));
    literal.list(0, {5, 6}).ring(kBayRing).open(5).open(2).runTo(Phase::Convex);
    CHECK(literal.startPoint() == 5);
}

TEST_CASE("6.1 the limits do not pass each other: a ring of three stays as it is") {
    Rig rig({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}});
    rig.listAll().ring({0, 2, 1}).runTo(Phase::Convex);
    CHECK(rig.startPoint() == 1);
    CHECK(rig.endPoint() == 2);
    CHECK(rig.verdictOn<LimitEvidence>(2) == Verdict::OtherLimit);
}

TEST_CASE("6.1 a ring of four is filled by two triangles, and nothing is left") {
    Rig rig({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 2.2, 0}});
    rig.listAll().ring({0, 2, 3, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 3}, {0, 3, 2}});
    for (Index p = 0; p < 4; ++p) CHECK(rig.status(p) == kDone);
    CHECK(rig.state().rings.active() == kNone);
}

TEST_CASE("6.1 Figure 5: the point beyond a convex start or end is dropped") {
    const std::vector<Vec3> position{Vec3(0),   polar(0),      polar(300), {9, -9, 0},
                                     {9, 9, 0}, {-0.2, -1, 0}, polar(90),  {-0.05, -0.74, 0}};
    Rig rig(position);
    rig.list(0, {1, 2, 5, 6}).ring({0, 2, 3, 4, 7, 5, 1}).runTo(Phase::Reciprocal);
    CHECK(rig.candidates() == Points{6});
    CHECK(rig.verdictOn<DropEvidence>(5) == Verdict::BeyondConvex);
    // The mirror image: beyond the end.
    std::vector<Vec3> mirror = position;
    for (Vec3& x : mirror) x.x = -x.x;
    Rig other(mirror);
    other.list(0, {1, 2, 5, 6}).ring({0, 1, 5, 7, 4, 3, 2}).runTo(Phase::Reciprocal);
    CHECK(other.candidates() == Points{6});
    CHECK(other.verdictOn<DropEvidence>(5) == Verdict::BeyondConvex);
}

TEST_CASE("6.1 the convexity test applies only to the points adjacent to start and end") {
    // As above, but 5 is two steps beyond first: it could be the other side of a hole.
    Rig rig({Vec3(0),
             polar(0),
             polar(300),
             {9, -9, 0},
             {9, 9, 0},
             {-0.2, -1, 0},
             polar(90),
             {0.5, -0.5, 0}});
    rig.list(0, {1, 2, 5, 6}).ring({0, 2, 3, 4, 5, 7, 1}).runTo(Phase::Reciprocal);
    CHECK(rig.candidates() == Points{6, 5});
}

TEST_CASE("6.1 Figure 5 as printed: every point beyond a convex start is dropped, and no other") {
    Params printed = paper();
    printed.paper.convexShared = true;
    // 5 is next to first, which is convex, and has an entry elsewhere whose sector holds p.
    const std::vector<Vec3> position{Vec3(0),       polar(0),  polar(300),  {9, -9, 0}, {9, 9, 0},
                                     {-0.2, -1, 0}, polar(90), {-9, -1, 0}, {-9, -3, 0}};
    const auto afterConvex = [&](const Params& params) {
        Rig rig(position, params);
        rig.list(0, {1, 2, 5, 6}).stacked({5, 8, 7}).ring({0, 2, 3, 4, 5, 1});
        rig.runTo(Phase::Reciprocal);
        return rig.candidates();
    };
    CHECK(afterConvex(paper()) == Points{6, 5});
    CHECK(afterConvex(printed) == Points{6});
    // 6 came before start moved to 5, and 5 is concave.
    const std::vector<Vec3> deep{{0, 0, 0}, {1, 0.1, 0},   {-1, 0.2, 0}, {-9, 9, 0},
                                 {9, 9, 0}, {1.3, 0.6, 0}, {1.2, 1.2, 0}};
    const auto afterConcave = [&](Params params) {
        params.readings.limitsFirst = false;
        Rig rig(deep, params);
        rig.rawList(0, {6, 5}).ring({0, 2, 3, 4, 6, 5, 1}).runTo(Phase::Reciprocal);
        return rig.candidates();
    };
    CHECK(afterConcave(paper()).empty());
    CHECK(afterConcave(printed) == Points{6});
}

// ---- Figure 6 -----------------------------------------------------------------------------------

namespace {

/// p = 0 looks north over a half plane; e = 5 is a ring point there, between 6 (before) and 7.
std::vector<Vec3> opposite() {
    return {{0, 0, 0},  {1, 0, 0}, {-1, 0, 0},     {-9, -9, 0},
            {9, -9, 0}, {0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}};
}

}  // namespace

TEST_CASE("6.1 Figure 6: a ring point is kept only if p lies in its free sector") {
    // From 6 counterclockwise to 7 about e: 135 to 45 degrees through the south, where p is.
    Rig kept(opposite());
    kept.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).runTo(Phase::Hole);
    CHECK(kept.candidates() == Points{5});
    // The ring passes e the other way: its free side is the wedge in the north.
    Rig refused(opposite());
    refused.list(0, {5}).ring({0, 2, 3, 7, 5, 6, 4, 1}).runTo(Phase::Hole);
    CHECK(refused.candidates().empty());
    CHECK(refused.verdictOn<ReciprocalEvidence>(5) == Verdict::NotReciprocal);
}

TEST_CASE("6.1 printed: preceding and succeeding as (elast, efirst) is the finished side") {
    const Params literal = paperBut(&Readings::freeSector);
    Rig refused(opposite(), literal);
    refused.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).runTo(Phase::Hole);
    CHECK(refused.candidates().empty());
    Rig kept(opposite(), literal);
    kept.list(0, {5}).ring({0, 2, 3, 7, 5, 6, 4, 1}).runTo(Phase::Hole);
    CHECK(kept.candidates() == Points{5});
}

TEST_CASE("6.1 Figure 6: UNUSED points need no second look") {
    Rig rig(opposite());
    rig.list(0, {5}).ring({0, 2, 3, 4, 1}).runTo(Phase::Hole);
    CHECK(rig.candidates() == Points{5});
    CHECK(rig.all<ReciprocalEvidence>().empty());
}

TEST_CASE("6.1, 6.5 of several entries the one whose sector holds p is the other instance") {
    const Points facing{5, 7, 6};  // 6 before, 7 after: the free sector holds p.
    const Points away{5, 6, 7};
    const Points activeFacing{0, 2, 3, 6, 5, 7, 4, 1};
    const Points activeAway{0, 2, 3, 7, 5, 6, 4, 1};
    const auto ringOfInstance = [](Rig& rig) {
        rig.runTo(Phase::Hole);
        const auto& all = rig.state().pivot.candidates;
        return all.empty() ? kNone : rig.state().rings.ringOf(all[0].instance);
    };
    Rig none(opposite());
    none.list(0, {5}).stacked(away).ring(activeAway);
    CHECK(ringOfInstance(none) == kNone);
    Rig stacked(opposite());
    stacked.list(0, {5}).stacked(facing).ring(activeAway);
    CHECK(ringOfInstance(stacked) == stacked.state().rings.stack()[0]);
    Rig active(opposite());
    active.list(0, {5}).stacked(facing).ring(activeFacing);
    CHECK(ringOfInstance(active) == active.state().rings.active());
    Rig older(opposite());
    older.list(0, {5}).ring(activeFacing).stacked(facing);
    CHECK(ringOfInstance(older) == older.state().rings.active());
    Rig top(opposite());
    top.list(0, {5}).stacked(facing).stacked(facing).ring(activeAway);
    CHECK(ringOfInstance(top) == top.state().rings.stack()[1]);
}

TEST_CASE("6.1 the reciprocal test agrees with plain angles") {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 e(random.between(-1, 1), random.between(-1, 1), 0);
        const double first = random.between(0, 360);
        const double last = random.between(0, 360);
        const double pivot = random.between(0, 360);
        const double limit = turnDegrees(polar(first), polar(last));
        const double angle = turnDegrees(polar(first), polar(pivot));
        if (std::abs(angle - limit) < 1e-3 || angle < 1e-3) continue;
        const ReciprocalTest test =
            testReciprocal(e, Vec3(0, 0, 1), e + polar(first, 2), e + polar(last), false,
                           e + polar(pivot, 0.5), 1e-12);
        CHECK(test.inside == (angle < limit));
    }
}
