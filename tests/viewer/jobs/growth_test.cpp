#include "jobs/growth.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "jobs/thread.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/sampler.h"

using namespace se;
using namespace se::view;

namespace {

SampleSpec torus(std::size_t count) {
    SampleSpec spec;
    spec.surface = "torus";
    spec.count = count;
    return spec;
}

}  // namespace

TEST_CASE("Particles that have spread are, byte for byte, those of the sampler at once") {
    Growth growth;
    growth.start(torus(400));
    growth.finish();
    growth.waitUntilDone();
    REQUIRE(growth.phase() == GrowthPhase::Done);
    REQUIRE(growth.picture() != nullptr);
    CHECK(growth.picture()->step == Sampler::allSteps());
    CHECK(growth.spec() == torus(400));
    const Result<PointFile> atOnce = samplePoints(torus(400), {});
    REQUIRE(atOnce.ok());
    CHECK(meshPlyBytes(*growth.picture()->points, {}) == meshPlyBytes(atOnce.value(), {}));
    CHECK(growth.picture()->quality.variation < 0.10);
    CHECK(growth.picture()->quality.off < 1e-4);
}

TEST_CASE("One step at a time: each moves the particles, and the line names the step") {
    Growth growth;
    SampleSpec spec = torus(300);
    spec.steps = 5;
    growth.start(spec);
    growth.waitUntilDone();
    REQUIRE(growth.phase() == GrowthPhase::Paused);
    REQUIRE(growth.picture() != nullptr);
    CHECK(growth.picture()->step == 5);
    CHECK(growth.spec() == spec);
    const auto before = growth.picture()->points;
    const Result<PointFile> same = samplePoints(spec, {});
    REQUIRE(same.ok());
    CHECK(same.value().position == before->position);
    growth.advance(1);
    growth.waitUntilDone();
    CHECK(growth.picture()->step == 6);
    CHECK(growth.picture()->points->position != before->position);
    growth.finish();
    growth.waitUntilDone();
    CHECK(growth.phase() == GrowthPhase::Done);
    growth.advance(1);
    growth.waitUntilDone();
    CHECK(growth.picture()->step == Sampler::allSteps());
}

TEST_CASE("Scattering millions of particles does not block, and is cancelled on the way") {
    Growth growth;
    growth.start(torus(5'000'000));
    growth.poll();
    CHECK(growth.phase() == GrowthPhase::Finding);
    growth.cancel();
    CHECK(growth.picture() == nullptr);
}

TEST_CASE("Played particles are shown on their way, and stop on request") {
    Growth growth;
    growth.start(torus(200));
    bool seen = false;
    for (int i = 0; i < 2000 && !seen; ++i) {
        runSlices(std::chrono::milliseconds(1));
        growth.poll();
        if (growth.phase() == GrowthPhase::Paused) growth.play(1);
        const GrowthPicture* picture = growth.picture();
        seen = picture != nullptr && picture->step > 2 && picture->step < Sampler::allSteps();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    CHECK(seen);
    growth.pause();
    growth.waitUntilDone();
    REQUIRE(growth.phase() == GrowthPhase::Paused);
    const int step = growth.picture()->step;
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    CHECK_FALSE(growth.poll());
    CHECK(growth.picture()->step == step);
    CHECK(growth.spec().steps == step);
    // A cancelled run leaves nothing; a restarted one begins at the start.
    growth.cancel();
    CHECK(growth.picture() == nullptr);
    CHECK(growth.phase() == GrowthPhase::Idle);
    growth.start(torus(100));
    growth.finish();
    growth.waitUntilDone();
    CHECK(growth.picture()->points->position.size() == 100);
}

TEST_CASE("A missing surface and an invalid volume are reported in core's words") {
    Growth growth;
    SampleSpec spec = torus(100);
    spec.isovalue = 1000.0;
    growth.start(spec);
    growth.waitUntilDone();
    CHECK(growth.phase() == GrowthPhase::Failed);
    CHECK(growth.picture() == nullptr);
    CHECK(growth.error().find("no surface") != std::string::npos);
    spec.surface = "/nowhere/none.nrrd";
    growth.start(spec);
    growth.waitUntilDone();
    CHECK(growth.phase() == GrowthPhase::Failed);
    CHECK(growth.error().find("none.nrrd") != std::string::npos);
}
