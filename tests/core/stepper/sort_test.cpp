#include <doctest/doctest.h>

#include "fan_scene.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

const Vec3 kUp(0, 0, 1);

}  // namespace

TEST_CASE("6.1 angles grow counterclockwise from first, from 0 to 360 degrees") {
    const Frame frame = makeFrame(Vec3(5, 6, 7), kUp, Vec3(5, 6, 7) + polar(30, 2));
    for (int degrees = 1; degrees < 360; ++degrees) {
        const Angle angle = angleOf(frame, polar(30 + degrees, 3));
        CHECK(angle.degrees() == doctest::Approx(degrees));
    }
    CHECK(angleOf(frame, polar(30)).degrees() == doctest::Approx(0));
}

TEST_CASE("6.1 the angle is the arccosine of z.v, or 360 degrees less that where n.v < 0") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p = random.inCube();
        const Vec3 normal = random.direction();
        const Vec3 first = p + random.direction();
        const Vec3 v = random.direction();
        const Vec3 z = glm::normalize(first - p);
        const double half = std::acos(glm::dot(z, v)) * 180 / kPi;
        const double expected = glm::dot(glm::cross(normal, z), v) >= 0 ? half : 360 - half;
        const Frame frame = makeFrame(p, normal, first);
        CHECK(angleOf(frame, 0.3 * v).degrees() == doctest::Approx(expected));
    }
}

TEST_CASE("6.1 the two sides of the slicing plane: n.v = 0 belongs to the first half") {
    const Frame frame = makeFrame(Vec3(0), kUp, Vec3(2, 0, 0));
    CHECK(angleOf(frame, Vec3(-1, 0, 0)).degrees() == doctest::Approx(180));
    CHECK(angleOf(frame, Vec3(-1, 0, 0)).key == kHalfTurnKey);
    CHECK(angleOf(frame, Vec3(-1, -1e-6, 0)).key > kHalfTurnKey);
}

TEST_CASE("6.1 keys order angles as degrees do, and decide differences over a limit") {
    Random random(2);
    const auto at = [](double degrees) {
        return angleOf(makeFrame(Vec3(0), kUp, Vec3(1, 0, 0)), polar(degrees));
    };
    for (int i = 0; i < 2000; ++i) {
        const double a = random.between(0, 359);
        const double b = random.between(a + 0.01, 360);
        CHECK(at(a).key < at(b).key);
        for (const double limit : {90.0, 120.0, 170.0}) {
            if (std::abs(b - a - limit) < 1e-6) continue;
            CHECK(exceedsAngle(at(a), at(b), std::cos(limit * kPi / 180)) == (b - a > limit));
        }
    }
    CHECK(exceedsAngle(at(10), kFullTurn, -0.5));
    CHECK_FALSE(exceedsAngle(at(250), kFullTurn, -0.5));
}

TEST_CASE("6.1 rounding beyond a cosine of 1 does no harm") {
    CHECK(makeAngle(1.0 + 1e-15, false).degrees() == 0.0);
    CHECK(makeAngle(-1.0 - 1e-15, false).degrees() == doctest::Approx(180));
    CHECK(makeAngle(1.0 + 1e-15, true).degrees() == 360.0);
}

TEST_CASE("6.1 neighbors are sorted by angle, whatever their distance") {
    Rig rig(inSector(180, {polar(120, 0.5), polar(30, 2), polar(75, 1), polar(160, 3)}));
    rig.list(0, {1, 2, 5, 6, 7, 8}).ring(kRing).runTo(Phase::Limits);
    CHECK(rig.candidates() == Points{6, 7, 5, 8});
}

TEST_CASE("6.1 a long list is sorted by angle too, and nothing of it is lost") {
    for (const std::size_t count : {31U, 32U, 33U, 34U, 64U, 65U, 100U}) {
        CAPTURE(count);
        // Farther ones at smaller angles: the list begins with the largest.
        std::vector<Vec3> more;
        for (std::size_t i = 0; i < count; ++i) {
            const double share = static_cast<double>(i + 1) / static_cast<double>(count + 1);
            more.push_back(polar(180.0 * share, 2.0 - share));
        }
        Rig rig(inSector(180, more));
        Points listed;
        Points expected;
        for (std::size_t i = 0; i < count; ++i) {
            expected.push_back(static_cast<Index>(5 + i));
            listed.insert(listed.begin(), static_cast<Index>(5 + i));
        }
        rig.rawList(0, listed).ring(kRing).runTo(Phase::Limits);
        CHECK(rig.candidates() == expected);
    }
}

TEST_CASE("6.1 of two neighbors at the same angle the one closest to p is kept") {
    for (const bool nearFirst : {true, false}) {
        Rig rig(inSector(180, {polar(90, 1), polar(90, 2), polar(40, 1)}));
        rig.rawList(0, nearFirst ? Points{7, 5, 6} : Points{7, 6, 5}).ring(kRing);
        rig.runTo(Phase::Limits);
        CHECK(rig.candidates() == Points{7, 5});
        CHECK(rig.verdictOn<SortEvidence>(6) == Verdict::SameAngle);
    }
}

TEST_CASE("6.1 Figure 3: a neighbor beyond last is not in the neighbor ring") {
    for (const double last : {100.0, 180.0, 250.0}) {
        Rig rig(inSector(last, {polar(last - 20), polar(last + 20), polar(last, 2), polar(-20)}));
        rig.list(0, {5, 6, 7, 8}).ring(kRing).runTo(Phase::Limits);
        CHECK(rig.candidates() == Points{5});
        CHECK(rig.verdictOn<SortEvidence>(6) == Verdict::NotBeforeEnd);
        CHECK(rig.verdictOn<SortEvidence>(7) == Verdict::NotBeforeEnd);
        CHECK(rig.verdictOn<SortEvidence>(8) == Verdict::NotBeforeEnd);
    }
}

TEST_CASE("6.1 a neighbor in the direction of first is no candidate") {
    Rig rig(inSector(180, {polar(0, 2), polar(0, 0.5), polar(1e-9), polar(90)}));
    rig.list(0, {5, 6, 7, 8}).ring(kRing).runTo(Phase::Limits);
    CHECK(rig.candidates() == Points{8});
    CHECK(rig.verdictOn<SortEvidence>(5) == Verdict::NotAfterStart);
}

TEST_CASE("6.1 when first and last are the same the ending angle is a full turn") {
    Rig rig({Vec3(0), polar(0, 0.9), polar(60), polar(120), polar(180), polar(240), polar(300)});
    rig.list(0, {1, 2, 3, 4, 5, 6}).run();
    REQUIRE(rig.triangles().size() == 6);
    CHECK(rig.triangles()[0] == Triangle{0, 1, 2});
    CHECK(rig.triangles()[5] == Triangle{0, 6, 1});
}

TEST_CASE("4, 6.1 a DONE neighbor is no candidate") {
    Rig rig(inSector(180, {polar(60), polar(120)}));
    rig.list(0, {5, 6}).ring(kRing).done({5}).runTo(Phase::Limits);
    CHECK(rig.candidates() == Points{6});
    CHECK(rig.verdictOn<SortEvidence>(5) == Verdict::AlreadyDone);
}

TEST_CASE("6.1 first and last themselves are no candidates, even with another entry on the ring") {
    Rig rig(inSector(270, {polar(60)}));
    rig.list(0, {1, 2, 5}).ring({0, 2, 3, 1, 2, 4, 1}).runTo(Phase::Limits);
    CHECK(rig.candidates() == Points{5});
    CHECK(rig.verdictOn<SortEvidence>(1) == Verdict::OnRingEnd);
    CHECK(rig.verdictOn<SortEvidence>(2) == Verdict::OnRingEnd);
}

TEST_CASE("6.1 Figure 3 off: points beyond last are candidates, last itself is none") {
    Params params = paper();
    params.paper.maxAngle = false;
    Rig rig(inSector(100, {polar(60), polar(200)}), params);
    rig.list(0, {1, 2, 5, 6}).ring(kRing).runTo(Phase::Limits);
    CHECK(rig.candidates() == Points{5, 6});
}

TEST_CASE(
    "6.1 the frame follows the normal of the pivot: below, the same points turn the other way") {
    Rig rig(inSector(-100, {polar(-30), polar(30)}));
    for (Index p = 0; p < 7; ++p) rig.normal(p, Vec3(0, 0, -1));
    rig.list(0, {5, 6}).ring(kRing).runTo(Phase::Limits);
    CHECK(rig.candidates() == Points{5});
}
