#include "run/sample_spec.h"
#include "open_session.h"

#include <doctest/doctest.h>

#include "run/model.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/sampling/sampler.h"

using namespace se;
using namespace se::view;

TEST_CASE("A sample specification is one line of text, and reads back") {
    SampleSpec spec;
    spec.surface = "torus";
    spec.count = 4000;
    CHECK(sampleSource(spec) == "sample:torus,n=4000");
    CHECK(isSample(sampleSource(spec)));
    spec.surface = "/data/a, b=c/lobster.nhdr";
    spec.count = 0;
    spec.spacing = 0.1;
    spec.isovalue = -2.5;
    spec.seed = 7;
    spec.curvature = 1.5;
    spec.steps = 12;
    spec.box = WallBox{{0, -1.25, 0}, {1, 2, 3}};
    const std::string source = sampleSource(spec);
    CHECK(source ==
          "sample:/data/a, b=c/lobster.nhdr,spacing=0.1,iso=-2.5,seed=7,curvature=1.5,"
          "box=0:-1.25:0:1:2:3,steps=12");
    const Result<SampleSpec> back = sampleFromSource(source);
    REQUIRE(back.ok());
    CHECK(back.value() == spec);
    CHECK(back.value().box->low.y == -1.25);
}

TEST_CASE("A line that specifies no points is refused, with the wrong part") {
    const auto complaint = [](const char* source) {
        const Result<SampleSpec> read = sampleFromSource(source);
        return read ? std::string("none") : read.error().message;
    };
    CHECK(complaint("torus").find("sample:SHAPE") != std::string::npos);
    CHECK(complaint("sample:torus").find("either the number of points") != std::string::npos);
    CHECK(complaint("sample:torus,n=10,spacing=1").find("either the number of points") !=
          std::string::npos);
    CHECK(complaint("sample:,n=10").find("neither") != std::string::npos);
    CHECK(complaint("sample:torus,n=0").find("\"n=0\"") != std::string::npos);
    CHECK(complaint("sample:torus,n=10,iso=x").find("\"iso=x\"") != std::string::npos);
    CHECK(complaint("sample:torus,n=10,box=1:2:3").find("box") != std::string::npos);
    CHECK(complaint("sample:torus,n=10,steps=100000").find("steps") != std::string::npos);
    CHECK(complaint("sample:torus,n=10,colour=2").find("expected n, spacing") != std::string::npos);
}

TEST_CASE("Title, file name and command line identify the points") {
    SampleSpec spec;
    spec.surface = "/data/lobster.nhdr";
    spec.count = 43000;
    CHECK(sampleTitle(spec, 43000) ==
          "lobster, 43\xE2\x80\x89"
          "000 points");
    CHECK(sampleStem(spec, 43000) == "lobster-43000");
    spec.seed = 3;
    spec.box = WallBox{{-1, 0, 0}, {1, 1, 1}};
    CHECK(sampleCommand(spec) ==
          "spiraling-edge sample /data/lobster.nhdr -n 43000 --seed 3 --box=-1,0,0,1,1,1 -o "
          "lobster-43000.ply");
    spec.steps = 10;
    CHECK(sampleCommand(spec).empty());
}

TEST_CASE("No such shape, no such file, a box that leaves nothing: the reason is reported") {
    SampleSpec spec;
    spec.surface = "cube";
    spec.count = 100;
    CHECK(surfaceOf(spec).error().message.find("two-tori") != std::string::npos);
    spec.surface = "/nowhere/none.nrrd";
    CHECK(surfaceOf(spec).error().message.find("none.nrrd") != std::string::npos);
}

TEST_CASE("Sampled points open like a file, with the options of that line") {
    LoadProgress progress;
    const RunSpec spec{"sample:sphere,n=300,seed=2"};
    const Result<Loaded> loaded = loadInput(spec, progress);
    REQUIRE(loaded.ok());
    CHECK(loaded.value().model->name == "sphere, 300 points");
    REQUIRE(loaded.value().model->points.size() == 300);
    SamplerOptions options;
    options.count = 300;
    options.seed = 2;
    const Result<PointFile> points = sample(fieldOf(*findShape("sphere")), options);
    REQUIRE(points.ok());
    CHECK(loaded.value().model->points.position == points.value().position);
    // Points in memory are used unchanged.
    RunSpec known = spec;
    auto other = std::make_shared<PointFile>(points.value());
    other->position.pop_back();
    other->normal.pop_back();
    other->type.pop_back();
    known.points = other;
    const Result<Loaded> again = loadInput(known, progress);
    REQUIRE(again.ok());
    CHECK(again.value().model->points.size() == 299);
}

TEST_CASE("A wrong line, a cancelled one: nothing is opened") {
    LoadProgress progress;
    CHECK_FALSE(loadInput(RunSpec{"sample:cube,n=10"}, progress).ok());
    progress.cancelled = true;
    const auto stopped = loadInput(RunSpec{"sample:torus,n=500"}, progress);
    REQUIRE_FALSE(stopped.ok());
    CHECK(stopped.error().message == "Opening was cancelled.");
}

TEST_CASE("More points than memory could hold are refused, with the maximum number") {
    const auto complaint = [](const char* source) {
        const Result<SampleSpec> read = sampleFromSource(source);
        return read ? std::string() : read.error().message;
    };
    for (const char* source : {"sample:torus,n=100000000", "sample:torus,n=10000001",
                               "sample:torus,n=99999999999999999999"}) {
        CAPTURE(source);
        CHECK(complaint(source).find("n is from 1 to 10000000") != std::string::npos);
    }
    CHECK(complaint("sample:torus,n=10000000").empty());
}

TEST_CASE("The command for a volume quotes its name for a shell") {
    const auto spec = sampleFromSource("sample:$(touch pwned).nrrd,n=50");
    REQUIRE(spec.ok());
    CHECK(sampleCommand(spec.value()) ==
          "spiraling-edge sample '$(touch pwned).nrrd' -n 50 -o '$(touch pwned)-50.ply'");
}
