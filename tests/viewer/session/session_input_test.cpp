#include "session/session_input.h"
#include "open_session.h"
#include "run/model.h"
#include "spiraling_edge/scenes/scenes.h"
#include "teach/file_bytes.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

RunSpec scene(const char* source) { return {source}; }

}  // namespace

TEST_CASE("An opened input comes once, with the start of its run") {
    SessionInput input;
    input.open(scene("scene:sphere"));
    CHECK(input.phase() == SessionPhase::Loading);
    input.waitUntilDone();
    auto opened = input.take();
    REQUIRE(opened.has_value());
    REQUIRE(opened->ok());
    CHECK(opened->value().model->name == "scene:sphere");
    const auto answer = opened->value().runner->take();
    REQUIRE(answer.has_value());
    CHECK(answer->final);
    CHECK(answer->record->pivot == 0);
    CHECK_FALSE(input.take().has_value());
    CHECK(input.loadShare() == 0.0);
}

TEST_CASE("A scene that begins in the middle of a run opens there, or not at all without a point") {
    SessionInput input;
    RunSpec spec = scene("scene:figure-6");
    input.open(spec);
    input.waitUntilDone();
    auto opened = input.take();
    REQUIRE(opened.has_value());
    REQUIRE(opened->ok());
    const GivenStart start = startOfScene("figure-6");
    CHECK(opened->value().model->params.start == start);
    const auto answer = opened->value().runner->take();
    REQUIRE(answer.has_value());
    CHECK(answer->record->before.triangleCount == start.triangles.size());
    spec.leftOut = {{8, 8}};
    input.open(spec);
    input.waitUntilDone();
    opened = input.take();
    REQUIRE(opened.has_value());
    REQUIRE_FALSE(opened->ok());
    CHECK(opened->error().message.find("it needs all of its points") != std::string::npos);
}

TEST_CASE("The last of several inputs is the one that is opened") {
    SessionInput input;
    for (const char* source : {"scene:sphere", "scene:torus", "scene:grid"}) {
        input.open(scene(source));
    }
    input.waitUntilDone();
    const auto opened = input.take();
    REQUIRE(opened.has_value());
    REQUIRE(opened->ok());
    CHECK(opened->value().model->name == "scene:grid");
}

TEST_CASE("A cancelled opening is not waited for") {
    SessionInput input;
    input.open(scene("scene:torus"));
    input.cancel();
    CHECK(input.loadShare() == 0.0);
    input.waitUntilDone();
    CHECK_FALSE(input.take().has_value());
}

TEST_CASE("A session whose opening is cancelled continues with the open input, at once") {
    test::OpenSession open;
    const std::uint32_t before = open.session.generation();
    open.session.open(scene("scene:torus"));
    CHECK(open.session.input().phase() == SessionPhase::Loading);
    CHECK(open.session.input().spec().source == "scene:sphere");
    CHECK(open.session.input().opening().source == "scene:torus");
    open.session.cancelOpening();
    CHECK(open.session.input().phase() == SessionPhase::Ready);
    open.session.waitUntilDone();
    CHECK(open.session.generation() == before);
    CHECK(open.session.input().spec().source == "scene:sphere");

    Session empty;
    empty.open(scene("scene:torus"));
    empty.cancelOpening();
    CHECK(empty.startPage());
}

TEST_CASE("A file is hashed as it is read, an unreadable one is reported by its name") {
    const fs::path path = test::ownPlace("loader-test.xyz");
    std::ofstream(path) << "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n";
    LoadProgress progress;
    const auto model = test::loadModel(RunSpec{path.string()}, progress);
    REQUIRE(model.ok());
    CHECK(progress.share == doctest::Approx(1.0));
    CHECK(model.value()->hash ==
          teach::hashOfText("0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n"));
    fs::remove(path);
    const auto missing = test::loadModel(RunSpec{path.string()}, progress);
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.error().message.find("no such file") != std::string::npos);
    progress.cancelled = true;
    CHECK_FALSE(test::loadModel(RunSpec{"scene:sphere"}, progress).ok());
}

TEST_CASE("Points from standard input can be opened repeatedly") {
    RunSpec spec = scene("-");
    LoadProgress progress;
    const auto missing = loadInput(spec, progress);
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.error().message.find("Standard input") != std::string::npos);
    spec.points = std::make_shared<const PointFile>(findScene("torus")->build());
    for (int i = 0; i < 2; ++i) {
        const auto loaded = loadInput(spec, progress);
        REQUIRE(loaded.ok());
        CHECK(loaded.value().model->name == "standard input");
        CHECK(loaded.value().model->points.size() == spec.points->position.size());
        CHECK(loaded.value().model->hash == hashOfPoints(*spec.points));
    }
}
