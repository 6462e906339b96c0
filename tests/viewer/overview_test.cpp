#include "overview.h"

#include <doctest/doctest.h>

#include "rig.h"
#include "spiraling_edge/stepper.h"

using namespace se;
using namespace se::view;

TEST_CASE("The overview counts what a plain run counts") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    OverviewThread thread(model);
    thread.finish();
    RunOverview run;
    CHECK(thread.update(run));
    CHECK_FALSE(thread.update(run));
    Stepper stepper(model->points, model->params);
    stepper.run();
    const State& end = stepper.state();
    CHECK(run.complete);
    CHECK(run.ringLength.size() == end.counters.pivots);
    CHECK(run.lastPivot >= end.counters.pivots);
    CHECK(run.triangles.back() == end.triangles.size());
    CHECK(run.longestRing > 10);
    CHECK(run.longestRing <= end.counters.maxRingLength);
}
