#include "spiraling_edge/look.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/io_support.h"

namespace se::test {
namespace {

PointSet lookedAt() { return prepare(findScene("torus")->build(), {}).value().points; }

/// A program that keeps what it is called with: the session and its points.
std::filesystem::path keepingViewer(const TemporaryFolder& folder) {
    const std::filesystem::path program = folder / "keep it.sh";
    std::ofstream(program) << "#!/bin/sh\ncp \"$1\" \"$(dirname \"$1\")/points.ply\" '"
                           << program.parent_path().string() << "'\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
}

}  // namespace

TEST_CASE("look opens the viewer on points that give the same run, at the same pivot") {
    const TemporaryFolder folder;
    const PointSet points = lookedAt();
    Params params = *paramsByName("robust");
    params.maxFillLength = 33;
    Stepper stepper(points, params);
    stepper.runUntil([](const State& s) { return s.counters.pivots == 137; });
    REQUIRE(look(stepper, keepingViewer(folder).string()));

    const auto file = readPoints(folder / "points.ply");
    REQUIRE(file);
    PrepareOptions options;
    options.neighbors.dropOpposingNormals = false;
    const auto again = prepare(file.value(), options);
    REQUIRE(again);
    Stepper other(again.value().points, params);
    other.run();
    stepper.run();
    CHECK(other.state().mesh() == stepper.state().mesh());
    const std::string text = readBytes(folder / "run.sesession").value();
    CHECK(text.find("\"address\": \"137\"") != std::string::npos);
    CHECK(text.find("\"filllength\": 33") != std::string::npos);
    CHECK(text.find("\"flip\": true") != std::string::npos);
}

TEST_CASE("a session of look holds what-ifs and a given start") {
    Params params = *paramsByName("paper");
    params.whatIf.push_back(whatIfFromText("20.sphere keep 38").value());
    params.start = startOfScene("figure-3");
    const std::string text = sessionText(params, "points.ply", 0);
    CHECK(text.find("\"what_if\": [\"20.sphere keep 38\"]") != std::string::npos);
    CHECK(text.find("\"triangles\": [[0, 2, 5], [0, 5, 6], [0, 6, 1]]") != std::string::npos);
    CHECK(text.find("\"rings\": [[0, 2, 5, 6, 1]]") != std::string::npos);
}

TEST_CASE("look fails with the name of a viewer that is not there") {
    const PointSet points = lookedAt();
    const Stepper stepper(points, *paramsByName("paper"));
    const Status looked = look(stepper, "no-such-viewer");
    REQUIRE_FALSE(looked);
    CHECK(looked.error().message.find("no-such-viewer") != std::string::npos);
}

}  // namespace se::test
