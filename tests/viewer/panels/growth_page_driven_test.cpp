/// The page with new points as the mouse and the keyboard reach it.
#include <doctest/doctest.h>

#include <cstdlib>

#include "driven_app.h"
#include "open_session.h"
#include "run/strings.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;
using test::OwnFolder;

TEST_CASE("New points: a shape is clicked, a number typed, and each step moves them in the view") {
    DrivenApp app({"--new", "torus", "--steps", "12"});
    if (!app) return;
    const Picture one = app.picture();
    app.press("Right F10");
    CHECK(differing(one, app.picture()) > 200);
    app.clickOn("shape gyroid");
    CHECK(app["growth_source"].starts_with("sample:gyroid"));
    app.press("End");
    CHECK(app.ui.growth.numbers.onWalls > 50);
    CHECK(app.ui.growth.numbers.quality.variation < 0.10);
    CHECK(app.ui.growth.numbers.quality.off < 0.0001);
    // Enter starts with a typed number, also in the next field without input.
    app.clickOn("shape torus");
    app.clickOn("field Points");
    app.type("700");
    app.press("Tab Enter");
    CHECK(app["growth_points"] == "700");
    app.clickOn("field Isovalue");
    app.type("1000");
    app.press("Enter");
    CHECK(app["growth_complaint"].find("no surface") != std::string::npos);
    app.clickOn("shape torus");
    CHECK(app["growth_points"] == "700");
}

TEST_CASE("New points: saved they are those of the command line, used they are a run") {
    const OwnFolder folder;
    DrivenApp app({"--new", "torus", "-n", "600"});
    if (!app) return;
    app.press("End");
    app.clickOn("growth save");
    app.type((folder / "torus").string());
    app.press("Enter");
    CHECK(app["growth_message"].ends_with("torus.ply."));
#ifdef SPIRALING_EDGE_CLI
    const std::string cli = (folder / "cli.ply").string();
    REQUIRE(std::system((SPIRALING_EDGE_CLI " sample torus -n 600 -q -o " + cli).c_str()) == 0);
    CHECK(readText(cli) == readText(folder / "torus.ply"));
#endif
    app.clickOn("growth use");
    CHECK_FALSE(app.ui.growth.open);
    CHECK(app["title"].find("torus, 600") != std::string::npos);
    app.press("F10 Ctrl+N");
    CHECK(app.ui.growth.open);
    app.press("Esc");
    CHECK(app.session.record().pivot == 1);
}
