/// The view and its tools under the mouse: camera, selection, a dragged point, a piece, the
/// section.
#include <doctest/doctest.h>

#include <fstream>

#include "driven_app.h"
#include "open_session.h"
#include "point_files.h"
#include "run/strings.h"
#include "scene/framing.h"
#include "session/playback.h"
#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;

namespace {

/// The place of a point in the view.
glm::vec2 placeOf(DrivenApp& app, Index point) {
    const Rect view = app.app.areas().view;
    const CameraMatrices camera = app.app.camera().matrices(view.size.x / view.size.y);
    return view.min + glm::vec2(project(camera, app.session.shown().place[point], view.size));
}

}  // namespace

TEST_CASE("The view orbits, pans and zooms by the mouse, and only a click selects") {
    DrivenApp app({"scene:sphere", "--goto", "40"});
    if (!app) return;
    const glm::vec2 at = app.in("region view", 0.2F, 0.2F);
    for (const int button : {0, 1, 2}) {
        const CameraPose before = app.pose();
        app.drag(at, {50, 20}, button);
        CHECK_FALSE(app.pose() == before);
    }
    const CameraPose before = app.pose();
    app.wheel(at, 1.0F);
    CHECK(app.pose().distance < before.distance);
    CHECK(app.address() == "40.advance.1");
    CHECK(app.session.selected() == kNone);
    // F frames the pivot; a click there selects it, and stepping keeps it.
    app.press("Enter F");
    app.click(placeOf(app, app.session.picture().pivot));
    const Index point = app.session.selected();
    CHECK(point != kNone);
    app.press("F10 F10");
    CHECK(app.session.selected() == point);
    app.press("Esc");
    app.drag(app.in("region view"), {90, 40});
    CHECK(app.session.selected() == kNone);
    // Beside the surface there is nothing to select.
    app.press("Enter");
    app.click(app.in("region view", 0.03F, 0.06F));
    CHECK(app.session.selected() == kNone);
    // A neighbor of the pivot is highlighted under the pointer.
    app.press("F");
    const Index pivot = app.session.picture().pivot;
    app.moveTo(placeOf(app, app.session.model().points.neighbors[pivot][0]));
    CHECK(app.session.highlights().hovered() != kNone);
    // A click on an end of an axis looks from there.
    app.press("Enter");
    app.clickOn("axis z");
    CHECK(app.pose().pitchDegrees == doctest::Approx(90.0F));
    app.clickOn("axis z");
    app.clickOn("axis y");
    CHECK(app.pose().pitchDegrees != doctest::Approx(90.0F));
}

TEST_CASE("The legend has what is in the picture, no more") {
    DrivenApp app({"scene:sphere", "--goto", "40"});
    if (!app) return;
    for (const char* name : {"legend pivot", "legend UNUSED", "legend edge ring"})
        CHECK(app.shows(name));
    CHECK_FALSE(app.shows("legend circumsphere"));
    app.goTo("40.sphere.1");
    CHECK(app.shows("legend circumsphere"));
    app.press("Home");
    for (const char* name : {"legend pivot", "legend rejected", "legend DONE", "legend edge ring",
                             "legend circumsphere"}) {
        CHECK_FALSE(app.shows(name));
    }
    CHECK(app.shows("legend UNUSED"));
}

TEST_CASE("What is kept from step to step is what would be drawn") {
    DrivenApp app({"scene:sphere", "--goto", "60"});
    if (!app) return;
    const Picture direct = app.picture();
    app.press("F10 F10 F10 Shift+F10 Shift+F10 Shift+F10");
    CHECK(app.picture().rgba == direct.rgba);
    app.press("F10 F10");
    const Picture stepped = app.picture();
    app.press("5 5");
    CHECK(app.picture().rgba == stepped.rgba);
}

TEST_CASE("F goes to the view of a decision, Follow to each one, a swing ends where it began") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    const CameraPose opened = app.pose();
    app.press("Enter");
    CHECK_FALSE(app.pose() == opened);
    app.press("F");
    const CameraPose best = app.pose();
    CHECK(best == opened);
    app.press("F F11 F11 F10");  // without Follow the camera never moves by itself
    CHECK(app.pose() == best);
    app.press("Shift+V");
    CHECK(app.ui.follow == Follow::EachDecision);
    CameraPose here = app.pose();
    CHECK_FALSE(here == best);
    app.goTo("139.sphere.1");
    CHECK_FALSE(app.pose() == here);
    here = app.pose();
    app.press("F11");  // the same pivot, seen from the same side
    CHECK(app.pose() == here);
    const std::string undo = app["undo"];
    app.goTo("145.sphere.1");
    CHECK(app["undo"] == undo);
    // A drag wins over the move.
    app.drag(app.in("region view", 0.2F, 0.8F), {60, 20});
    here = app.pose();
    app.press("F11 Shift+V F10");
    CHECK(app.pose() == here);
    const std::string depth = app["undo"];
    app.press("V");
    CHECK(app.pose() == here);
    CHECK(app["undo"] == depth);
    for (const bool follows : {true, false}) {  // Present, Debug
        app.press("F2");
        CHECK((app.ui.follow == Follow::EachDecision) == follows);
    }
}

TEST_CASE("Playing leads the camera to a pivot that leaves the view, not against the user") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    Playback& playback = app.app.context().playback;
    playback.setRate(4.0);
    const CameraPose opened = app.pose();
    const auto seen = [&] {
        const glm::vec3& pivot = app.session.model().place[app.session.picture().pivot];
        return isInView(pivot, app.ui.viewPart(), app.app.camera());
    };
    constexpr int kFrames = 300;
    const auto play = [&] {
        app.goTo("137.sphere.1");
        app.app.camera().setPose(opened);
        app.frames(1);
        playback.play();
        int frames = 0;
        for (int i = 0; i < kFrames; ++i) {
            app.frames(1);
            frames += seen() ? 1 : 0;
        }
        playback.pause();
        app.settle();
        return frames;
    };
    const std::string undo = app["undo"];
    CHECK(play() > 3 * kFrames / 5);
    CHECK_FALSE(app.pose().target == opened.target);
    CHECK(app.pose().distance == opened.distance);
    // While a button is held, the view is the user's.
    app.moveTo(app.in("region view", 0.2F, 0.8F));
    app.hold(0, true);
    CHECK(play() < kFrames / 2);
    CHECK(app.pose() == opened);
    app.hold(0, false);
    app.press("Esc Shift+V Shift+V");
    CHECK(app.ui.follow == Follow::Never);
    CHECK(play() < kFrames / 2);
    CHECK(app.pose() == opened);
}

TEST_CASE("A jump frames a decision whose pivot is outside of the view, others leave the camera") {
    DrivenApp app({"scene:torus", "--goto", "50%"});
    if (!app) return;
    const auto seen = [&] {
        const glm::vec3& pivot = app.session.model().place[app.session.picture().pivot];
        return isInView(pivot, app.ui.viewPart(), app.app.camera());
    };
    const CameraPose away = app.pose();
    const auto jumps = [&](const auto& jump) {
        app.app.camera().setPose(away);
        jump();
        CHECK(seen());
        CHECK_FALSE(app.pose() == away);
    };
    jumps([&] { app.goTo("137.sphere.3"); });
    const CameraPose near = app.pose();
    app.goTo("137.sphere.1");
    app.press("F10");
    CHECK(app.pose() == near);
    jumps([&] { app.press("F9 Home F5"); });
    app.goTo("50%");
    jumps([&] { app.press("Alt+Left"); });
}

TEST_CASE("End shows all of the mesh where the camera was led to a decision, not by the user") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    const CameraPose opened = app.pose();
    const std::string undo = app["undo"];
    app.press("End");
    const CameraPose all = app.pose();
    CHECK(all.distance > 2.0F * opened.distance);
    CHECK(app["undo"] == undo);
    app.press("Shift+F");
    CHECK(std::abs(app.pose().distance / all.distance - 1.0F) < 0.15F);
    app.press("Alt+Left F");
    app.drag(app.in("region view", 0.2F, 0.8F), {60, 20});
    const CameraPose own = app.pose();
    app.press("End");
    CHECK(app.pose() == own);
}

TEST_CASE("The section opens by its key, and is turned by keys and by a drag") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    app.press("R");
    CHECK(app["part"] == "Section");
    CHECK(app.ui.section.turnDegrees == 15.0);
    app.press("R");
    CHECK(app.ui.section.turnDegrees == 30.0);
    app.drag(app.in("section"), {32, 0});
    CHECK(app.ui.section.turnDegrees != 30.0);
}

TEST_CASE("A point is dragged while What if is open: Esc takes it back, the release is a what-if") {
    DrivenApp app({"scene:torus", "--goto", "60.sphere.1"});
    if (!app) return;
    app.press("F");
    const Index point = 414;  // the one under test
    // As long as the panel is closed a press there turns the view.
    CameraPose pose = app.pose();
    app.drag(placeOf(app, point), {40, 0});
    CHECK_FALSE(app.pose() == pose);
    CHECK(app["what_if"] == "[]");
    app.press("Ctrl+Z");
    CHECK(app.pose() == pose);
    app.part("What if");
    app.press("F");
    pose = app.pose();
    const glm::vec2 at = placeOf(app, point);
    const std::string decision = app["decision"];
    const auto hold = [&] {
        app.moveTo(at);
        app.hold(0, true);
        app.moveTo(at + glm::vec2(30, 10));
        app.moveTo(at + glm::vec2(60, 20));
        app.settle();
        CHECK(app["dragged"] == "414");
    };
    hold();
    CHECK(app["decision"] != decision);
    CHECK(app.pose() == pose);
    CHECK(app.session.selected() == point);
    app.press("Esc");
    CHECK(app["dragged"] == "null");
    CHECK(app["decision"] == decision);
    app.moveTo(at + glm::vec2(90, 20));
    app.hold(0, false);
    app.settle();
    CHECK(app["what_if"] == "[]");
    CHECK(app.pose() == pose);
    hold();
    app.hold(0, false);
    app.settle();
    CHECK(app["dragged"] == "null");
    CHECK(app["what_if"].starts_with("[\"60 move 414 "));
    CHECK(app.session.record().pivot == 60);
    app.press("Ctrl+Z");
    CHECK(app["what_if"] == "[]");
    app.click(at);
    CHECK(app.session.selected() == point);
    CHECK(app["what_if"] == "[]");
}

TEST_CASE("A piece is chosen by a box or a lasso, left out or kept alone, and comes back") {
    const test::OwnFolder folder;
    const std::string points =
        test::writePoints(folder / "sphere.xyz", findScene("sphere")->build());
    DrivenApp app({points});
    if (!app) return;
    const std::string all = app["points"];
    app.command("lasso");
    CHECK(app.ui.piece.on);
    CameraPose pose = app.pose();
    // Below the plate of the tool.
    const auto dragBox = [&] {
        app.drag(app.in("region view") + glm::vec2(60, -80), {190, 230});
        return app.ui.piece.inside.size();
    };
    const std::size_t inside = dragBox();
    CHECK(inside > 0);
    CHECK(app.pose() == pose);
    CHECK(app["marked"] == std::to_string(inside));
    // Ctrl with a drag turns the view. The points stay marked.
    app.holdCtrl(true);
    app.drag(app.in("region view"), {30, 0});
    app.holdCtrl(false);
    CHECK_FALSE(app.pose() == pose);
    CHECK(app.ui.piece.inside.size() == inside);
    CHECK(app.ui.breakpoints.empty());
    // Esc ends the tool; its key begins it again, empty; with nothing inside nothing is run.
    app.press("Esc");
    CHECK_FALSE(app.ui.piece.on);
    CHECK(app["marked"] == "0");
    app.press("X");
    CHECK(app.ui.piece.inside.empty());
    app.press("Delete");
    CHECK(app["notice"].starts_with("No points are inside"));
    CHECK(app["points"] == all);

    const std::size_t out = dragBox();
    pose = app.pose();
    app.press("Delete");
    CHECK(app["points"] == std::to_string(std::stoul(all) - out));
    CHECK(app["aside"] == "{\"left_out\":" + std::to_string(out) + "}");
    CHECK(app.session.atEnd());
    CHECK(app.pose() == pose);
    CHECK(app["message"].starts_with("Left out: "));
    app.press("Ctrl+Z");
    CHECK(app["points"] == all);
    app.press("Ctrl+Y");
    CHECK(app["points"] != all);
    // No command line makes that; the mesh has the indices of the file.
    app.command("copy command");
    CHECK(app["message"].starts_with("There is no command for points left out"));
    app.press("Ctrl+E Ctrl+A");
    app.type((folder / "rest.ply").string());
    app.press("Enter");
    std::ifstream saved(folder / "rest.ply", std::ios::binary);
    const std::string head(std::istreambuf_iterator<char>(saved), {});
    CHECK(head.find("property uint index") != std::string::npos);
    CHECK(head.find("element vertex " + app["points"] + "\n") != std::string::npos);
    app.command("doctor");
    app.clickOn("show left_out");
    app.clickOn("return left_out");
    CHECK(app["points"] == all);
    // A line, by its button: kept alone.
    app.press("X Ctrl+Shift+J");
    app.clickOn("piece lasso");
    glm::vec2 at = app.in("region view") - glm::vec2(60, 60);
    app.moveTo(at);
    app.hold(0, true);
    for (const glm::vec2 by : {glm::vec2(120, 0), glm::vec2(0, 120), glm::vec2(-120, 0)}) {
        app.moveTo(at += by);
    }
    app.hold(0, false);
    const std::string kept = app["piece_inside"];
    CHECK(kept != "0");
    app.clickOn("piece keep");
    CHECK(app["points"] == kept);
    CHECK_FALSE(app.ui.piece.on);
    CHECK(app.session.atEnd());
}

TEST_CASE("Every mesh style looks different from the others") {
    DrivenApp app({"scene:sphere", "--goto", "100%"});
    if (!app) return;
    CHECK(app["mesh_style"] == "faults");
    app.press("M");
    const Picture flat = app.picture();
    for (const char* style : {"shaded", "wire", "birth", "component", "faults"}) {
        app.press("M");
        CHECK(app["mesh_style"] == style);
        // The mesh is sound.
        if (std::string(style) != "faults") CHECK(differing(flat, app.picture()) > 500);
    }
}

TEST_CASE("A piece that the command line chooses is kept by a session") {
    const test::OwnFolder folder;
    const std::string points = test::writePoints(folder / "sphere.xyz", test::spiralSphere(600));
    const std::string session = (folder / "cut.sesession").string();
    std::string kept;
    {
        DrivenApp app({points, "--crop=-9,-9,0,9,9,9", "--thin", "0.2"});
        if (!app) return;
        kept = app["points"];
        CHECK(std::stoi(kept) < 300);
#ifdef SPIRALING_EDGE_CLI
        const std::string report = (folder / "report.json").string();
        REQUIRE(std::system((SPIRALING_EDGE_CLI " run " + points +
                             " --crop=-9,-9,0,9,9,9 --thin 0.2 -q --report " + report)
                                .c_str()) == 0);
        CHECK(readText(report).value().find("\n  \"points\": " + kept + ",") != std::string::npos);
#endif
        app.save(session);
    }
    DrivenApp again({session});
    CHECK(again["points"] == kept);
}
