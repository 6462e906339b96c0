#include <doctest/doctest.h>

#include "open_session.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

TEST_CASE("A session begins at the start of the first scene") {
    OpenSession open("");
    REQUIRE(open.session.phase() == SessionPhase::Ready);
    CHECK(open.place() == "start");
    CHECK(open.session.atStart());
    CHECK(open.session.picture().newTriangles.empty());
    CHECK(open.session.overview().complete);
    CHECK(open.session.overview().lastPivot > 0);
}

TEST_CASE("Opening what does not exist fails with a sentence and keeps the open input") {
    OpenSession open;
    open.session.open({"no-such-file.ply", {}, "paper"});
    open.session.waitUntilDone();
    CHECK(open.session.phase() == SessionPhase::Failed);
    CHECK(open.session.error().find("no-such-file.ply") != std::string::npos);
    CHECK(open.session.ready());
    open.session.dismissError();
    CHECK(open.session.phase() == SessionPhase::Ready);
}

TEST_CASE("An unknown scene or rule set is named in the error") {
    OpenSession open("scene:nothing");
    CHECK(open.session.error().find("nothing") != std::string::npos);
    CHECK_FALSE(open.session.ready());
    open.session.open({"scene:sphere", {}, "wrong"});
    open.session.waitUntilDone();
    CHECK(open.session.error().find("wrong") != std::string::npos);
}

TEST_CASE("Pivots are stepped to their last event, forward and back") {
    OpenSession open;
    for (int i = 0; i < 20; ++i) open.session.stepPivot(1);
    CHECK(open.place() == "20.advance.1");
    CHECK(open.session.cursor() + 1 == open.session.record().events.size());
    open.session.stepPivot(-1);
    CHECK(open.place() == "19.advance.1");
    open.session.stepPivot(-100);
    CHECK(open.place() == "start");
}

TEST_CASE("Sub-steps run through all events of a pivot and on into the next") {
    OpenSession open;
    open.session.goTo({7, Stage::Pivot, 1});
    CHECK(open.place() == "7.pivot.1");
    const auto count = static_cast<int>(open.session.record().events.size());
    open.session.stepEvent(count - 1);
    CHECK(open.place() == "7.advance.1");
    open.session.stepEvent(1);
    CHECK(open.place() == "8.pivot.1");
    open.session.stepEvent(-1);
    CHECK(open.place() == "7.advance.1");
    open.session.stepEvent(-count);
    CHECK(open.place() == "6.advance.1");
}

TEST_CASE("A sub-step from the start leads to the first event, and one back to the start") {
    OpenSession open;
    open.session.stepEvent(1);
    CHECK(open.place() == "1.seed.1");
    open.session.stepEvent(-1);
    CHECK(open.place() == "start");
    open.session.stepEvent(-1);
    CHECK(open.place() == "start");
}

TEST_CASE("Many sub-steps at once cross several pivots") {
    OpenSession open;
    OpenSession other;
    open.session.stepEvent(60);
    for (int i = 0; i < 60; ++i) other.session.stepEvent(1);
    CHECK(open.place() == other.place());
    open.session.stepEvent(-60);
    CHECK(open.place() == "start");
}

TEST_CASE("Finishing a pivot goes to its end, and from there to that of the next") {
    OpenSession open;
    open.session.goTo({5, Stage::Sort, 1});
    open.session.finishPivot();
    CHECK(open.place() == "5.advance.1");
    open.session.finishPivot();
    CHECK(open.place() == "6.advance.1");
}

TEST_CASE("The end of the run is reached, and nothing comes after it") {
    OpenSession open;
    open.session.toEnd();
    const std::string end = open.place();
    CHECK(open.session.atEnd());
    CHECK(open.session.record().pivot == open.session.overview().lastPivot);
    open.session.stepPivot(1);
    CHECK(open.place() == end);
    open.session.stepEvent(1);
    CHECK(open.place() == end);
}

TEST_CASE("All triangles of the run are known at its end, in the order they were made") {
    OpenSession open;
    open.session.goToPivot(30);
    open.session.waitUntilDone();
    const std::vector<Triangle> some = open.session.triangles();
    open.session.toEnd();
    open.session.waitUntilDone();
    const std::vector<Triangle>& all = open.session.triangles();
    CHECK(all.size() == open.session.record().after.triangleCount);
    REQUIRE(all.size() > some.size());
    CHECK(std::equal(some.begin(), some.end(), all.begin()));
}

TEST_CASE("The same address shows the same picture, from any direction") {
    OpenSession forward;
    OpenSession back;
    back.session.toEnd();
    for (OpenSession* each : {&forward, &back}) {
        each->session.goTo({42, Stage::Sphere, 1});
        CHECK(each->place() == "42.sphere.1");
    }
    const Picture& a = forward.session.picture();
    const Picture& b = back.session.picture();
    CHECK(a.status == b.status);
    CHECK(a.pivot == b.pivot);
    CHECK(a.finishedTriangles == b.finishedTriangles);
    REQUIRE(a.rings.size() == b.rings.size());
    for (std::size_t i = 0; i < a.rings.size(); ++i) CHECK(a.rings[i].points == b.rings[i].points);
}

TEST_CASE("The go-to box takes addresses, relative moves, shares and points") {
    OpenSession open;
    Session& session = open.session;
    CHECK(session.goToText(" 42 ").ok());
    CHECK(open.place() == "42.advance.1");
    CHECK(session.goToText("42.sort").ok());
    CHECK(open.place() == "42.sort.1");
    CHECK(session.goToText("42.sort.3").ok());
    CHECK(open.place() == "42.sort.3");
    CHECK(session.goToText("+10").ok());
    CHECK(open.place() == "52.advance.1");
    CHECK(session.goToText("-2").ok());
    CHECK(open.place() == "50.advance.1");
    CHECK(session.goToText("0%").ok());
    CHECK(open.place() == "start");
    CHECK(session.goToText("100%").ok());
    open.session.waitUntilDone();
    CHECK(session.atEnd());
    CHECK(session.goToText("p12").ok());
    CHECK(session.selected() == 12);
}

TEST_CASE("The go-to box refuses nonsense with a sentence") {
    OpenSession open;
    for (const char* text :
         {"", "x", "12.nothing", "101%", "-1%", "p", "p99999999", "12.sort.x", "++1"}) {
        CAPTURE(text);
        CHECK_FALSE(open.session.goToText(text).ok());
    }
    CHECK(open.place() == "start");
}

TEST_CASE("An address that the run lacks is reported") {
    OpenSession open;
    open.session.goTo({3, Stage::Join, 7});
    CHECK(open.place() == "3.advance.1");
    CHECK(open.session.message().find("3.join.7") != std::string::npos);
    open.session.stepPivot(1);
    CHECK(open.session.message().empty());
}

TEST_CASE("The selection survives every move, and goes with another input") {
    OpenSession open;
    open.session.select(5);
    open.session.goToPivot(40);
    open.session.waitUntilDone();
    CHECK(open.session.selected() == 5);
    open.session.open({"scene:grid", {}, "paper"});
    open.session.waitUntilDone();
    CHECK(open.session.selected() == kNone);
    CHECK(open.place() == "start");
}

TEST_CASE("A run that was cancelled is at some position on the way and continues from there") {
    OpenSession open("scene:genus-2");
    open.session.toEnd();
    open.session.cancelMove();
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.busy());
    open.session.toStart();
    CHECK(open.place() == "start");
}

TEST_CASE(
    "p and a number goes to every event about that point in turn, and says when none is left") {
    OpenSession open;
    // All addresses about point 12, found by stepping through the run.
    std::vector<std::string> expected;
    open.session.toEnd();
    open.session.waitUntilDone();
    const std::uint32_t last = open.session.record().pivot;
    for (std::uint32_t pivot = 1; pivot <= last; ++pivot) {
        open.session.goToPivot(pivot);
        open.session.waitUntilDone();
        for (const Event& event : open.session.record().events) {
            if (subjectOf(event) == 12) expected.push_back(toString(event.address));
        }
    }
    REQUIRE(expected.size() > 3);
    open.session.toStart();
    open.session.waitUntilDone();
    for (const std::string& address : expected) {
        CHECK(open.session.goToText("p12").ok());
        open.session.waitUntilDone();
        CHECK(open.place() == address);
        CHECK(open.session.message().empty());
    }
    CHECK(open.session.selected() == 12);
    CHECK(open.session.goToText("p12").ok());
    open.session.waitUntilDone();
    CHECK(open.place() == expected.back());
    CHECK(open.session.message().find("Nothing more happens to point 12") != std::string::npos);
    // Back leads through them, since each was a jump.
    open.session.goBack();
    open.session.waitUntilDone();
    open.session.goBack();
    open.session.waitUntilDone();
    CHECK(open.place() != expected.back());
}

TEST_CASE("A position beyond the end of the run is missed, with a sentence") {
    OpenSession open;
    CHECK_FALSE(open.session.missed());
    REQUIRE(open.session.goToText("999999").ok());
    open.session.waitUntilDone();
    CHECK(open.session.missed());
    CHECK(open.session.message().find("There is no pivot 999999") == 0);
    CHECK(open.session.atEnd());
    open.session.toEnd();
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.missed());
    REQUIRE(open.session.goToText("p12").ok());
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.missed());
    REQUIRE(open.session.goToText("12.sort.9999").ok());
    open.session.waitUntilDone();
    CHECK(open.session.missed());
}

TEST_CASE("A notice goes away after a while; the message is kept until the next move") {
    using namespace std::chrono_literals;
    OpenSession open;
    open.session.say("Saved.");
    const auto now = Session::Clock::now();
    CHECK(open.session.notice(now) == "Saved.");
    CHECK(open.session.notice(now + 4s).empty());
    CHECK(open.session.message() == "Saved.");
    open.session.say(std::string(200, 'x'));
    CHECK_FALSE(open.session.notice(Session::Clock::now() + 4s).empty());
    open.session.stepEvent(1);
    CHECK(open.session.notice().empty());
}

TEST_CASE("A share of the run means the whole run, also before it is complete") {
    OpenSession whole("scene:torus");
    const std::uint32_t last = whole.session.overview().lastPivot;
    REQUIRE(last > 100);
    Session session;
    session.open({"scene:torus", {}, "paper"});
    while (!session.ready()) session.poll();
    REQUIRE(session.goToText("50%").ok());
    // Known by now or not: the share is of the whole run, not of the known part.
    CHECK(session.awaitsLength() == !session.overview().complete);
    session.waitUntilDone();
    CHECK_FALSE(session.awaitsLength());
    CHECK(session.record().pivot == (last + 1) / 2);
    REQUIRE(session.goToText("100%").ok());
    session.waitUntilDone();
    CHECK(session.record().pivot == last);
    CHECK_FALSE(session.goToText("101%").ok());
}

TEST_CASE("Waiting for the length of the run can be stopped, and ends with another move") {
    for (const bool stopped : {true, false}) {
        Session session;
        session.open({"scene:torus", {}, "paper"});
        while (!session.ready()) session.poll();
        session.goToShare(1.0);
        const bool waits = session.awaitsLength();
        stopped ? session.cancelMove() : session.stepPivot(1);
        CHECK_FALSE(session.awaitsLength());
        session.waitUntilDone();
        if (waits) CHECK(session.record().pivot == (stopped ? 0U : 1U));
    }
}
