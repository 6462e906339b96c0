#include "scene/camera.h"

#include <doctest/doctest.h>

#include <cmath>

#include "document/actions.h"
#include "headless_app.h"
#include "session/playback.h"

using namespace se;
using namespace se::view;

namespace {

/// Points of a stretched ball, without a flat part.
PointSet ball(const Vec3& stretched) {
    PointSet points;
    for (int i = 0; i < 600; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / 600.0;
        const double turn = 2.399963 * i;
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 on(r * std::cos(turn), r * std::sin(turn), z);
        points.position.push_back(on * stretched);
        points.normal.push_back(glm::normalize(on / stretched));
        points.type.push_back(kInterior);
    }
    return points;
}

/// Points of a stretched ball, cut off flat at the low end of an axis.
PointSet resting(int axis) {
    PointSet points = ball(Vec3(1.0));
    for (std::size_t i = 0; i < points.position.size(); ++i) {
        double& height = points.position[i][axis];
        if (height > -0.8) continue;
        height = -0.8;
        points.normal[i] = Vec3(0.0);
        points.normal[i][axis] = -1.0;
    }
    return points;
}

}  // namespace

TEST_CASE("Up axis: the names are read and written") {
    for (const UpAxis axis : {UpAxis::X, UpAxis::Y, UpAxis::Z})
        CHECK(upAxisFromName(upAxisName(axis)) == axis);
    CHECK_FALSE(upAxisFromName("up").has_value());
}

TEST_CASE("Up axis: an object with a flat side rests on it, in any format") {
    for (const char* file : {"scan.ply", "scan.xyz"}) {
        CAPTURE(file);
        CHECK(guessUpAxis(resting(0), file) == UpAxis::X);
        CHECK(guessUpAxis(resting(1), file) == UpAxis::Y);
        CHECK(guessUpAxis(resting(2), file) == UpAxis::Z);
    }
}

TEST_CASE("Up axis: a plate lies on its side, a bar does not") {
    CHECK(guessUpAxis(ball({1.0, 0.9, 0.25}), "relief.ply") == UpAxis::Z);
    CHECK(guessUpAxis(ball({0.25, 0.9, 1.0}), "relief.xyz") == UpAxis::X);
    CHECK(guessUpAxis(ball({0.2, 0.3, 1.0}), "bar.ply") == UpAxis::Y);
}

TEST_CASE("Up axis: without a flat side the convention of the format decides") {
    const PointSet points = ball(Vec3(1.0));
    for (const char* file : {"a.ply", "a.obj", "A.OBJ", "a.stl", "a.off"}) {
        CAPTURE(file);
        CHECK(guessUpAxis(points, file) == UpAxis::Y);
    }
    CHECK(guessUpAxis(points, "a.xyz") == UpAxis::Z);
    CHECK(guessUpAxis(points, "a.pcd") == UpAxis::Z);
    CHECK(guessUpAxis({}, "empty.ply") == UpAxis::Y);
}

TEST_CASE("Up axis: z for points with walls, scenes and sampled points") {
    PointSet points = resting(1);
    CHECK(guessUpAxis(points, "scene:sphere") == UpAxis::Z);
    CHECK(guessUpAxis(points, "sample:torus,n=400") == UpAxis::Z);
    points.type[7] = kPositiveX;
    CHECK(guessUpAxis(points, "walls.ply") == UpAxis::Z);
}

TEST_CASE("Up axis: chosen by a command, kept for other files, and reset to the guess") {
    test::OpenSession open;
    test::AroundSession around(open.session);
    Camera& camera = around.camera;
    UiState& ui = around.ui;
    CommandContext& context = around.context;
    const auto run = [&](const char* id) { findCommand(id)->run(context); };
    run("view.up.y");
    CHECK(camera.up() == UpAxis::Y);
    CHECK(ui.settings.up == UpAxis::Y);
    // Scenes have z up when they are opened without a choice.
    CHECK(actions::usualUp(context) == UpAxis::Z);
    run("view.up.x");
    CHECK(camera.up() == UpAxis::X);
    run("view.up.auto");
    CHECK(camera.up() == UpAxis::Z);
    CHECK_FALSE(ui.settings.up.has_value());
}
