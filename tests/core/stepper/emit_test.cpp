#include <doctest/doctest.h>

#include "fan_scene.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

TEST_CASE("6.4 Figure 9: two points over 180 degrees apart are discarded, the pivot stays") {
    Rig rig(inSector(200, {}));
    rig.listAll().ring(kRing).pivot();
    CHECK(rig.triangles().empty());
    CHECK(rig.status(0) == 1);
    CHECK(rig.state().counters.discarded == 1);
    CHECK(rig.activeRing() == Points{2, 3, 4, 1, 0});
}

TEST_CASE("6.4 two points under 180 degrees apart are a hole being filled") {
    for (const double last : {30.0, 90.0, 179.0}) {
        Rig rig(inSector(last, {}));
        rig.list(0, {1, 2}).ring(kRing).pivot();
        CHECK(rig.triangles() == Triangles{{0, 1, 2}});
        CHECK(rig.status(0) == kDone);
        CHECK(rig.activeRing() == Points{2, 3, 4, 1});
    }
}

TEST_CASE("6.4 180 degrees are not greater than 180") {
    Rig rig({{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {-9, -9, 0}, {9, -9, 0}});
    rig.list(0, {1, 2}).ring(kRing).pivot();
    CHECK(rig.triangles().size() == 1);
}

TEST_CASE("6.4 the test is for rings of two points only") {
    // 5 beyond first is the new start: three points, 190 degrees in all.
    Rig rig({{0, 0, 0}, {1, 0, 0}, polar(190), {-9, -9, 0}, {9, -9, 0}, {1.2, 1.2, 0}});
    rig.list(0, {1, 2, 5}).ring({0, 2, 3, 4, 5, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 5}, {0, 5, 2}});
    Rig one(inSector(190, {polar(90)}));
    one.list(0, {5}).ring(kRing).pivot();
    CHECK(one.triangles() == Triangles{{0, 1, 5}, {0, 5, 2}});
}

TEST_CASE("6.4 Figure 10: triangles run p, first, t, counterclockwise about the normal") {
    Rig rig(inSector(170, {polar(40), polar(80), polar(120)}));
    rig.listAll().ring(kRing).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 2}});
    for (const Triangle& t : rig.triangles()) {
        const auto& x = rig.points().position;
        CHECK(glm::cross(x[t.b] - x[t.a], x[t.c] - x[t.a]).z > 0);
    }
}
