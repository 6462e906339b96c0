#include "session/session.h"

#include <doctest/doctest.h>

#include "open_session.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/timeline.h"

using namespace se;
using namespace se::view;

namespace {

std::string decisionOf(const Session& session) { return describe(*session.event()); }

}  // namespace

TEST_CASE("A dragged point shows the pivot of the run with that what-if, at the same decision") {
    test::OpenSession open("scene:torus");
    Session& session = open.session;
    session.moves().goTo({60, Stage::Sphere, 1});
    REQUIRE(open.place() == "60.sphere.1");
    const std::string before = decisionOf(session);
    const Index q = subjectOf(*session.event());
    REQUIRE(session.drag().possible(q));
    const Vec3 from = session.model().points.position[q];
    const Vec3 pivot = session.model().points.position[session.picture().pivot];
    const Vec3 to = from + 1.5 * (from - pivot);

    session.drag().begin(q);
    session.drag().moveTo(to);
    session.drag().waitUntilDone();
    Params params = session.model().params;
    params.whatIf = {{WhatIfKind::Move, 60, Stage::Pivot, q, to, {}}};
    const auto expected = Timeline(session.model().points, params).record(60);
    REQUIRE(session.record().events.size() == expected->events.size());
    CHECK(session.record().after.status == expected->after.status);
    CHECK(toString(session.address()) == "60.sphere.1");
    CHECK(subjectOf(*session.event()) == q);
    CHECK(decisionOf(session) != before);
    // What is drawn has the point there; the open model does not.
    CHECK(session.shown().place[q] == session.model().toView(to));
    CHECK(session.model().points.position[q] == from);
    // Inside the sphere at first, outside now: on the way it turned.
    REQUIRE(session.drag().turn());
    const double share = glm::distance(from, *session.drag().turn()) / glm::distance(from, to);
    CHECK(share > 0.0);
    CHECK(share < 1.0);

    SUBCASE("Taken back, all is as before") {
        session.drag().takeBack();
        CHECK_FALSE(session.drag().active());
        CHECK(decisionOf(session) == before);
        CHECK(session.shown().points.position[q] == from);
    }
    SUBCASE("Released, it is the what-if whose run is opened") {
        const WhatIf move = session.drag().release();
        CHECK(move == params.whatIf[0]);
        CHECK_FALSE(session.drag().held());
        const std::string moved = decisionOf(session);
        RunSpec fork;
        fork.whatIf = {move};
        session.rerun(fork);
        session.waitUntilDone();
        CHECK_FALSE(session.drag().active());
        CHECK(decisionOf(session) == moved);
        CHECK(session.shown().points.position[q] == to);
    }
    SUBCASE("Held, it keeps the cursor; a step to another pivot ends it once it is released") {
        session.moves().stepEvent(1);
        session.moves().stepPivot(1);
        session.waitUntilDone();
        CHECK(toString(session.address()) == "60.sphere.1");
        CHECK_FALSE(session.drag().possible(q));
        session.drag().release();
        session.moves().stepPivot(1);
        session.waitUntilDone();
        CHECK_FALSE(session.drag().active());
        CHECK(session.record().pivot == 61);
        CHECK(session.shown().points.position[q] == from);
    }
}

TEST_CASE("No point can be dragged where there is no pivot") {
    test::OpenSession open("scene:torus");
    CHECK_FALSE(open.session.drag().possible(0));
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.drag().possible(0));
}
