/// A fan that was refused is refused again without a look, for as long as nothing about it changed.
#include "spiraling_edge/stepper/robust/waiting_fans.h"

#include <doctest/doctest.h>

#include "spiraling_edge/stepper/stepper.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Entry 4 is that of point 0, between those of points 1 and 2; point 0 lists 3 and 5.
struct OneRefusal {
    std::vector<Index> list{3, 5};
    WaitingFans waiting{8};

    OneRefusal() {
        waiting.change(3, 6);
        waiting.refuse(4, 7, kDelayedAllowed);
    }
    bool refuses(std::uint32_t retryLevel = kDelayedAllowed) const {
        return waiting.refuses(4, retryLevel, {0, 1, 2}, list);
    }
};

}  // namespace

TEST_CASE("waiting fans: a refusal holds until a point at the pivot or in its list changes") {
    CHECK(OneRefusal().refuses());
    for (const Index p : {0U, 1U, 2U, 3U, 5U}) {
        OneRefusal one;
        one.waiting.change(p, 7);
        CHECK_FALSE(one.refuses());
    }
    OneRefusal elsewhere;
    elsewhere.waiting.change(6, 9);
    CHECK(elsewhere.refuses());
}

TEST_CASE("waiting fans: a refusal holds for the same rules, entry and run alone") {
    CHECK_FALSE(OneRefusal().refuses(kCornerAllowed));
    CHECK_FALSE(OneRefusal().waiting.refuses(3, kDelayedAllowed, {0, 1, 2}, {}));
    OneRefusal moved;
    moved.waiting.forget();
    CHECK_FALSE(moved.refuses());
}

TEST_CASE(
    "waiting fans: a refusal is still known after the rules were relaxed and are strict again") {
    OneRefusal one;
    one.waiting.refuse(4, 9, kCornerAllowed);
    CHECK(one.refuses(kCornerAllowed));
    CHECK(one.refuses(kDelayedAllowed));
    one.waiting.change(3, 8);
    CHECK(one.refuses(kCornerAllowed));
    CHECK_FALSE(one.refuses(kDelayedAllowed));
}

TEST_CASE("waiting fans: every fan is refused that is when all are looked at again") {
    for (const char* id : {"noise", "sharp-crease", "torus"}) {
        const PointSet points = sceneNamed(id);
        EventLog log;
        Stepper looking(points, robust(), &log);
        Stepper knowing(points, robust());
        while (knowing.stepPivot()) {
            looking.stepPivot();
            CHECK(looking.state().counters.refused == knowing.state().counters.refused);
        }
        looking.stepPivot();
        CHECK(knowing.state().counters.refused > 0);
        CHECK(stateHash(knowing.state()) == stateHash(looking.state()));
    }
}
