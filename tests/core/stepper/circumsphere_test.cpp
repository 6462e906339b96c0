#include <doctest/doctest.h>

#include "fan_scene.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// The candidates that 6.3 keeps.
Points thinned(double lastDegrees, const std::vector<Vec3>& more, const Params& params = paper()) {
    Rig rig(inSector(lastDegrees, more), params);
    rig.listAll().ring(kRing).runTo(Phase::TwoPoint);
    return rig.candidates();
}

}  // namespace

TEST_CASE("6.3 the circle runs through p, s and t, and its center serves for the sphere") {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 t = random.inCube();
        const Vec3 s = random.inCube();
        const Vec3 q = random.inCube();
        const Vec3 c = circumcenter(Vec3(0), t, s);
        const double r = glm::length(c);
        const double d = glm::length(q - c);
        if (r > 100 || std::abs(d - r) < 1e-6) continue;
        const SphereTest test = testSphere(t, glm::dot(t, t), s, glm::dot(s, s), q, glm::dot(q, q));
        CHECK(glm::length(test.center() - c) < 1e-9 * (1 + r * r));
        CHECK(test.radius() == doctest::Approx(r));
        CHECK(test.distance() == doctest::Approx(d));
        CHECK(test.inside() == (d < r));
    }
}

TEST_CASE("6.3 the circle is the same for points of any size") {
    Random random(6);
    const auto test = [](const Vec3& t, const Vec3& s, const Vec3& q) {
        return testSphere(t, glm::dot(t, t), s, glm::dot(s, s), q, glm::dot(q, q));
    };
    for (int i = 0; i < 100; ++i) {
        const Vec3 t = random.inCube();
        const Vec3 s = random.inCube();
        const Vec3 q = random.inCube();
        const SphereTest usual = test(t, s, q);
        for (const int power : {200, 332, 498, -200, -332, -498}) {
            CAPTURE(power);
            const double size = std::ldexp(1.0, power);
            const SphereTest extreme = test(size * t, size * s, size * q);
            CHECK(extreme.inside() == usual.inside());
            CHECK_FALSE(extreme.noCircle);
            CHECK(extreme.center() == size * usual.center());
            CHECK(extreme.radius() == doctest::Approx(size * usual.radius()));
        }
    }
    CHECK(test(Vec3(1e150, 0, 0), Vec3(2e150, 0, 0), Vec3(0, 1e150, 0)).noCircle);
    CHECK(test(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)).noCircle);
}

TEST_CASE("6.3 keeps a point inside the circumsphere, removes one outside") {
    // The circle through p, first and last has its center at 50 degrees.
    const double reach = 1 / std::cos(50 * kPi / 180);
    CHECK(thinned(100, {polar(50, 0.99 * reach)}) == Points{5});
    CHECK(thinned(100, {polar(50, 1.01 * reach)}).empty());
}

TEST_CASE("6.3 the distance is taken in three dimensions") {
    const double reach = 1 / std::cos(50 * kPi / 180);
    const Vec3 inPlane = polar(50, 0.9 * reach);
    CHECK(thinned(100, {inPlane}) == Points{5});
    CHECK(thinned(100, {inPlane + Vec3(0, 0, 0.6 * reach)}).empty());
}

TEST_CASE("6.3 a point exactly on the sphere is removed") {
    Rig rig({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-9, -9, 0}, {9, -9, 0}, {1, 1, 0}});
    rig.listAll().ring(kRing).runTo(Phase::TwoPoint);
    CHECK(rig.candidates().empty());
    CHECK(rig.verdictOn<SphereEvidence>(5) == Verdict::Removed);
}

TEST_CASE("6.3 a point on the sphere up to rounding is not inside") {
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        // Four points of a circle anywhere in space.
        const Vec3 u = random.direction();
        const Vec3 v = glm::normalize(glm::cross(u, random.direction()));
        const double radius = random.between(0.1, 10);
        const auto at = [&](double degrees) {
            return radius * (polar(degrees).x * u + polar(degrees).y * v);
        };
        const double begin = random.between(0, 360);
        const Vec3 p = at(begin);
        const Vec3 t = at(begin + random.between(20, 80)) - p;
        const Vec3 q = at(begin + random.between(100, 200)) - p;
        const Vec3 s = at(begin + random.between(220, 340)) - p;
        const SphereTest test = testSphere(t, glm::dot(t, t), s, glm::dot(s, s), q, glm::dot(q, q));
        CHECK_FALSE(test.inside());
        const Vec3 in = 0.999 * q;
        CHECK(testSphere(t, glm::dot(t, t), s, glm::dot(s, s), in, glm::dot(in, in)).inside());
    }
}

TEST_CASE("6.3 a point stays whose removal would leave a gap of more than 120 degrees") {
    CHECK(thinned(119, {polar(50, 9)}).empty());
    CHECK(thinned(121, {polar(50, 9)}) == Points{5});
    CHECK(thinned(200, {polar(50, 9)}) == Points{5});
    CHECK_FALSE(exceedsAngle(Angle{}, makeAngle(-0.5, false), paper().maxGapCosine));
    CHECK(exceedsAngle(Angle{}, makeAngle(-0.5000001, false), paper().maxGapCosine));
}

TEST_CASE("6.3 the gap is measured between the points beside the evaluated one") {
    // 170 degrees in all, but only 110 between 5 and last.
    CHECK(thinned(170, {polar(60, 1), polar(120, 9)}) == Points{5});
}

TEST_CASE("6.3 without a circle a point is kept") {
    CHECK(thinned(180, {polar(90, 9)}) == Points{5});
    Rig rig(inSector(180, {polar(90, 9)}));
    rig.listAll().ring(kRing).runTo(Phase::TwoPoint);
    CHECK(rig.verdictOn<SphereEvidence>(5) == Verdict::NoCircle);
}

TEST_CASE("6.3 Figure 8: after a removal the evaluation moves on, with the last kept point as t") {
    Rig rig(inSector(100, {polar(30, 9), polar(50, 9), polar(70, 9)}));
    rig.listAll().ring(kRing).runTo(Phase::TwoPoint);
    const auto looks = rig.all<SphereEvidence>();
    REQUIRE(looks.size() == 3);
    CHECK(looks[0].t == 1);
    CHECK(looks[0].s == 6);
    for (std::size_t i = 1; i < 3; ++i) {
        const bool beforeWasKept = looks[i - 1].verdict != Verdict::Removed;
        CHECK(looks[i].t == (beforeWasKept ? looks[i - 1].q : looks[i - 1].t));
    }
    CHECK(looks[2].s == 2);
}

TEST_CASE("6.3 one pass: a point is not looked at again when its neighbor went") {
    // 5 is inside the wide sphere with 6; 6 is removed; with last instead, 5 would be outside.
    const std::vector<Vec3> more{polar(40, 1.7), polar(70, 5)};
    CHECK(thinned(100, more) == Points{5});
    CHECK(thinned(100, {more[0]}).empty());
    CHECK(thinned(100, more, paperBut(&RobustRules::stepBack)).empty());
}
