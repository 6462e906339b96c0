#include "export/order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "open_session.h"

using namespace se::view;

namespace {

std::shared_ptr<const Model> figure8() {
    LoadProgress progress;
    return test::loadModel(se::RunSpec{"scene:figure-8"}, progress).value();
}

}  // namespace

TEST_CASE("A range has each decision from the first position to the last") {
    const FramePlan plan = planFrames(*figure8(), {"9.sphere.1", "9.emit.4"}).value();
    REQUIRE(plan.places.size() == 8);
    CHECK(plan.places.front() == "9.sphere.1");
    CHECK(plan.places[1] == "9.sphere.2");
    CHECK(plan.places.back() == "9.emit.4");
    CHECK(plan.pivots == std::vector<se::Index>{15});
    CHECK(std::count(plan.points.begin(), plan.points.end(), 46U) == 1);
}

TEST_CASE("A pivot as the last position ends with its last decision") {
    const FramePlan plan = planFrames(*figure8(), {"9", "9"}).value();
    CHECK(plan.places.front() == "9.pivot.1");
    CHECK(plan.places.back().starts_with("9.advance"));
}

TEST_CASE("Frames of pivots are their last decisions, those of events seeds, splits and joins") {
    const FramePlan pivots = planFrames(*figure8(), {"0", "3", PlayUnit::Pivot}).value();
    REQUIRE(pivots.places.size() == 4);
    CHECK(pivots.places[0].empty());
    CHECK(pivots.places[1].starts_with("1.advance"));
    LoadProgress progress;
    const auto figure12 = test::loadModel(se::RunSpec{"scene:figure-12"}, progress).value();
    const FramePlan events = planFrames(*figure12, {"0", "80", PlayUnit::Event}).value();
    const auto& places = events.places;
    for (const char* each : {"1.seed.1", "35.split.1", "74.join.1"})
        CHECK(std::count(places.begin(), places.end(), each) == 1);
    CHECK(places.size() < 20);
}

TEST_CASE("A range that is no part of the run is refused with the reason") {
    const auto model = figure8();
    CHECK(planFrames(*model, {"9.sphere.5", "10"}).error().message ==
          "pivot 9 has 4 decisions of sphere, not 5");
    CHECK(planFrames(*model, {"10", "9"}).error().message == "9 is before 10");
    CHECK(planFrames(*model, {"here", "9"}).error().message.starts_with("here: expected"));
    CHECK(planFrames(*model, {"9.sphere.1", "9.sphere.2", PlayUnit::Event})
              .error()
              .message.starts_with("there is no split"));
}
