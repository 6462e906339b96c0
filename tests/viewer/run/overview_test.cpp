#include "jobs/runner.h"

#include <doctest/doctest.h>

#include "scene/mesh_style.h"

#include "open_session.h"
#include "spiraling_edge/stepper/stepper.h"

using namespace se;
using namespace se::view;

namespace {

RunOverview wholeRun(const char* scene) {
    LoadProgress progress;
    const auto model = test::loadModel(RunSpec{scene}, progress);
    REQUIRE(model.ok());
    Runner runner(model.value());
    runner.waitUntilMade();
    RunOverview run;
    runner.takeOverview(run);
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

TEST_CASE("The overview has the counts of a plain run") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Runner runner(model);
    runner.waitUntilMade();
    RunOverview run;
    CHECK(runner.takeOverview(run));
    CHECK_FALSE(runner.takeOverview(run));
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

TEST_CASE("Mesh styles have names that are read back, and form a cycle") {
    MeshStyle style = MeshStyle::Faults;
    for (const MeshStyleRow& row : meshStyles()) {
        CHECK(row.id == style);
        CHECK(meshStyleFromName(row.name) == style);
        style = following(style);
    }
    CHECK(style == MeshStyle::Faults);
    CHECK_FALSE(meshStyleFromName("glossy").has_value());
}

TEST_CASE(
    "Components begin where a seed made triangles, the scale of births goes to the last one") {
    RunOverview run;
    run.triangles = {2, 4, 4, 7, 9};
    run.marks = {{1, MarkKind::Seed}, {3, MarkKind::Seed}, {4, MarkKind::Seed}};
    const MeshColoring parts = meshColoring(MeshStyle::Component, run, 9);
    CHECK(parts.starts == std::vector<std::size_t>{0, 4});
    CHECK(meshColoring(MeshStyle::CreationOrder, run, 0).creationEnd == 9);
    CHECK(meshColoring(MeshStyle::CreationOrder, {}, 12).creationEnd == 12);
    CHECK(meshColoring(MeshStyle::Flat, run, 9) == meshColoring(MeshStyle::Flat, {}, 0));
    CHECK_FALSE(componentColor(0) == componentColor(1));
}

TEST_CASE("The scale of numbers gets lighter all the way") {
    double before = -1.0;
    for (int i = 0; i <= 20; ++i) {
        const Color c = viridis(static_cast<float>(i) / 20.0F);
        const double light = 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) +
                             0.0722 * static_cast<double>(c.b);
        CHECK(light > before);
        before = light;
    }
}
