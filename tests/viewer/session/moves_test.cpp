#include <doctest/doctest.h>

#include "jobs/thread.h"
#include "open_session.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

TEST_CASE("Pivots are stepped to their last event, forward and back") {
    OpenSession open;
    for (int i = 0; i < 20; ++i) open.session.moves().stepPivot(1);
    CHECK(open.place() == "20.advance.1");
    CHECK(open.session.cursor() + 1 == open.session.record().events.size());
    open.session.moves().stepPivot(-1);
    CHECK(open.place() == "19.advance.1");
    open.session.moves().stepPivot(-100);
    CHECK(open.place() == "start");
}

TEST_CASE("Sub-steps run through all events of a pivot and on into the next") {
    OpenSession open;
    open.session.moves().goTo({7, Stage::Pivot, 1});
    CHECK(open.place() == "7.pivot.1");
    const auto count = static_cast<int>(open.session.record().events.size());
    open.session.moves().stepEvent(count - 1);
    CHECK(open.place() == "7.advance.1");
    open.session.moves().stepEvent(1);
    CHECK(open.place() == "8.pivot.1");
    open.session.moves().stepEvent(-1);
    CHECK(open.place() == "7.advance.1");
    open.session.moves().stepEvent(-count);
    CHECK(open.place() == "6.advance.1");
}

TEST_CASE("A sub-step from the start leads to the first event, and one back to the start") {
    OpenSession open;
    open.session.moves().stepEvent(1);
    CHECK(open.place() == "1.seed.1");
    open.session.moves().stepEvent(-1);
    CHECK(open.place() == "start");
    open.session.moves().stepEvent(-1);
    CHECK(open.place() == "start");
}

TEST_CASE("Many sub-steps at once cross several pivots") {
    OpenSession open;
    OpenSession other;
    open.session.moves().stepEvent(60);
    for (int i = 0; i < 60; ++i) other.session.moves().stepEvent(1);
    CHECK(open.place() == other.place());
    open.session.moves().stepEvent(-60);
    CHECK(open.place() == "start");
}

TEST_CASE("Finishing a pivot goes to its end, and from there to that of the next") {
    OpenSession open;
    open.session.moves().goTo({5, Stage::Sort, 1});
    open.session.moves().finishPivot();
    CHECK(open.place() == "5.advance.1");
    open.session.moves().finishPivot();
    CHECK(open.place() == "6.advance.1");
}

TEST_CASE("The end of the run is reached, and nothing comes after it") {
    OpenSession open;
    open.session.moves().toEnd();
    const std::string end = open.place();
    CHECK(open.session.atEnd());
    CHECK(open.session.record().pivot == open.session.overview().lastPivot);
    open.session.moves().stepPivot(1);
    CHECK(open.place() == end);
    open.session.moves().stepEvent(1);
    CHECK(open.place() == end);
}

TEST_CASE("The go-to box takes addresses, relative moves, shares and points") {
    OpenSession open;
    Session& session = open.session;
    CHECK(session.moves().goToText(" 42 ").ok());
    CHECK(open.place() == "42.advance.1");
    CHECK(session.moves().goToText("42.sort").ok());
    CHECK(open.place() == "42.sort.1");
    CHECK(session.moves().goToText("42.sort.3").ok());
    CHECK(open.place() == "42.sort.3");
    CHECK(session.moves().goToText("+10").ok());
    CHECK(open.place() == "52.advance.1");
    CHECK(session.moves().goToText("-2").ok());
    CHECK(open.place() == "50.advance.1");
    CHECK(session.moves().goToText("0%").ok());
    CHECK(open.place() == "start");
    CHECK(session.moves().goToText("100%").ok());
    open.session.waitUntilDone();
    CHECK(session.atEnd());
    CHECK(session.moves().goToText("p12").ok());
    CHECK(session.selected() == 12);
}

TEST_CASE("The go-to box refuses nonsense with a sentence") {
    OpenSession open;
    for (const char* text :
         {"", "x", "12.nothing", "101%", "-1%", "p", "p99999999", "12.sort.x", "++1"}) {
        CAPTURE(text);
        CHECK_FALSE(open.session.moves().goToText(text).ok());
    }
    CHECK(open.place() == "start");
}

TEST_CASE("An address that the run lacks is reported") {
    OpenSession open;
    open.session.moves().goTo({3, Stage::Join, 7});
    CHECK(open.place() == "3.ring.3");
    CHECK(open.session.messages().last().find("3.join.7") != std::string::npos);
    open.session.moves().stepPivot(1);
    CHECK(open.session.messages().last().empty());
}

TEST_CASE("A run that was cancelled is at some position on the way and continues from there") {
    OpenSession open("scene:genus-2");
    open.session.moves().toEnd();
    open.session.moves().cancel();
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.moves().busy());
    open.session.moves().toStart();
    CHECK(open.place() == "start");
}

TEST_CASE(
    "p and a number goes to every event about that point in turn, and says when none is left") {
    OpenSession open;
    // All addresses about point 12, found by stepping through the run.
    std::vector<std::string> expected;
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    const std::uint32_t last = open.session.record().pivot;
    for (std::uint32_t pivot = 1; pivot <= last; ++pivot) {
        open.session.moves().goToPivot(pivot);
        open.session.waitUntilDone();
        for (const Event& event : open.session.record().events) {
            if (subjectOf(event) == 12) expected.push_back(toString(event.address));
        }
    }
    REQUIRE(expected.size() > 3);
    open.session.moves().toStart();
    open.session.waitUntilDone();
    for (const std::string& address : expected) {
        CHECK(open.session.moves().goToText("p12").ok());
        open.session.waitUntilDone();
        CHECK(open.place() == address);
        CHECK(open.session.messages().last().empty());
    }
    CHECK(open.session.selected() == 12);
    CHECK(open.session.moves().goToText("p12").ok());
    open.session.waitUntilDone();
    CHECK(open.place() == expected.back());
    CHECK(open.session.messages().last().find("Nothing more happens to point 12") !=
          std::string::npos);
    // Back leads through them, since each was a jump.
    open.session.moves().goBack();
    open.session.waitUntilDone();
    open.session.moves().goBack();
    open.session.waitUntilDone();
    CHECK(open.place() != expected.back());
}

TEST_CASE("An event that the run does not have leads to the last one before it") {
    OpenSession open;
    REQUIRE(open.session.moves().goToText("40.sphere.99").ok());
    open.session.waitUntilDone();
    CHECK(open.session.messages().missed());
    CHECK(open.session.messages().last() ==
          "This run has no event 40.sphere.99. Shown: " + open.place() + ".");
    const Address here = open.session.address();
    CHECK(here.pivot == 40);
    CHECK(isBefore(here, {40, Stage::Sphere, 99}));
    open.session.moves().stepEvent(1);
    open.session.waitUntilDone();
    CHECK(isBefore({40, Stage::Sphere, 99}, open.session.address()));
}

TEST_CASE("A position beyond the end of the run is missed, with a sentence") {
    OpenSession open;
    CHECK_FALSE(open.session.messages().missed());
    REQUIRE(open.session.moves().goToText("999999").ok());
    open.session.waitUntilDone();
    CHECK(open.session.messages().missed());
    CHECK(open.session.messages().last().find("There is no pivot 999999") == 0);
    CHECK(open.session.atEnd());
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.messages().missed());
    REQUIRE(open.session.moves().goToText("p12").ok());
    open.session.waitUntilDone();
    CHECK_FALSE(open.session.messages().missed());
    REQUIRE(open.session.moves().goToText("12.sort.9999").ok());
    open.session.waitUntilDone();
    CHECK(open.session.messages().missed());
}

TEST_CASE("A share of the run means the whole run, also before it is complete") {
    OpenSession whole("scene:torus");
    const std::uint32_t last = whole.session.overview().lastPivot;
    REQUIRE(last > 100);
    Session session;
    session.open(RunSpec{"scene:torus"});
    while (!session.ready()) {
        runSlices(std::chrono::milliseconds(1));
        session.poll();
    }
    REQUIRE(session.moves().goToText("50%").ok());
    // Known by now or not: the share is of the whole run, not of the known part.
    CHECK(session.moves().awaitsLength() == !session.overview().complete);
    session.waitUntilDone();
    CHECK_FALSE(session.moves().awaitsLength());
    CHECK(session.record().pivot == (last + 1) / 2);
    REQUIRE(session.moves().goToText("100%").ok());
    session.waitUntilDone();
    CHECK(session.record().pivot == last);
    CHECK_FALSE(session.moves().goToText("101%").ok());
}

TEST_CASE("Waiting for the length of the run can be stopped, and ends with another move") {
    for (const bool stopped : {true, false}) {
        Session session;
        session.open(RunSpec{"scene:torus"});
        while (!session.ready()) {
            runSlices(std::chrono::milliseconds(1));
            session.poll();
        }
        session.moves().goToShare(1.0);
        const bool waits = session.moves().awaitsLength();
        stopped ? session.moves().cancel() : session.moves().stepPivot(1);
        CHECK_FALSE(session.moves().awaitsLength());
        session.waitUntilDone();
        if (waits) CHECK(session.record().pivot == (stopped ? 0U : 1U));
    }
}

TEST_CASE("History: back and forward lead through the positions before jumps") {
    History history;
    CHECK_FALSE(history.back("5").has_value());
    history.leave("1");
    history.leave("2");
    CHECK(history.back("3") == "2");
    CHECK(history.back("2") == "1");
    CHECK_FALSE(history.back("1").has_value());
    CHECK(history.forward("1") == "2");
    CHECK(history.forward("2") == "3");
    CHECK_FALSE(history.forward("3").has_value());
    history.back("3");
    history.leave("9");
    CHECK_FALSE(history.forward("9").has_value());
}
