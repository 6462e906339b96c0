#include <doctest/doctest.h>

#include <array>
#include <utility>

#include "spiraling_edge/stepper/rules.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

struct Wall {
    std::uint8_t bit;
    Vec3 outward;
};
const std::array<Wall, 6> kWalls{{{kPositiveX, {1, 0, 0}},
                                  {kPositiveY, {0, 1, 0}},
                                  {kPositiveZ, {0, 0, 1}},
                                  {kNegativeX, {-1, 0, 0}},
                                  {kNegativeY, {0, -1, 0}},
                                  {kNegativeZ, {0, 0, -1}}}};

/// p = 0 in the middle of the wall y = 0 (-y), 1 east and 2 west of it on the wall, 3 inside and
/// nearer than 2, 4 west beyond 2.
std::vector<Vec3> onWall() { return {{0, 0, 0}, {0.8, 0, 0}, {-1, 0, 0}, {0, 0.9, 0}, {-2, 0, 0}}; }
Rig& typed(Rig& rig) {
    for (const Index p : {0U, 1U, 2U, 4U}) rig.type(p, kNegativeY);
    return rig.listAll();
}

/// The corner of the walls +x and +y at (1, 1): p = 0 and r = 2 on +x, q = 1 on +y, 6 the corner.
std::vector<Vec3> inCorner() {
    return {{1, 0.5, 0}, {0.5, 1, 0}, {1, 0.8, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}};
}
Rig& typedCorner(Rig& rig) {
    for (const Index p : {0U, 2U, 3U}) rig.type(p, kPositiveX);
    for (const Index p : {1U, 5U}) rig.type(p, kPositiveY);
    return rig.type(6, kPositiveX | kPositiveY);
}

}  // namespace

TEST_CASE("4 types: boundary, corner, and what two points share") {
    CHECK_FALSE(isBoundary(kInterior));
    CHECK_FALSE(isBoundary(kCorner));
    for (const Wall& wall : kWalls) {
        CHECK(isBoundary(wall.bit));
        CHECK_FALSE(isCorner(wall.bit));
        CHECK(withCornerBit(wall.bit | kCorner) == wall.bit);
    }
    CHECK(isCorner(kPositiveX | kNegativeZ));
    CHECK(withCornerBit(kPositiveX | kPositiveY) == (kPositiveX | kPositiveY | kCorner));
    CHECK(shareFace(kPositiveX | kPositiveY | kCorner, kPositiveY));
    CHECK_FALSE(shareFace(kPositiveX | kCorner, kPositiveY | kCorner));
}

TEST_CASE("7.2 a transition is between two boundary points without a common wall") {
    CHECK(isTransition(kPositiveX, kPositiveY));
    CHECK_FALSE(isTransition(kPositiveX, kPositiveX));
    CHECK_FALSE(isTransition(kPositiveX, kInterior));
    CHECK_FALSE(isTransition(kInterior, kInterior));
    CHECK_FALSE(isTransition(withCornerBit(kPositiveX | kPositiveY), kPositiveY));
    CHECK(isTransition(withCornerBit(kPositiveX | kPositiveY), kNegativeY));
}

TEST_CASE("7.1 out means positive on a maximum wall and negative on a minimum wall") {
    for (const Wall& wall : kWalls) {
        CHECK(pointsOut(wall.outward, wall.bit));
        CHECK_FALSE(pointsOut(-wall.outward, wall.bit));
        CHECK(pointsOut(wall.outward, static_cast<std::uint8_t>(kFaceBits)));
        CHECK_FALSE(pointsOut(wall.outward, static_cast<std::uint8_t>(kFaceBits & ~wall.bit)));
    }
}

TEST_CASE("7.1 Figure 16: the third point is inserted where the sector lies inside the box") {
    Random random(6);
    for (const Wall& wall : kWalls) {
        for (int i = 0; i < 40; ++i) {
            // A surface that meets the wall at some angle, seen from its outer side.
            const Vec3 along = glm::normalize(glm::cross(wall.outward, random.direction()));
            const Vec3 inward = -wall.outward;
            const Vec3 normal = glm::cross(along, inward);  // Counterclockwise from along: inward.
            const Vec3 p = random.inCube();
            const Vec3 east = p + 0.7 * along;
            const Vec3 west = p - 1.2 * along;
            CHECK_FALSE(placeThirdPoint(p, normal, wall.bit, east, west).before);
            CHECK(placeThirdPoint(p, normal, wall.bit, west, east).before);
            const Vec3 cross = placeThirdPoint(p, normal, wall.bit, west, east).cross;
            CHECK(glm::dot(cross, wall.outward) > 0);
        }
    }
}

TEST_CASE("7.2 a sector stays inside if it is under 180 degrees and holds no outward direction") {
    const Vec3 up(0, 0, 1);
    const auto inside = [&](double from, double to) {
        return sectorStaysInside(Vec3(0), up, kPositiveX, polar(from), polar(to));
    };
    CHECK(inside(90, 270));
    CHECK(inside(100, 200));
    CHECK(inside(0, 90));  // Along the wall's normal itself is not strictly between.
    CHECK_FALSE(inside(270, 90));
    CHECK_FALSE(inside(-30, 30));
    CHECK_FALSE(inside(60, 300));
    CHECK(sectorStaysInside(Vec3(0), up, kPositiveZ, polar(0), polar(170)));
}

// ---- 7.1 ----------------------------------------------------------------------------------------

TEST_CASE("7.1 Figure 14: a ring of two boundary points gets a third one, and no outer triangle") {
    Rig rig(onWall());
    typed(rig).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 3}, {0, 3, 2}});
    CHECK(rig.status(0) == kDone);
    CHECK(rig.status(2) == 1);
    CHECK(rig.state().counters.inserted == 1);
    CHECK(rig.activeRing() == Points{2, 1, 3});
}

TEST_CASE("7.1 Figure 15: the third point becomes first where it is inserted before p") {
    std::vector<Vec3> mirror = onWall();
    for (Vec3& x : mirror) x.x = -x.x;
    Rig rig(mirror);
    typed(rig).pivot();
    REQUIRE(rig.all<InsertEvidence>().size() == 1);
    CHECK(rig.all<InsertEvidence>()[0].verdict == Verdict::Before);
    CHECK(rig.triangles() == Triangles{{0, 2, 3}, {0, 3, 1}});
}

TEST_CASE("7.1 the third point is the nearest that is UNUSED, boundary, and on a wall of p") {
    const auto third = [](auto&& change) {
        Rig rig(onWall());
        typed(rig);
        change(rig);
        rig.pivot();
        return rig.all<InsertEvidence>()[0].third;
    };
    CHECK(third([](Rig&) {}) == 2);  // Not 3, which is nearer but interior.
    CHECK(third([](Rig& rig) { rig.done({2}); }) == 4);
    CHECK(third([](Rig& rig) { rig.type(2, kPositiveX); }) == 4);
    CHECK(third([](Rig& rig) { rig.type(2, kNegativeX | kNegativeY); }) == 2);  // A corner may be.
    CHECK(third([](Rig& rig) { rig.done({2, 4}); }) == kNone);
}

TEST_CASE("7.1 without a third point both are passed over and the ring is freed") {
    for (const bool kept : {false, true}) {
        Rig rig({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, kept ? paper() : paperBut(&Readings::keepSeeds));
        rig.type(0, kNegativeY).type(1, kNegativeY).listAll().pivot().pivot();
        CHECK(rig.state().counters.skipped == 2);
        CHECK(rig.triangles().empty());
        CHECK(rig.status(0) == (kept ? kUnused : kDone));
        CHECK(rig.status(1) == (kept ? kUnused : kDone));
        CHECK(rig.state().counters.lostSeeds == (kept ? 0 : 1));
        CHECK(rig.state().counters.failedSeeds == (kept ? 1 : 0));
    }
}

TEST_CASE("7.1 a third point that leads to no triangle is UNUSED again") {
    Rig rig({{0, 0, 0}, {0.8, -0.2, 0}, {-1, -0.2, 0}});  // p bulges inwards: 205 degrees.
    for (const Index p : {0U, 1U, 2U}) rig.type(p, kNegativeY);
    rig.list(0, {1, 2}).pivot();
    CHECK(rig.triangles().empty());
    CHECK(rig.status(2) == kUnused);
    CHECK(rig.status(0) == 1);
    CHECK(rig.activeRing() == Points{1, 0});
    for (const Index p : {0U, 1U}) {
        CHECK(rig.state().rings.open(rig.state().rings.firstEntryOf(p)));
    }
    CHECK(rig.state().counters.inserted == 0);
}

TEST_CASE("7.1 where the cross product would lead outside, the third point is on the other side") {
    // The second point is around a corner, the third between p and the corner.
    Rig rig({{1, 0, 0}, {0.7, 0.4, 0}, {1, 0.3, 0}});
    rig.type(0, kPositiveX).type(1, kPositiveY).type(2, kPositiveX).list(0, {1, 2});
    rig.ring({0, 1}).open(0).open(1).pivot();
    REQUIRE(rig.all<InsertEvidence>().size() == 1);
    CHECK(rig.all<InsertEvidence>()[0].third == 2);
    CHECK(rig.all<InsertEvidence>()[0].verdict == Verdict::Before);
    CHECK(rig.triangles() == Triangles{{0, 2, 1}});
}

TEST_CASE("7.1 one boundary point and one interior point need no third") {
    Rig rig({{0, 0, 0}, {0, 0.8, 0}, {0.8, 0.4, 0}, {-0.8, 0.4, 0}, {1, 0, 0}});
    rig.type(0, kNegativeY).type(4, kNegativeY).listAll().pivot();
    CHECK(rig.all<InsertEvidence>().empty());
    CHECK(rig.all<SkipEvidence>().size() == 1);
    CHECK(rig.triangles().empty());
}

// ---- 7.2 ----------------------------------------------------------------------------------------

TEST_CASE("7.2 Figure 18: entering a corner, the third point is inserted before p") {
    Rig rig(inCorner());
    typedCorner(rig).listAll().ring({0, 1, 5, 4, 3}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 2, 1}});
    CHECK(rig.status(0) == kDone);
    CHECK(rig.activeRing() == Points{1, 5, 4, 3, 2});
    // 2 and 1 are joined by an edge now; 3 and 2 only by the wall that 0 lies on between them.
    const EdgeRings& rings = rig.state().rings;
    CHECK_FALSE(rings.open(rings.firstEntryOf(2)));
    CHECK(rings.open(rings.firstEntryOf(3)));
}

TEST_CASE("7.2 Figure 19: exiting a corner, the third point is inserted after p") {
    std::vector<Vec3> mirror = inCorner();
    for (Vec3& x : mirror) x = {x.y, x.x, 0};
    Rig rig(mirror);
    for (const Index p : {0U, 2U, 3U}) rig.type(p, kPositiveY);
    for (const Index p : {1U, 5U}) rig.type(p, kPositiveX);
    rig.type(6, kPositiveX | kPositiveY).listAll().ring({0, 3, 4, 5, 1}).pivot();
    REQUIRE(rig.all<InsertEvidence>().size() == 1);
    CHECK(rig.all<InsertEvidence>()[0].verdict == Verdict::After);
    CHECK(rig.triangles() == Triangles{{0, 1, 2}});
    CHECK(rig.activeRing() == Points{2, 3, 4, 5, 1});
    const EdgeRings& rings = rig.state().rings;
    CHECK(rings.open(rings.firstEntryOf(2)));
    CHECK_FALSE(rings.open(rings.firstEntryOf(1)));
}

TEST_CASE("7.2 Figure 20: on a corner, on the side that holds the transition") {
    // 0 is the corner of +x and +y; next = 1 lies on -x, beside the corner of -x and +y; 2 and 3 on
    // the walls of 0.
    Rig rig({{1, 1, 0}, {0, 0.6, 0}, {0.4, 1, 0}, {1, 0.7, 0}, {0.5, 0.2, 0}});
    rig.type(0, kPositiveX | kPositiveY).type(1, kNegativeX).type(2, kPositiveY);
    rig.type(3, kPositiveX).listAll().ring({0, 1, 4, 3}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 2, 1}});
}

TEST_CASE("7.2 a corner between ring neighbors on its two walls has no transition") {
    // 0 is the corner of +x and +y, between 1 on +x and 2 on +y; 3 and 4 on those walls are UNUSED.
    const std::uint8_t corner = withCornerBit(kPositiveX | kPositiveY);
    for (const std::uint8_t beside : {kPositiveX, kPositiveY}) {
        CHECK_FALSE(isTransition(corner, beside));
        CHECK_FALSE(isTransition(beside, corner));
    }
    Rig rig({{1, 1, 0}, {1, 0.5, 0}, {0.5, 1, 0}, {1, 0.2, 0}, {0.2, 1, 0}, {0.3, 0.3, 0}});
    rig.type(0, corner).type(1, kPositiveX).type(3, kPositiveX);
    rig.type(2, kPositiveY).type(4, kPositiveY).listAll().ring({0, 2, 5, 1}).pivot();
    CHECK(rig.all<InsertEvidence>().empty());
    CHECK(rig.all<SkipEvidence>().size() == 1);
    CHECK(rig.triangles().empty());
}

TEST_CASE("7.2 the third point is UNUSED, on a wall of p, and its sector stays inside the box") {
    const auto third = [](auto&& change) {
        std::vector<Vec3> position = inCorner();
        position.push_back({1, 0.3, 0});  // 7: nearer than 2, but on the far side of p.
        Rig rig(position);
        typedCorner(rig).type(7, kPositiveX).listAll();
        change(rig);
        rig.ring({0, 1, 5, 4, 3}).pivot();
        return rig.all<InsertEvidence>().at(0).third;
    };
    CHECK(third([](Rig&) {}) == 2);
    CHECK(third([](Rig& rig) { rig.done({2}); }) == 6);
    CHECK(third([](Rig& rig) { rig.type(2, kPositiveY); }) == 6);
    CHECK(third([](Rig& rig) { rig.done({2, 6}); }) == kNone);
}

TEST_CASE("bothwalls: no third point beside a pivot whose other ring neighbor is off its walls") {
    // 0 on the wall +x; 1 around the corner on +y; the ring comes from 3, on the wall or inside.
    const auto run = [](std::uint8_t after, const Params& params) {
        Rig rig(inCorner(), params);
        typedCorner(rig).type(3, after).listAll().ring({0, 1, 5, 4, 3}).pivot();
        return std::pair(rig.all<InsertEvidence>().at(0).verdict, rig.triangles());
    };
    const Triangles made{{0, 2, 1}};
    CHECK(run(kPositiveX, paperBut(&RobustRules::bothWalls)) == std::pair(Verdict::Before, made));
    CHECK(run(kInterior, paper()) == std::pair(Verdict::Before, made));
    CHECK(run(kInterior, paperBut(&RobustRules::bothWalls)) ==
          std::pair(Verdict::OtherSideOpen, Triangles{}));
}

TEST_CASE("7.2 a third point that leads to no triangle leaves the ring as it was") {
    // From 2 to 1 it is a little over 180 degrees: straight for the wall, too much for a triangle.
    Rig rig({{1, 0.5, 0}, {1.02, -0.6, 0}, {1, 0.8, 0}, {0, 0.5, 0}, {0, -0.5, 0}});
    rig.type(0, kPositiveX).type(1, kNegativeY).type(2, kPositiveX).list(0, {2, 1});
    rig.ring({0, 1, 4, 3}).pivot();
    REQUIRE(rig.all<InsertEvidence>().at(0).third == 2);
    CHECK(rig.triangles().empty());
    CHECK(rig.status(2) == kUnused);
    CHECK(rig.activeRing() == Points{1, 4, 3, 0});
    for (const Index p : {0U, 1U, 3U, 4U}) {
        CHECK_FALSE(rig.state().rings.open(rig.state().rings.firstEntryOf(p)));
    }
}

TEST_CASE("7 Figure 13: elsewhere a boundary point is passed over and stays on the ring") {
    Rig rig(inCorner());
    rig.type(0, kPositiveX).type(1, kPositiveX).type(3, kPositiveX).listAll();
    rig.ring({0, 1, 5, 4, 3}).pivot();
    CHECK(rig.triangles().empty());
    CHECK(rig.status(0) == 1);
    CHECK(rig.activeRing() == Points{1, 5, 4, 3, 0});
    CHECK(rig.state().counters.skipped == 1);
}

TEST_CASE("7 boundary points go when a complete circuit adds no triangle, not before") {
    Rig rig({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    for (Index p = 0; p < 4; ++p) rig.type(p, kPositiveZ);
    rig.listAll().ring({0, 1, 2, 3});
    for (int pivot = 1; pivot <= 3; ++pivot) {
        rig.pivot();
        for (Index p = 0; p < 4; ++p) CHECK(rig.status(p) == 1);
    }
    rig.pivot();
    for (Index p = 0; p < 4; ++p) CHECK(rig.status(p) == kDone);
    CHECK(rig.state().counters.freedRings == 1);
    CHECK(rig.state().counters.holes == 0);
    CHECK(rig.state().rings.active() == kNone);
}

TEST_CASE("7 a triangle restarts the circuit") {
    Rig rig({{0, 1, 0}, {1, 2, 0}, {2, 1, 0}, {2, 0, 0}, {0, 0, 0}});
    rig.type(3, kNegativeY).type(4, kNegativeY).list(0, {1, 4}).ring({3, 4, 0, 1, 2});
    rig.pivot().pivot();
    CHECK(rig.state().circuit == 2);
    rig.pivot();
    CHECK(rig.triangles() == Triangles{{0, 4, 1}});
    CHECK(rig.state().circuit == 0);
}

// ---- 7 for rim points ---------------------------------------------------------------------------

namespace {

/// The rim point 0: its surface lies to the north, its gap from 1 in the west to 2 in the east. The
/// others are 3 and 4 at these angles, and two points far away.
std::vector<Vec3> onRim(double third, double fourth) {
    return {{0, 0, 0}, polar(180), polar(0), polar(third), polar(fourth), {-9, -9, 0}, {9, -9, 0}};
}
const RimGap kSouth{1, 2};

}  // namespace

TEST_CASE("7 rim: a rim point is a pivot like an interior one while its gap is elsewhere") {
    Rig rig(onRim(30, 100));
    rig.rim(0, kSouth).ring({0, 4, 5, 6, 3}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 3, 4}});
    CHECK(rig.all<InsertEvidence>().empty());
    CHECK(rig.status(0) == kDone);
}

TEST_CASE("7 rim: beside the gap its end is the third point before, its beginning the one after") {
    Rig before(onRim(90, 40));
    before.rim(0, kSouth).ring({0, 4, 5, 6, 1}).pivot();
    REQUIRE(before.all<InsertEvidence>().size() == 1);
    CHECK(before.all<InsertEvidence>()[0].verdict == Verdict::Before);
    CHECK(before.triangles() == Triangles{{0, 2, 4}});
    Rig after(onRim(90, 140));
    after.rim(0, kSouth).ring({0, 2, 5, 6, 4}).pivot();
    REQUIRE(after.all<InsertEvidence>().size() == 1);
    CHECK(after.all<InsertEvidence>()[0].verdict == Verdict::After);
    CHECK(after.triangles() == Triangles{{0, 4, 1}});
}

TEST_CASE("7 rim: a rim point with surface on both sides of its gap, or on none, is passed over") {
    // From first = 3 to last = 4, around the gap or within it; both ends of the gap are UNUSED.
    for (const auto& sector : {std::pair(150.0, 40.0), std::pair(200.0, 300.0)}) {
        CAPTURE(sector.first);
        Rig rig(onRim(sector.first, sector.second));
        rig.rim(0, kSouth).ring({0, 4, 5, 6, 3}).pivot();
        CHECK(rig.all<InsertEvidence>().empty());
        CHECK(rig.all<SkipEvidence>().size() == 1);
        CHECK(rig.triangles().empty());
        CHECK(rig.activeRing() == Points{4, 5, 6, 3, 0});
        for (const Index end : {1U, 2U}) CHECK(rig.status(end) == kUnused);
    }
}

TEST_CASE("7 rim: a rim point whose gap is not known is passed over") {
    Rig rig(onRim(30, 100));
    rig.type(0, kRimPoint).ring({0, 4, 5, 6, 3}).pivot();
    CHECK(rig.all<SkipEvidence>().size() == 1);
    CHECK(rig.triangles().empty());
    CHECK(rig.activeRing() == Points{4, 5, 6, 3, 0});
}

TEST_CASE("7.1 rim: on a ring of two the third point is the gap's end, else its beginning") {
    const auto run = [](const std::vector<Index>& done) {
        Rig rig(onRim(60, 90));
        rig.rim(0, kSouth).type(3, kRimPoint).done(done).ring({0, 3}).open(0).open(3).pivot();
        return std::pair(rig.all<InsertEvidence>().at(0).verdict, rig.triangles());
    };
    CHECK(run({}) == std::pair(Verdict::Before, Triangles{{0, 2, 3}}));
    CHECK(run({2}) == std::pair(Verdict::After, Triangles{{0, 3, 1}}));
    CHECK(run({1, 2}) == std::pair(Verdict::NoThirdPoint, Triangles{}));
}
