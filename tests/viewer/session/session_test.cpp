#include <doctest/doctest.h>

#include "open_session.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

TEST_CASE("A session begins at the start of the first scene") {
    OpenSession open("");
    REQUIRE(open.session.input().phase() == SessionPhase::Ready);
    CHECK(open.place() == "start");
    CHECK(open.session.atStart());
    CHECK(open.session.picture().newTriangles.empty());
    CHECK(open.session.overview().complete);
    CHECK(open.session.overview().lastPivot > 0);
}

TEST_CASE("Opening what does not exist fails with a sentence and keeps the open input") {
    OpenSession open;
    open.session.open(RunSpec{"no-such-file.ply"});
    open.session.waitUntilDone();
    CHECK(open.session.input().phase() == SessionPhase::Failed);
    CHECK(open.session.input().error().find("no-such-file.ply") != std::string::npos);
    CHECK(open.session.ready());
    open.session.dismissError();
    CHECK(open.session.input().phase() == SessionPhase::Ready);
}

TEST_CASE("An unknown scene or rule set is named in the error") {
    OpenSession open("scene:nothing");
    CHECK(open.session.input().error().find("nothing") != std::string::npos);
    CHECK_FALSE(open.session.ready());
    open.session.open(withSet({"scene:sphere"}, "wrong"));
    open.session.waitUntilDone();
    CHECK(open.session.input().error().find("wrong") != std::string::npos);
}

TEST_CASE("All triangles of the run are known at its end, in the order they were made") {
    OpenSession open;
    open.session.moves().goToPivot(30);
    open.session.waitUntilDone();
    const std::vector<Triangle> some = open.session.triangles();
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    const std::vector<Triangle>& all = open.session.triangles();
    CHECK(all.size() == open.session.record().after.triangleCount);
    REQUIRE(all.size() > some.size());
    CHECK(std::equal(some.begin(), some.end(), all.begin()));
}

TEST_CASE("The same address shows the same picture, from any direction") {
    OpenSession forward;
    OpenSession back;
    back.session.moves().toEnd();
    for (OpenSession* each : {&forward, &back}) {
        each->session.moves().goTo({42, Stage::Sphere, 1});
        CHECK(each->place() == "42.sphere.1");
    }
    const DecisionState& a = forward.session.picture();
    const DecisionState& b = back.session.picture();
    CHECK(a.status == b.status);
    CHECK(a.pivot == b.pivot);
    CHECK(a.finishedTriangles == b.finishedTriangles);
    REQUIRE(a.rings.size() == b.rings.size());
    for (std::size_t i = 0; i < a.rings.size(); ++i) CHECK(a.rings[i].points == b.rings[i].points);
}

TEST_CASE("The selection survives every move, and goes with another input") {
    OpenSession open;
    open.session.select(5);
    open.session.moves().goToPivot(40);
    open.session.waitUntilDone();
    CHECK(open.session.selected() == 5);
    open.session.open(RunSpec{"scene:grid"});
    open.session.waitUntilDone();
    CHECK(open.session.selected() == kNone);
    CHECK(open.place() == "start");
}

TEST_CASE("Holding the look before an event changes the picture, not the cursor") {
    test::OpenSession open;
    open.session.moves().goTo({30, Stage::Emit, 1});
    open.session.waitUntilDone();
    open.session.showBefore(true);
    CHECK(open.session.picture().newTriangles.empty());
    CHECK(open.place() == "30.emit.1");
    open.session.showBefore(false);
    CHECK(open.session.picture().newTriangles.size() == 1);
}

TEST_CASE(
    "A figure's points have its letters, in the pivot that it shows, unless numbers are chosen") {
    OpenSession open("scene:figure-8");
    Session& session = open.session;
    session.moves().goTo({9, Stage::Sphere, 2});
    REQUIRE(open.place() == "9.sphere.2");
    CHECK(nameOf(46, session.names()) == "q");
    session.showNames(false);
    CHECK(nameOf(46, session.names()) == "46");
    session.showNames(true);
    session.moves().stepPivot(1);
    session.waitUntilDone();
    CHECK(nameOf(46, session.names()) == "46");
    // Those of Figure 2 are the numbers of all its points.
    OpenSession numbers("scene:figure-2");
    numbers.session.moves().toEnd();
    numbers.session.waitUntilDone();
    CHECK(nameOf(0, numbers.session.names()) == "1");
}
