#include <doctest/doctest.h>

#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Figure 7: the hole of p = 0, first = 1, last = 2; r = 3 inside it, q = 4 beyond.
std::vector<Vec3> hole() { return {{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0.5, 0}, {0, 1.5, 0}}; }

}  // namespace

TEST_CASE("6.2 Figure 7: in a hole of three only points on p's side of first and last are kept") {
    Rig rig(hole());
    rig.list(0, {1, 2, 3, 4}).ring({0, 2, 1});
    rig.runTo(Phase::Hole);
    CHECK(rig.candidates() == Points{3});  // 4 has the same angle as 3, and is farther.
    std::vector<Vec3> aside = hole();
    aside[4] = {0.3, 1.5, 0};
    Rig both(aside);
    both.list(0, {1, 2, 3, 4}).ring({0, 2, 1}).runTo(Phase::Hole);
    CHECK(both.candidates() == Points{4, 3});
    both.runTo(Phase::Sphere);
    CHECK(both.candidates() == Points{3});
    CHECK(both.verdictOn<HoleEvidence>(4) == Verdict::FarSide);
    both.pivot();
    CHECK(both.triangles() == Triangles{{0, 1, 3}, {0, 3, 2}});
}

TEST_CASE("6.2 a point in the plane itself is not on p's side") {
    std::vector<Vec3> position = hole();
    position[3] = {0, 1, 0};
    position[4] = {0.1, 0.999, 0};
    Rig rig(position);
    rig.list(0, {3, 4}).ring({0, 2, 1}).runTo(Phase::Sphere);
    CHECK(rig.candidates() == Points{4});
}

TEST_CASE("6.2 the side of a point is the same for points of any size") {
    for (const double size : {1e-150, 1e-100, 1.0, 1e100, 1e150}) {
        CAPTURE(size);
        const HolePlane plane =
            makeHolePlane(size * hole()[1], size * hole()[2], Vec3(0, 0, 3), size * hole()[0]);
        CHECK(plane.keeps(size * hole()[3]));
        CHECK_FALSE(plane.keeps(size * hole()[4]));
    }
}

TEST_CASE("6.2 the plane stands on the mean normal of p, first and last") {
    // Seen from above the candidate lies beyond; with the leaning mean normal it lies before.
    const Vec3 lean = Vec3(0, 1, 1) / std::sqrt(2.0);
    const Vec3 x(0, 1.2, 0.5);
    const HolePlane upright = makeHolePlane(hole()[1], hole()[2], Vec3(0, 0, 3), hole()[0]);
    const HolePlane leaning = makeHolePlane(hole()[1], hole()[2], 3.0 * lean, hole()[0]);
    CHECK_FALSE(upright.keeps(x));
    CHECK(leaning.keeps(x));
    Rig rig({hole()[0], hole()[1], hole()[2], x});
    rig.list(0, {3}).ring({0, 2, 1});
    for (const Index p : {0U, 1U, 2U}) rig.normal(p, lean);
    rig.runTo(Phase::Sphere);
    CHECK(rig.candidates() == Points{3});
    // Two of the three lean it far enough, p alone does not.
    for (const bool pivotLeans : {true, false}) {
        Rig some({hole()[0], hole()[1], hole()[2], x});
        some.list(0, {3}).ring({0, 2, 1});
        if (pivotLeans) some.normal(0, lean);
        if (!pivotLeans) some.normal(1, lean).normal(2, lean);
        some.runTo(Phase::Sphere);
        CHECK(some.candidates().empty() == pivotLeans);
    }
}

TEST_CASE("6.2 holes of more than three points are not recognized") {
    std::vector<Vec3> position = hole();
    position[4] = {0.3, 1.5, 0};
    position.push_back({0, 3, 0});
    Rig rig(position);
    rig.list(0, {1, 2, 3, 4}).ring({0, 2, 5, 1}).runTo(Phase::Sphere);
    CHECK(rig.candidates() == Points{4, 3});
    CHECK(rig.all<HoleEvidence>().empty());
}

TEST_CASE("6.2 after the limits moved, start and end are first and last of the hole") {
    // 5 is beyond first, and listed: p, 5 and last = 2 are the hole.
    Rig rig({{0, 0, 0}, {1, 0.2, 0}, {-1, 1, 0}, {0, 0.7, 0}, {0.2, 2, 0}, {1, 1.2, 0}});
    rig.list(0, {3, 4, 5}).ring({0, 2, 5, 1}).runTo(Phase::Sphere);
    CHECK(rig.startPoint() == 5);
    CHECK(rig.candidates() == Points{3});
}

TEST_CASE("6.2 three ring points make no hole if the third step is no edge, or over 180 degrees") {
    std::vector<Vec3> aside = hole();
    aside[4] = {0.3, 1.5, 0};
    Rig open(aside);
    open.list(0, {3, 4}).ring({0, 2, 1}).open(2).runTo(Phase::Sphere);
    CHECK(open.candidates() == Points{4, 3});
    // From west counterclockwise through the south to 20 degrees; 3 is good but behind the plane.
    const std::vector<Vec3> wide{{0, 0, 0}, polar(180), polar(20), {-3, -0.1, 0}, polar(300)};
    Rig reflex(wide);
    reflex.list(0, {3, 4}).ring({0, 2, 1}).runTo(Phase::Sphere);
    CHECK(reflex.candidates() == Points{3, 4});
    Rig literal(wide, paperBut(&Readings::realHole));
    literal.list(0, {3, 4}).ring({0, 2, 1}).runTo(Phase::Sphere);
    CHECK(literal.candidates() == Points{4});
}

TEST_CASE("6.2 a full turn is no hole, however long a ring may be for one") {
    // 1 is before and after the pivot; the plane through start and end would have no direction.
    Params params = paperBut(&Readings::closeTwo);
    params.readings.realHole = false;
    params.paper.holeSize = 5;
    Rig rig({{0, 0, 0}, {1, 0, 0}, {5, 1, 0}, {5, -1, 0}, polar(120), polar(240)}, params);
    rig.list(0, {1, 4, 5}).ring({0, 1, 2, 3, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 4}, {0, 4, 5}, {0, 5, 1}});
}
