#include "jobs/overview_job.h"

#include <doctest/doctest.h>

#include "scene/mesh_style.h"

#include "open_session.h"
#include "spiraling_edge/stepper/stepper.h"

using namespace se;
using namespace se::view;

TEST_CASE("The overview has the counts of a plain run") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    OverviewJob thread(model);
    thread.waitUntilDone();
    RunOverview run;
    CHECK(thread.poll(run));
    CHECK_FALSE(thread.poll(run));
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
    MeshStyle style = MeshStyle::Flat;
    for (const MeshStyleRow& row : meshStyles()) {
        CHECK(row.id == style);
        CHECK(meshStyleFromName(row.name) == style);
        style = following(style);
    }
    CHECK(style == MeshStyle::Flat);
    CHECK_FALSE(meshStyleFromName("glossy").has_value());
}

TEST_CASE(
    "Components begin where a seed made triangles; the scale of births goes to the last one") {
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
