#include "run/component_shape.h"
#include "jobs/overview_job.h"
#include "open_session.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

namespace {

RunOverview wholeRun(const char* scene) {
    LoadProgress progress;
    const auto model = loadModel({scene, {}, "paper"}, progress);
    REQUIRE(model.ok());
    OverviewJob thread(model.value());
    thread.waitUntilDone();
    RunOverview run;
    thread.poll(run);
    return run;
}

}  // namespace

TEST_CASE("A closed component has no rim, one triangle is all rim") {
    const auto model = test::sphereModel();
    const std::vector<Triangle> closed = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const ComponentShape whole = shapeOf(*model, closed, 7);
    CHECK(whole.begin == 7);
    CHECK(whole.end == 11);
    CHECK(whole.rim.empty());
    const ComponentShape one = shapeOf(*model, std::span(closed).first(1), 0);
    REQUIRE(one.rim.size() == 3);
    CHECK(one.rim[0] == std::array<Index, 2>{0, 1});
    CHECK(one.middle == model->place[0]);
    CHECK(whole.points == 4);
    CHECK(whole.loops == 0);
    CHECK(one.points == 3);
    CHECK(one.loops == 1);
    // Two that share no point have a loop each; two that share one are connected there.
    CHECK(shapeOf(*model, std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}, 0).loops == 2);
    CHECK(shapeOf(*model, std::vector<Triangle>{{0, 1, 2}, {2, 4, 5}}, 0).loops == 1);
}

TEST_CASE("The overview has the shape of each component of any size") {
    for (const char* scene : {"scene:sphere", "scene:grid"}) {
        CAPTURE(scene);
        const RunOverview run = wholeRun(scene);
        REQUIRE_FALSE(run.shapes.empty());
        const ComponentShape& last = run.shapes.back();
        CHECK(last.end == run.triangles.back());
        CHECK(last.rim.empty() == (scene == std::string_view("scene:sphere")));
        CHECK(last.loops == (last.rim.empty() ? 0U : 1U));
        CHECK(last.seconds > 0.0);
        CHECK(shapeAt(run.shapes, last.pivot) == &last);
        CHECK(shapeAt(run.shapes, last.pivot + 1) == nullptr);
        CHECK(shapeAt(run.shapes, 1) == nullptr);
    }
}
