#include "document/first_run.h"

#include <doctest/doctest.h>

#include "driven_app.h"
#include "headless_app.h"

using namespace se;
using namespace se::view;
using test::DrivenApp;
using test::HeadlessApp;

namespace {

struct FirstRunApp : HeadlessApp {
    FirstRun first{context};

    FirstRunApp() : HeadlessApp("first_run") {
        Options options;
        options.input.source = "scene:torus";
        document.begin(options);
        first.begin(20.0);
        waitUntilDone();
    }
};

}  // namespace

TEST_CASE("A first run plays all pivots in the given time") {
    FirstRunApp app;
    REQUIRE(app.first.active());
    CHECK(app.first.poll());
    CHECK(app.playback.playing());
    CHECK(app.playback.unit() == PlayUnit::Pivot);
    CHECK(app.playback.rate() == doctest::Approx(app.session.overview().lastPivot / 20.0));
    CHECK_FALSE(app.first.poll());
}

TEST_CASE("Any key pauses a first run and does nothing else, and the tour is offered") {
    FirstRunApp app;
    app.first.poll();
    CHECK_FALSE(app.ui.offersTour);
    CHECK(app.first.key());
    CHECK_FALSE(app.playback.playing());
    CHECK(app.playback.rate() == 4.0);
    CHECK(app.ui.offersTour);
    CHECK_FALSE(app.first.active());
    CHECK_FALSE(app.first.key());
}

TEST_CASE("A first run that ends under a lesson offers no tour") {
    FirstRunApp app;
    app.first.poll();
    app.document.open("lesson:spiral");
    app.lesson.waitUntilDone();
    REQUIRE(app.ui.lesson.walk.isOpen());
    CHECK(app.first.poll());
    CHECK_FALSE(app.ui.offersTour);
}

TEST_CASE("A first run that has ended offers the tour, which explains it") {
    DrivenApp app({"scene:sphere", "--play", "1"});
    if (!app) return;
    CHECK(app.session.atEnd());
    CHECK(app["task"] == "Faults");
    REQUIRE(app.shows("tour take"));
    app.clickOn("tour take");
    CHECK(app["lesson"] == "Ninety seconds on a torus");
    CHECK_FALSE(app.ui.offersTour);
}
